//! The names of a spec with their places: what is declared, where it is visible, and where it is named.

use core::ops::Range;

use super::lex::Token;

/// A text with its tokens and names.
#[derive(Clone, Debug, Default)]
pub struct Document {
    /// The text.
    pub text: String,
    /// Its tokens, comments included.
    pub tokens: Vec<Token>,
    /// What it declares, in the order of the text.
    pub symbols: Vec<Symbol>,
    /// Every place at which a name stands, in the order of the text.
    pub occurrences: Vec<Occurrence>,
    /// The items and their statements, in the order of the text.
    pub entries: Vec<Entry>,
    /// The specs that it uses.
    pub imports: Vec<Import>,
}

/// Something with a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Symbol {
    /// The name.
    pub name: String,
    /// What it is.
    pub kind: SymbolKind,
    /// Where the name is declared.
    pub place: Range<usize>,
    /// Where it can be named.
    pub scope: Range<usize>,
    /// The statement that declares it, or the whole item.
    pub whole: Range<usize>,
    /// The doc comment before it, without its slashes.
    pub doc: String,
}

/// The kinds of symbols.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SymbolKind {
    /// A family of basis functions.
    Family,
    /// A theorem.
    Theorem,
    /// A join.
    Join,
    /// The basis functions of a family, which share their name.
    Functions,
    /// A domain variable.
    Domain,
    /// A shape parameter.
    Shape,
    /// An index parameter of a family.
    Order,
    /// An index variable of a loop, or an argument of a name.
    Index,
    /// A name for an expression.
    Let,
    /// A curve or surface of a theorem.
    Patch,
    /// A scalar of a theorem.
    Scalar,
}

/// A place at which a name stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Occurrence {
    /// The bytes of the name.
    pub range: Range<usize>,
    /// The symbol, a position in [`Document::symbols`]; nothing for a name that is declared in another spec, or
    /// nowhere.
    pub symbol: Option<usize>,
    /// Whether it is declared here.
    pub role: Role,
}

/// What a name does at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// It is declared.
    Declared,
    /// It is named.
    Named,
}

/// An item, or a statement of one, for an outline.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// The name, or the statement on one line.
    pub title: String,
    /// What an item or statement declares; nothing for a claim.
    pub symbol: Option<usize>,
    /// All of it, without its doc comment.
    pub whole: Range<usize>,
    /// Its name, or its first word.
    pub name: Range<usize>,
    /// Of an item, what stands between its braces; of a claim with a block, what stands between those.
    pub body: Option<Range<usize>>,
    /// The statements of an item.
    pub children: Vec<Entry>,
}

/// `use "…";` or `use library "…";`
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Import {
    /// The path or the name in the library.
    pub path: String,
    /// Whether it is a name in the library.
    pub library: bool,
    /// Where the path stands, quotation marks included.
    pub place: Range<usize>,
}

impl Document {
    /// The name at a position, or next to it.
    pub fn at(&self, offset: usize) -> Option<&Occurrence> {
        let next = self.occurrences.partition_point(|o| o.range.end < offset);
        self.occurrences[next..].iter().take(2).rfind(|o| o.range.start <= offset && offset <= o.range.end)
    }

    /// The token at a position, of two neighbours the later one.
    pub fn token(&self, offset: usize) -> Option<&Token> {
        let next = self.tokens.partition_point(|t| t.range.end < offset);
        self.tokens[next..].iter().take(2).rfind(|t| t.range.start <= offset && offset <= t.range.end)
    }

    /// All places at which a symbol is declared or named.
    pub fn places(&self, symbol: usize) -> impl Iterator<Item = &Occurrence> {
        self.occurrences.iter().filter(move |o| o.symbol == Some(symbol))
    }

    /// The symbols that can be named at a position.
    pub fn visible(&self, offset: usize) -> impl Iterator<Item = &Symbol> {
        self.symbols.iter().filter(move |s| s.scope.start <= offset && offset <= s.scope.end)
    }

    /// The family, theorem or join of this name.
    pub fn item(&self, name: &str) -> Option<usize> {
        self.symbols.iter().position(|s| s.name == name && s.kind.is_item())
    }

    /// The item around a position.
    pub fn entry(&self, offset: usize) -> Option<&Entry> {
        around(&self.entries, offset)
    }

    /// What stands at some bytes.
    pub fn slice(&self, range: &Range<usize>) -> &str {
        self.text.get(range.clone()).unwrap_or_default()
    }
}

impl Entry {
    /// The statement of an item around a position.
    pub fn statement(&self, offset: usize) -> Option<&Self> {
        around(&self.children, offset)
    }
}

/// Which of several neighbours stands around a position.
fn around(entries: &[Entry], offset: usize) -> Option<&Entry> {
    let next = entries.partition_point(|e| e.whole.start <= offset);
    entries[..next].last().filter(|e| offset <= e.whole.end)
}

impl SymbolKind {
    /// Whether it stands at the top of a spec.
    pub const fn is_item(self) -> bool {
        matches!(self, Self::Family | Self::Theorem | Self::Join)
    }

