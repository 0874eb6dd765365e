//! Names in ASCII, as every language has them, and in small letters.

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

/// The small letter of a Latin or Greek one; others as they are. The standard library's tables of all alphabets would
/// be a hundredth of what everyone loads who opens the page.
fn small(c: char) -> char {
    match c {
        'Α'..='Ω' => char::from_u32(c as u32 + ('α' as u32 - 'Α' as u32)).unwrap_or(c),
        _ => c.to_ascii_lowercase(),
    }
}

/// A name in small letters, Latin and Greek.
pub(crate) fn lowercase(name: &str) -> String {
    name.chars().map(small).collect()
}

/// Whether a name begins with a capital letter, Latin or Greek.
pub(crate) fn is_capitalised(name: &str) -> bool {
    name.starts_with(|c| small(c) != c)
}

/// The name in ASCII: `λ1` becomes `lambda1`, other letters become their code.
pub fn ascii(name: &str) -> String {
    let mut result = String::new();
    for c in name.chars() {
        let lower = small(c);
        match LOWER
            .iter()
            .find(|(g, _)| *g == lower || matches!((g, c), ('ε', 'ϵ') | ('θ', 'ϑ') | ('φ', 'ϕ')))
        {
            Some((_, word)) if lower == c => result += word,
            Some((_, word)) => {
                result += &word[..1].to_ascii_uppercase();
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
    use super::{ascii, is_capitalised, lowercase};

    #[test]
    fn greek_becomes_ascii() {
        assert_eq!(ascii("λ1"), "lambda1");
        assert_eq!(ascii("Δ_x"), "Delta_x");
        assert_eq!(ascii("ϕ"), "phi");
        assert_eq!(ascii("é"), "ue9");
    }

    #[test]
    fn capital_letters_are_latin_and_greek() {
        assert_eq!(lowercase("ΑΩ_Sin2ϑ"), "αω_sin2ϑ");
        assert!(
            is_capitalised("Λ1") && is_capitalised("Lambda") && !is_capitalised("λ") && !is_capitalised("_L")
        );
    }
}
