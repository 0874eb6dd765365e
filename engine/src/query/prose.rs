//! Texts outside of formulas, and letters, as LaTeX.

use crate::syntax::GREEK;

/// A letter in math mode.
pub(super) fn letter(c: char) -> String {
    let Some((word, _)) = GREEK.iter().find(|(_, greek)| greek.starts_with(c)) else {
        return match c {
            'ϕ' => String::from("\\phi"),
            'ϑ' => String::from("\\vartheta"),
            'ϵ' => String::from("\\epsilon"),
            'ℓ' => String::from("\\ell"),
            c if c.is_ascii() => c.to_string(),
            // What LaTeX without further packages does not have.
            c => format!("\\mathrm{{u{:x}}}", c as u32),
        };
    };
    if *word == "omicron" { String::from("o") } else { format!("\\{word} ").trim_end().to_string() }
}

/// What a raised character stands for, `2` for `²`.
fn raised(c: char) -> Option<char> {
    match c {
        '¹' => Some('1'),
        '²' => Some('2'),
        '³' => Some('3'),
        'ⁱ' => Some('i'),
        'ⁿ' => Some('n'),
        '⁺' => Some('+'),
        '⁻' => Some('-'),
        '⁰' | '⁴'..='⁹' => char::from_digit(c as u32 - '⁰' as u32, 10),
        _ => None,
    }
}

/// What a lowered character stands for, `2` for `₂`.
fn lowered(c: char) -> Option<char> {
    match c {
        'ᵢ' => Some('i'),
        'ⱼ' => Some('j'),
        'ₖ' => Some('k'),
        'ₙ' => Some('n'),
        '₊' => Some('+'),
        '₋' => Some('-'),
        '₀'..='₉' => char::from_digit(c as u32 - '₀' as u32, 10),
        _ => None,
    }
}

/// A text outside of formulas.
pub fn escape(text: &str) -> String {
    let mut latex = String::new();
    let (mut code, mut quoted) = (false, false);
    for c in text.chars() {
        match c {
            '`' => {
                latex += if code { "}" } else { "\\texttt{" };
                code = !code;
            }
            '\\' => latex += "\\textbackslash{}",
            '&' | '%' | '$' | '#' | '_' | '{' | '}' => {
                latex.push('\\');
                latex.push(c);
            }
            '^' => latex += "\\^{}",
            '~' => latex += "\\~{}",
            '"' => {
                latex += if quoted { "''" } else { "``" };
                quoted = !quoted;
            }
            '<' => latex += "$<$",
            '>' => latex += "$>$",
            '|' => latex += "$|$",
            '≤' => latex += "$\\le$",
            '≥' => latex += "$\\ge$",
            '≠' => latex += "$\\ne$",
            '−' => latex += "$-$",
            '·' => latex += "$\\cdot$",
            '√' => latex += "$\\surd$",
            '∞' => latex += "$\\infty$",
            '→' => latex += "$\\to$",
            '′' => latex += "$'$",
            '″' => latex += "$''$",
            '×' => latex += "$\\times$",
            '±' => latex += "$\\pm$",
            '°' => latex += "$^\\circ$",
            '∈' => latex += "$\\in$",
            '∂' => latex += "$\\partial$",
            '∫' => latex += "$\\int$",
            '∑' => latex += "$\\sum$",
            '∏' => latex += "$\\prod$",
            '≈' => latex += "$\\approx$",
            '≡' => latex += "$\\equiv$",
            '…' => latex += "\\dots{}",
            '–' => latex += "--",
            '—' => latex += "---",
            c if raised(c).is_some() => latex += &format!("$^{{{}}}$", raised(c).unwrap_or(c)),
            c if lowered(c).is_some() => latex += &format!("$_{{{}}}$", lowered(c).unwrap_or(c)),
            '‘' => latex += "`",
            '’' => latex += "'",
            '“' => latex += "``",
            '”' => latex += "''",
            '\n' => latex.push('\n'),
            c if c.is_ascii() && !c.is_control() => latex.push(c),
            c if GREEK.iter().any(|(_, greek)| greek.starts_with(c)) => latex += &format!("${}$", letter(c)),
            // Letters of Western languages are known to LaTeX as they are.
            c if c.is_alphabetic() && (c as u32) < 0x180 => latex.push(c),
            c if c.is_whitespace() => latex.push(' '),
            c => latex += &format!("U+{:04X}", c as u32),
        }
    }
    if code {
        latex.push('}');
    }
    latex
}