    /// What it is called.
    pub const fn noun(self) -> &'static str {
        match self {
            Self::Family => "family",
            Self::Theorem => "theorem",
            Self::Join => "join",
            Self::Functions => "basis functions",
            Self::Domain => "domain variable",
            Self::Shape => "shape parameter",
            Self::Order => "index parameter",
            Self::Index => "index variable",
            Self::Let => "name",
            Self::Patch => "curve or surface",
            Self::Scalar => "scalar",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPEC: &str = "\
use \"other.basis\";
use library \"bspline\";

/// A family.
family F(n in 1..=3) {
    domain 0 <= t <= 1;
    /// How strong.
    shape -3 <= λ <= 1, 0 <= μ;
    let c = 1 + λ; // c
    b[i] = c*t^i for i in 0..n;
    b[n] = sum(μ^i for i in 0..=n) - n;
    prove at t = 0, λ = 1 {
        b[i] = Other(n)[i] for i in 0..n;
    }
}

join G1 {
    curve P = F(2)(λ1, 0);
    curve Q = CubicBSpline;
    scalar 0 < δ;
    let Q[0] = δ*P[2] + λ1*P[1];
    let m = Q[0] - P[0];
    prove Q(0) == m;
}
";

    /// What the name at the first place of some text means: its kind, and the line of its declaration.
    fn meaning(document: &Document, before: &str, name: &str) -> Option<(SymbolKind, usize)> {
        let at = document.text.find(before).expect("the text is there");
        let at = at + document.text[at..].find(name).expect("the name is there");
        let symbol = &document.symbols[document.at(at)?.symbol?];
        assert_eq!(symbol.name, name);
        Some((symbol.kind, document.text[..symbol.place.start].matches('\n').count() + 1))
    }

    #[test]
    fn names_know_where_they_are_declared() {
        let document = Document::new(SPEC);
        let of = |before, name| meaning(&document, before, name);
        assert_eq!(of("1 + λ", "λ"), Some((SymbolKind::Shape, 8)));
        assert_eq!(of("(μ^i", "μ"), Some((SymbolKind::Shape, 8)));
        assert_eq!(of("c*t^i", "c"), Some((SymbolKind::Let, 9)));
        assert_eq!(of("c*t^i", "t"), Some((SymbolKind::Domain, 6)));
        assert_eq!(of("c*t^i", "i"), Some((SymbolKind::Index, 10)));
        assert_eq!(of("(μ^i", "i"), Some((SymbolKind::Index, 11)));
        assert_eq!(of("- n;", "n"), Some((SymbolKind::Order, 5)));
        assert_eq!(of("at t = 0, λ", "λ"), Some((SymbolKind::Shape, 8)));
        assert_eq!(of("b[i] = Other", "b"), Some((SymbolKind::Functions, 10)));
        assert_eq!(of("b[i] = Other", "i"), Some((SymbolKind::Index, 13)));
        assert_eq!(of("= F(2)", "F"), Some((SymbolKind::Family, 5)));
        assert_eq!(of("λ1*P", "λ1"), Some((SymbolKind::Scalar, 18)));
        assert_eq!(of("let Q[0] =", "Q"), Some((SymbolKind::Patch, 19)));
        assert_eq!(of("== m", "m"), Some((SymbolKind::Let, 22)));
        let other = document.at(SPEC.find("Other").unwrap()).unwrap();
        assert_eq!((other.symbol, other.role), (None, Role::Named));
    }

    #[test]
    fn an_outline_has_items_and_statements() {
        let document = Document::new(SPEC);
        let titles: Vec<&str> = document.entries[0].children.iter().map(|e| e.title.as_str()).collect();
        assert_eq!(
            titles,
            [
                "domain 0 <= t <= 1",
                "shape -3 <= λ <= 1, 0 <= μ",
                "let c = 1 + λ",
                "b[i] = c*t^i for i in 0..n",
                "b[n] = sum(μ^i for i in 0..=n) - n",
                "prove at t = 0, λ = 1"
            ]
        );
        assert_eq!(document.symbols[document.item("F").unwrap()].doc, "A family.");
        let shape = document.symbols.iter().find(|s| s.name == "λ").unwrap();
        assert_eq!((shape.kind, shape.doc.as_str()), (SymbolKind::Shape, "How strong."));
        assert_eq!(document.imports.len(), 2);
        assert!(document.imports[1].library && document.imports[1].path == "bspline");
    }

    #[test]
    fn every_prefix_of_a_spec_has_names() {
        for (at, _) in SPEC.char_indices() {
            let document = Document::new(&SPEC[..at]);
            assert!(document.occurrences.iter().all(|o| o.range.end <= at));
            assert!(document.entries.iter().flat_map(|e| &e.children).all(|e| e.whole.end <= at));
        }
        // A missing semicolon ends a statement at the next keyword on a line of its own.
        let text = "family F {\n    domain 0 <= t <= 1\n    shape 0 <= λ;\n    b[0] = λ;\n}";
        let document = Document::new(text);
        assert_eq!(document.entries[0].children.len(), 3);
        assert!(document.symbols.iter().any(|s| s.name == "λ" && s.kind == SymbolKind::Shape));
    }
}
