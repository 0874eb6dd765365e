//! The spec language: from text or tokens to a syntax tree with spans.
//!
//! The tree says what was written, not what it means; meaning is the business of `model`.

mod claims;
mod ending;
mod error;
mod expr;
mod glyphs;
mod parse;
mod ranges;
mod statements;
mod theorems;
mod tokens;
mod tree;
mod words;

pub use error::{SyntaxError, SyntaxErrors, SyntaxPlace};
pub use glyphs::GREEK;
pub use parse::{parse_text, parse_tokens};
pub use tree::{Expr, ExprKind, Role, Sign};

use std::rc::Rc;

use proc_macro2::Span;

/// A whole spec.
#[derive(Debug, Default)]
pub struct Spec {
    /// The doc comment of the whole file, `//! …`, one string a line.
    pub doc: Vec<String>,
    /// The items in the order in which they are written.
    pub items: Vec<Item>,
    /// The names in items that could not be read, sorted: what they define is not known.
    pub unread: Vec<String>,
}

/// What stands at the top of a spec.
#[derive(Debug)]
pub enum Item {
    /// `use "other.basis";` or `use library "quartic";`
    Use(Use),
    /// `family Name { … }`
    Family(Family),
    /// `theorem Name { … }` or `join Name { … }`
    Theorem(Theorem),
}

/// The families of another spec are visible here.
#[derive(Debug)]
pub struct Use {
    /// Where the other spec is looked for.
    pub home: Home,
    /// The path, relative to the file that says it, or the name in the library.
    pub path: String,
    /// Where the path stands.
    pub span: Span,
}

/// Where a spec that another one uses is looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Home {
    /// Beside the spec that uses it.
    Folder,
    /// In the library.
    Library,
}

/// A name and where it stands.
#[derive(Clone, Debug)]
pub struct Name {
    /// The name.
    pub text: String,
    /// Where it stands.
    pub span: Span,
}

/// A family of basis functions as it is written.
#[derive(Debug)]
pub struct Family {
    /// The doc comment, one string a line.
    pub doc: Vec<String>,
    /// The name.
    pub name: Name,
    /// The index parameters, `n in 1..=30`.
    pub orders: Vec<IndexRange>,
    /// What stands between the braces.
    pub statements: Vec<Statement>,
    /// Whether a statement about the functions could not be read and is left out.
    pub incomplete: bool,
    /// The names in statements that could not be read, sorted: what they declare is not known.
    pub unread: Vec<String>,
}

/// One statement of a family, with its doc comment.
#[derive(Debug)]
pub struct Statement {
    /// The doc comment, one string a line.
    pub doc: Vec<String>,
    /// The whole statement; of tokens of the compiler the first one.
    pub span: Span,
    /// Its last token.
    pub last: Span,
    /// What it says.
    pub kind: StatementKind,
}

/// The kinds of statements.
#[derive(Debug)]
pub enum StatementKind {
    /// `domain 0 <= u <= 1, 0 <= v <= 1;`
    Domain(Vec<RangeDecl>),
    /// `domain triangle (u, v, w), -1 <= z <= 1;`: a product in which a simplex occurs.
    Product(Vec<Factor>),
    /// `shape -3 <= λ <= 1, 0 <= μ[i] for i in 1..=n;`
    Shape(Vec<ShapeDecl>),
    /// `assume q < p;`: only these shape values count.
    Assume(Relation),
    /// `let c = …;` or `let h(x) = …;`
    Let(NameDef),
    /// `b[i] = … for i in 0..=n;`
    Function(FunctionDef),
    /// `base n = 3 { … }`: the functions of the lowest order.
    Base(Binding, Vec<FunctionDef>),
    /// `raise b[i] = …;`: the functions of one order from those of the order before.
    Raise(FunctionDef),
    /// `prove …;` or `refute …;`
    Claim(Claim),
    /// `budget 10;`: the provers may do ten times the usual work.
    Budget(Expr),
}

/// `let name = value` or `let name(parameters) = value`.
#[derive(Debug)]
pub struct NameDef {
    /// The name.
    pub name: Name,
    /// The names of its arguments; none for a name that stands for one value.
    pub parameters: Vec<Name>,
    /// The value.
    pub value: Expr,
}

/// A name with its range, such as `-3 <= λ < 1`.
#[derive(Debug)]
pub struct RangeDecl {
    /// The name.
    pub name: Name,
    /// The lower end.
    pub low: Option<Limit>,
    /// The upper end.
    pub high: Option<Limit>,
}

/// An end of a range.
#[derive(Debug)]
pub struct Limit {
    /// The number.
    pub value: Expr,
    /// Whether the range contains it.
    pub included: bool,
}

impl ShapeDecl {
    /// The names in the chain, those with an index without it.
    pub fn names(&self) -> Vec<&str> {
        self.parts.iter().filter_map(Expr::named).collect()
    }
}

/// A chain that declares shape parameters, such as `0 < q < p <= 1`.
#[derive(Clone, Debug)]
pub struct ShapeDecl {
    /// What stands in the chain, in ascending order: names, perhaps with an index, and ends of ranges.
    pub parts: Vec<Expr>,
    /// Whether two neighbours may be equal.
    pub included: Vec<bool>,
    /// What the index variables run over.
    pub loops: Loops,
}

