//! Names as they are typed and as they stand in the spec.

use basis_engine::ascii::ascii;
use basis_engine::plural;
pub(crate) use basis_engine::plural::count;

/// Which of the names is meant: the same name, or else the only one with the same spelling in ASCII, such as
/// `lambda1` for `λ1`.
pub(crate) fn position(word: &str, names: &[&str]) -> Option<usize> {
    if let Some(exact) = names.iter().position(|n| *n == word) {
        return Some(exact);
    }
    let spelled = ascii(word);
    let mut same = (0..names.len()).filter(|k| ascii(names[*k]) == spelled);
    same.next().filter(|_| same.next().is_none())
}

/// Which of the names are meant: the one that [`position`] finds, or else all entries of a list, such as `w[1]` and `w[2]`
/// for `w`.
pub(crate) fn positions(word: &str, names: &[&str]) -> Vec<usize> {
    if let Some(k) = position(word, names) {
        return vec![k];
    }
    let stem = |name: &str| name.split_once('[').map(|(stem, _)| ascii(stem));
    (0..names.len()).filter(|k| stem(names[*k]).is_some_and(|stem| stem == ascii(word))).collect()
}

/// Which of the names are meant by each of several words: as [`positions`], where a list without an index is all of it but
/// for the entries that stand among the words themselves. If these are all, none is left out.
pub(crate) fn each_position(words: &[&str], names: &[&str]) -> Vec<Vec<usize>> {
    let own: Vec<usize> = words.iter().filter_map(|word| position(word, names)).collect();
    let meant = |word: &&str| {
        let all = positions(word, names);
        let others = all.iter().copied().filter(|k| !own.contains(k)).collect::<Vec<_>>();
        if others.is_empty() || position(word, names).is_some() { all } else { others }
    };
    words.iter().map(meant).collect()
}

/// The name that differs least from `word`, if it is near enough to be meant.
pub(crate) fn closest<'n>(word: &str, names: &[&'n str]) -> Option<&'n str> {
    basis_engine::closest(word, names).or_else(|| {
        let spelled: Vec<String> = names.iter().map(|n| ascii(n)).collect();
        let spelled: Vec<&str> = spelled.iter().map(String::as_str).collect();
        let near = basis_engine::closest(&ascii(word), &spelled)?;
        let meant = spelled.iter().position(|s| *s == near)?;
        Some(names[meant])
    })
}

/// `a`, `b` and `c`, in the marks of code.
pub(crate) fn list(names: &[&str]) -> String {
    let quoted: Vec<String> = names.iter().map(|n| format!("`{n}`")).collect();
    plural::list(&quoted)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn greek_names_can_be_spelled_out() {
        assert_eq!(position("λ1", &["λ2", "λ1"]), Some(1));
        assert_eq!(position("lambda1", &["λ2", "λ1"]), Some(1));
        assert_eq!(position("lambda", &["λ1"]), None);
        // Both are spelled `lambda`: only the name itself says which one is meant.
        assert_eq!(position("lambda", &["lambda", "λ"]), Some(0));
        assert_eq!(position("λ", &["lambda", "λ"]), Some(1));
        assert_eq!(position("lambda", &["ϕ", "φ", "λ"]), Some(2));
        assert_eq!(position("phi", &["ϕ", "φ", "λ"]), None);
    }

    #[test]
    fn a_list_is_all_of_its_entries() {
        assert_eq!(positions("lambda", &["λ[1]", "μ", "λ[2]"]), [0, 2]);
        assert_eq!(positions("λ[2]", &["λ[1]", "μ", "λ[2]"]), [2]);
        assert_eq!(positions("ν", &["λ[1]", "μ"]), [0; 0]);
    }

    #[test]
    fn finds_what_was_meant() {
        assert_eq!(closest("lamda1", &["λ1", "t"]), Some("λ1"));
        assert_eq!(closest("λ₁", &["λ1", "t"]), Some("λ1"));
        assert_eq!(closest("hermite", &["Hermite"]), Some("Hermite"));
        assert_eq!(closest("x", &["λ1", "t"]), None);
    }
}
