//! Names in ASCII, as every language has them.

const LOWER: [(char, &str); 25] = [
    ('α', "alpha"),
    ('β', "beta"),
    ('γ', "gamma"),
    ('δ', "delta"),
    ('ε', "epsilon"),
    ('ζ', "zeta"),
    ('η', "eta"),
    ('θ', "theta"),
    ('ι', "iota"),
    ('κ', "kappa"),
    ('λ', "lambda"),
    ('μ', "mu"),
    ('ν', "nu"),
    ('ξ', "xi"),
    ('ο', "omicron"),
    ('π', "pi"),
    ('ρ', "rho"),
    ('σ', "sigma"),
    ('ς', "sigma"),
    ('τ', "tau"),
    ('υ', "upsilon"),
    ('φ', "phi"),
    ('χ', "chi"),
    ('ψ', "psi"),
    ('ω', "omega"),
];

/// The name in ASCII: `λ1` becomes `lambda1`, other letters become their code.
pub fn ascii(name: &str) -> String {
    let mut result = String::new();
    for c in name.chars() {
        let lower = c.to_lowercase().next().unwrap_or(c);
        match LOWER
            .iter()
            .find(|(g, _)| *g == lower || matches!((g, c), ('ε', 'ϵ') | ('θ', 'ϑ') | ('φ', 'ϕ')))
        {
            Some((_, word)) if lower == c || !c.is_uppercase() => result += word,
            Some((_, word)) => {
                result += &word[..1].to_uppercase();
                result += &word[1..];
            }
            None if c.is_ascii() => result.push(c),
            None => result += &format!("u{:x}", c as u32),
        }
    }
    result
}

#[cfg(test)]
mod tests {
    use super::ascii;

    #[test]
    fn greek_becomes_ascii() {
        assert_eq!(ascii("λ1"), "lambda1");
        assert_eq!(ascii("Δ_x"), "Delta_x");
        assert_eq!(ascii("ϕ"), "phi");
        assert_eq!(ascii("é"), "ue9");
    }
}