/// Claims about curves and surfaces over families, as they are written.
#[derive(Debug)]
pub struct Theorem {
    /// The doc comment, one string a line.
    pub doc: Vec<String>,
    /// Whether it is to become a function.
    pub kind: TheoremKind,
    /// The name.
    pub name: Name,
    /// What stands between the braces.
    pub statements: Vec<TheoremStatement>,
    /// Whether a statement could not be read and is left out.
    pub incomplete: bool,
    /// The names in statements that could not be read, sorted: what they declare is not known.
    pub unread: Vec<String>,
}

/// What a theorem is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TheoremKind {
    /// Its claims are decided.
    Theorem,
    /// It also becomes a function that computes the control points that it determines.
    Join,
}

impl TheoremKind {
    /// The word in front of the name.
    pub const fn keyword(self) -> &'static str {
        match self {
            Self::Theorem => "theorem",
            Self::Join => "join",
        }
    }
}

/// One statement of a theorem, with its doc comment.
#[derive(Debug)]
pub struct TheoremStatement {
    /// The doc comment, one string a line.
    pub doc: Vec<String>,
    /// The whole statement; of tokens of the compiler the first one.
    pub span: Span,
    /// Its last token.
    pub last: Span,
    /// What it says.
    pub kind: TheoremStatementKind,
}

/// The kinds of statements of a theorem.
#[derive(Debug)]
pub enum TheoremStatementKind {
    /// `curve P = Family(λ);` or `surface S = F(λ)(u) * F(γ[i])(v);`; control points may follow in brackets.
    Patch(PatchKind, Name, Expr),
    /// `scalar 0 < δ;`
    Scalar(Bounds, Loops),
    /// `assume λ > -2;` or `assume a + b <= 1;`: a range is narrowed, or scalars are related to one another.
    Assume(Relation),
    /// `let c = …;` or `let Q[1] = … for …;`
    Let(Expr, Expr, Loops),
    /// `dimension 2;`: the number of coordinates of points.
    Dimension(Expr),
    /// `prove …;` or `refute …;`
    Claim(Assertion),
    /// `budget 10;`
    Budget(Expr),
}

/// What a statement of a theorem declares over families.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PatchKind {
    /// One parameter.
    Curve,
    /// Two parameters, or those of a family on a triangle or box.
    Surface,
}

/// A name, perhaps with an index, and its range.
#[derive(Debug)]
pub struct Bounds {
    /// The name.
    pub target: Expr,
    /// The lower end.
    pub low: Option<Limit>,
    /// The upper end.
    pub high: Option<Limit>,
}

/// A claim of a theorem as it is written.
#[derive(Debug)]
pub struct Assertion {
    /// Whether it is declared true or false.
    pub expected: Expected,
    /// The left side.
    pub left: Expr,
    /// What stands between the sides.
    pub relation: TheoremRelation,
    /// The right side.
    pub right: Expr,
    /// What index variables run over.
    pub loops: Loops,
    /// The claim as it is written, in one line, without its keyword and comments.
    pub text: Rc<str>,
    /// Both sides.
    pub span: Span,
}

/// What is claimed of two sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TheoremRelation {
    /// They compare in this way.
    Compare(Comparison),
    /// One is a positive multiple of the other.
    Parallel,
}

impl TheoremRelation {
    /// The sign or word as it is written.
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Compare(Comparison::Equal) => "==",
            Self::Compare(sign) => sign.symbol(),
            Self::Parallel => "parallel",
        }
    }
}

/// `name[indices] = value for …`.
#[derive(Debug)]
pub struct FunctionDef {
    /// `permute`: the same for all functions that follow by permuting indices and variables together.
    pub permute: bool,
    /// The name that all functions of the family share.
    pub name: Name,
    /// The indices.
    pub indices: Vec<Expr>,
    /// The formula; of a function on several spans that on the first one.
    pub value: Expr,
    /// The formulas on the other spans, `… | … | …`; none for a formula that stands for all of them.
    pub further: Vec<Expr>,
    /// What the index variables run over.
    pub loops: Loops,
}

/// `for i in 0..=n, j in 0..=n if i != j`.
#[derive(Clone, Debug, Default)]
pub struct Loops {
    /// What the names run over, the first slowest.
    pub generators: Vec<Generator>,
    /// What must hold of the values, after `if`.
    pub condition: Option<Box<Condition>>,
}

/// What must hold of index variables, such as `i != j && !(i == 0 || j == 0)`.
#[derive(Clone, Debug)]
pub enum Condition {
    /// Two numbers compare in this way.
    Compare(Expr, Comparison, Expr),
    /// All of them hold, `&&`.
    All(Vec<Condition>),
    /// One of them holds, `||`.
    Any(Vec<Condition>),
    /// It does not hold, `!`.
    Not(Box<Condition>),
}

impl Condition {
    /// The number that stands first.
    pub fn first(&self) -> &Expr {
        match self {
            Self::Compare(left, ..) => left,
            Self::All(parts) | Self::Any(parts) => parts[0].first(), // there are at least two
            Self::Not(inner) => inner.first(),
        }
    }
}

/// What one or several index variables run over.
#[derive(Clone, Debug)]
pub enum Generator {
    /// `i in low..=high`.
    Range(IndexRange),
    /// `i, j, k in simplex(n)`: all whole numbers ≥ 0 with sum n, in lexicographic order.
    Simplex(Vec<Name>, Expr),
}

/// A factor of a domain.
#[derive(Debug)]
pub enum Factor {
    /// `triangle (u, v, w)`: the barycentric coordinates.
    Simplex(Vec<Name>),
    /// `-1 <= z <= 1`
    Range(RangeDecl),
}

impl Factor {
    /// The names of its variables.
    pub fn names(&self) -> &[Name] {
        match self {
            Self::Simplex(names) => names,
            Self::Range(decl) => core::slice::from_ref(&decl.name),
        }
    }

    /// The range of a variable.
    pub const fn range(&self) -> Option<&RangeDecl> {
        match self {
            Self::Simplex(_) => None,
            Self::Range(decl) => Some(decl),
        }
    }
}

/// `i in low..=high`.
#[derive(Clone, Debug)]
pub struct IndexRange {
    /// The name.
    pub name: Name,
    /// The first value.
    pub low: Expr,
    /// The last value, or the one after it.
    pub high: Expr,
    /// Whether `high` belongs to the range, `..=`.
    pub inclusive: bool,
}

/// A relation between two expressions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// `=` or `==`
    Equal,
    /// `!=`
    NotEqual,
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterEqual,
}

impl Comparison {
    /// The sign as it is written.
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Equal => "=",
            Self::NotEqual => "!=",
            Self::Less => "<",
            Self::LessEqual => "<=",
            Self::Greater => ">",
            Self::GreaterEqual => ">=",
        }
    }
}

/// A claim as it is written.
#[derive(Debug)]
pub struct Claim {
    /// Whether the claim is declared true (`prove`) or false (`refute`).
    pub expected: Expected,
    /// Where `prove` or `refute` stands.
    pub keyword: Span,
    /// What is claimed.
    pub kind: ClaimKind,
    /// Of a property, for which index parameters it is claimed.
    pub loops: Loops,
    /// The claim as it is written, in one line, without its keyword and comments.
    pub text: Rc<str>,
}

/// What the author of a claim says of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Expected {
    /// `prove`: the claim is true.
    True,
    /// `refute`: the claim is false.
    False,
    /// `conjecture`: the claim is believed to be true, and may be undecided.
    Open,
}

impl Expected {
    /// What a keyword declares.
    pub fn of(keyword: &str) -> Option<Self> {
        [Self::True, Self::False, Self::Open].into_iter().find(|expected| expected.keyword() == keyword)
    }

    /// The keyword.
    pub const fn keyword(self) -> &'static str {
        match self {
            Self::True => "prove",
            Self::False => "refute",
            Self::Open => "conjecture",
        }
    }
}

/// The kinds of claims.
#[derive(Debug)]
pub enum ClaimKind {
    /// The functions sum to 1.
    PartitionOfUnity,
    /// Every function is ≥ 0 on the domain for all shape values.
    Nonnegative,
    /// Reversing the domain reverses the functions.
    Symmetric,
    /// The functions are linearly independent, except at the listed shape values.
    Independent(Vec<Vec<Binding>>),
    /// Neighbouring segments, control points shifted by one, join with this many continuous derivatives.
    /// With bindings, the shape values of the next segment.
    Continuity(Expr, Vec<Binding>),
    /// All minors of the functions at ascending points are ≥ 0.
    TotallyPositive,
    /// The derivatives up to this order agree at the inner knots of a domain of several spans.
    Smooth(Expr),
    /// `rounding <= 5`
    Rounding(Expr),
    /// An equation or inequality.
    Relation(Relation),
    /// Equations and inequalities at fixed values: `at t = 0 { … }`.
    At(Vec<Binding>, Vec<Relation>),
}

/// `name = value`, or with an index, `λ[1] = value`.
#[derive(Debug)]
pub struct Binding {
    /// The name.
    pub name: Name,
    /// Its indices, if it has any.
    pub indices: Vec<Expr>,
    /// The value.
    pub value: Expr,
}

/// `left = right for …`, or a chain such as `0 <= middle <= 1`.
#[derive(Debug)]
pub struct Relation {
    /// The left side.
    pub left: Expr,
    /// The sign between the sides.
    pub comparison: Comparison,
    /// The right side.
    pub right: Expr,
    /// What follows in a chain: signs with the sides behind them.
    pub chain: Vec<(Comparison, Expr)>,
    /// What index variables run over.
    pub loops: Loops,
    /// All sides as they are written, in one line, without comments.
    pub text: Rc<str>,
    /// The loops in the same way, such as `for i in 0..=n`; empty without any.
    pub range: Rc<str>,
    /// The whole relation; of tokens of the compiler the first one.
    pub span: Span,
    /// The last token of its statement.
    pub last: Span,
}
