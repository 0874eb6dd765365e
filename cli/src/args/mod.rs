//! What can be typed after `basis`, with the texts of `--help`.

mod values;

use std::path::PathBuf;

use clap::builder::styling::{AnsiColor, Style, Styles};
use clap::{Args, Parser, Subcommand, ValueEnum};

pub(crate) use values::{Axis, ShapeArgument, ShapeValues};
use values::{axis, order, point, shape};

const STYLES: Styles = Styles::styled()
    .header(Style::new().bold())
    .usage(Style::new().bold())
    .literal(AnsiColor::Cyan.on_default().bold())
    .placeholder(AnsiColor::Cyan.on_default());

/// Proves properties of basis functions and evaluates them exactly
///
/// A spec file (`quartic.basis`) states a family of basis functions, its domain, its shape parameters and the
/// properties that it is supposed to have. All arithmetic is exact: what is proved holds, what is refuted comes
/// with a point at which it fails.
#[derive(Debug, Parser)]
#[command(name = "basis", version, styles = STYLES, after_help = EXAMPLES, max_term_width = 100)]
pub(crate) struct Arguments {
    /// What is to be done.
    #[command(subcommand)]
    pub(crate) command: Command,
}

const EXAMPLES: &str = "\
Examples:
  basis check specs
  basis explain library:quartic
  basis eval quartic.basis QuarticBernstein --shape λ=1/2 --at t=1/3";

/// The commands.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Prove or refute every claim of spec files
    ///
    /// Every claim of every family is decided for all points of the domain and all values of the shape
    /// parameters in their declared ranges; a family with an index parameter, such as the degree n in 1..=30, in
    /// every order. A refuted claim comes with a point and the exact value there.
    #[command(after_help = CHECK_HELP)]
    Check(CheckArguments),
    /// Write proved families and joins as a source file, to be read and checked in
    ///
    /// Every claim of what is written is decided first. Without names all families without index parameters and all
    /// joins of the spec are written.
    #[command(after_help = EMIT_HELP)]
    Emit(EmitArguments),
    /// Evaluate basis functions and their derivatives in exact fractions
    ///
    /// Shape values and points are whole numbers, fractions or decimals (2, -1/3, 0.62); decimals are exact.
    /// Greek names may be spelled out: lambda1 is λ1.
    #[command(after_help = EVAL_HELP)]
    Eval(EvalArguments),
    /// Show what follows from the formulas of a family, and what joins and theorems say
    ///
    /// Of a family: the functions in factored and expanded form; the derivatives of a curve at both ends as
    /// combinations of its control points; the shape values at which the functions are linearly dependent; which
    /// control points C1, G1, C2 and G2 contact with another curve determines at either end, as formulas; the matrices
    /// to and from the Bernstein basis, of degree elevation, mass and stiffness, and the moments; zeros and extrema of
    /// functions that are negative somewhere, or why they are not stated; the verdicts of its claims; and the largest
    /// ranges of the shape parameters on which all functions stay nonnegative.
    ///
    /// Of a join or theorem: its curves, surfaces and scalars with their ranges, the control points that it determines
    /// as formulas in the given ones, and its claims, each with its verdict and the reason.
    #[command(after_help = EXPLAIN_HELP)]
    Explain(ExplainArguments),
    /// Give spec files their standard layout
    ///
    /// Four columns of indentation, one statement a line, spaces around signs. Comments, broken lines and empty lines
    /// between statements stay, and so does the choice between `a*b` and `a * b`. What a spec means never changes.
    #[command(after_help = FMT_HELP)]
    Fmt(FmtArguments),
    /// Serve an editor: verdicts while you type
    ///
    /// A language server that speaks the Language Server Protocol on standard input and output: a mark with its reason at
    /// every claim, formulas under the pointer, completion, go to definition, rename, formatting, and actions such as
    /// inserting the claims that hold. Editors start it; editors/README.md has a line for each of them.
    Lsp(LspArguments),
    /// Write a spec to start from
    ///
    /// The file has the name of the family in lower case: `basis new RationalCubic` writes `rational_cubic.basis`, with
    /// quotients, because the name says so. All its claims are proved as it stands; replace its formulas with your own.
    #[command(after_help = NEW_HELP)]
    New(NewArguments),
    /// Draw the functions of a family, a curve over it, and where a claim fails
    ///
    /// Functions on an interval are lines, those on a triangle or a box of two variables maps with one scale of
    /// colours, red below zero; those of three variables, as on a prism, are cut at a value of one of them. A range of
    /// shape values gives five lines for each function. With control points the curve is drawn beside the functions.
    /// Points at which claims fail are marked, grey where `refute` declares them false. The page has sliders for the
    /// shape values and control points to drag, and is one file.
    #[command(after_help = PLOT_HELP)]
    Plot(PlotArguments),
    /// Print the families of spec files with what is proved of them, as a table in Markdown
    ///
    /// One row for each family: ✓ what is proved, ✗ what is refuted, for which orders and with which exceptions.
    #[command(after_help = TABLE_HELP)]
    Table(TableArguments),
    /// Check the certificates that `basis check --certificates` wrote
    ///
    /// The specs are read, what has to be shown is worked out again, and the kernel checks that each certificate shows
    /// it. No proof is searched for.
    #[command(after_help = VERIFY_HELP)]
    Verify(VerifyArguments),
    /// Print the completions of a shell
    #[command(after_help = COMPLETIONS_HELP)]
    Completions(CompletionsArguments),
    /// Print the manual page of the command or of a subcommand, or write all of them
    Man(ManArguments),
}

/// What can be typed after `basis check`.
#[derive(Debug, Args)]
pub(crate) struct CheckArguments {
    /// How to print the verdicts
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(crate) format: Format,
    /// Write a certificate for every family and order into this folder
    #[arg(long, value_name = "DIR")]
    pub(crate) certificates: Option<PathBuf>,
    /// Write the theorems with proofs for Coq into this folder, a file for every family and order; `make` there has Coq
    /// check them
    #[arg(long, value_name = "DIR")]
    pub(crate) coq: Option<PathBuf>,
    /// Print errors only
    #[arg(short, long, conflicts_with = "format")]
    pub(crate) quiet: bool,
    /// Check again whenever one of the files, or a file that one of them uses, changes
    #[arg(short, long, conflicts_with_all = ["format", "certificates", "coq"])]
    pub(crate) watch: bool,
    /// Spec files, and folders in which every file *.basis is checked; - is standard input, library:NAME is a spec of
    /// the library, library: all
    #[arg(required = true, value_name = "PATH")]
    pub(crate) paths: Vec<PathBuf>,
}

const CHECK_HELP: &str = "\
Exit status:
  0  every claim is as declared: `prove` is proved, `refute` is refuted
  1  a claim is not as declared, or a spec has errors; with --coq also if a claim cannot be stated in Coq
  2  a file cannot be read, or the command is used wrongly

Examples:
  basis check quartic.basis
  basis check library:quartic
  basis check --watch quartic.basis
  basis check specs --format json | jq '.files[].items[].claims[] | select(.verdict != \"proved\")'";

/// What can be typed after `basis emit`.
#[derive(Debug, Args)]
pub(crate) struct EmitArguments {
    /// The spec file, or library:NAME for a spec of the library
    pub(crate) file: PathBuf,
    /// Families, with their orders if they have index parameters, and joins: 'Bernstein(3)', 'Bernstein(n=5) as
    /// Quintic', G1
    #[arg(value_name = "NAME")]
    pub(crate) names: Vec<String>,
    /// The language of the file
    #[arg(long, value_enum)]
    pub(crate) to: EmitTarget,
    /// The numbers that the code computes with; without it what the language usually has
    #[arg(long, value_enum)]
    pub(crate) scalar: Option<EmitScalar>,
    /// The file to write, from whose folder an edited spec is noticed; without it the text is printed
    #[arg(short, long, value_name = "PATH")]
    pub(crate) output: Option<PathBuf>,
    /// Write nothing, and fail if this file is not what `-o` with the same path would write
    #[arg(long, value_name = "PATH", conflicts_with = "output")]
    pub(crate) check: Option<PathBuf>,
}

/// The languages of `basis emit`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum EmitTarget {
    /// Types on basis-runtime, which can do without its feature `macros`; an edited spec stops the build
    Rust,
    /// A header for C99 to C23 and C++17, without allocation
    C,
    /// Classes on numbers and arrays of numpy and JAX, without an import
    Python,
    /// An ES module with classes on numbers and Float64Array, strictly typed
    #[value(name = "typescript")]
    TypeScript,
    /// Functions of single floats for WebGPU, with a compute shader `eval_n`
    Wgsl,
    /// Functions of single floats for OpenGL 3.30 or ES 3.00 and later
    Glsl,
}

/// The numbers that the code computes with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum EmitScalar {
    /// Single precision, `float`
    F32,
    /// Double precision, `double`
    F64,
}

impl EmitScalar {
    /// The name on the command line.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
        }
    }
}

impl EmitTarget {
    /// The name on the command line.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Rust => "rust",
            Self::C => "c",
            Self::Python => "python",
            Self::TypeScript => "typescript",
            Self::Wgsl => "wgsl",
            Self::Glsl => "glsl",
        }
    }
}

const EMIT_HELP: &str = "\
Exit status:
  0  the file is written; with --check, it is what the spec gives now
  1  a claim is not as declared, the spec has errors, there is no code for a family, or the file is another one
  2  a file cannot be read or written, or the command is used wrongly

Examples:
  basis emit specs/quartic.basis --to rust -o src/families.rs
  basis emit specs/quartic.basis --to rust --check src/families.rs
  basis emit library:bernstein 'Bernstein(3) as Cubic' --to rust
  basis emit specs/quartic.basis --to c --scalar f32 -o quartic.h
  basis emit specs/quartic.basis --to python -o quartic.py";

/// What can be typed after `basis fmt`.
#[derive(Debug, Args)]
pub(crate) struct FmtArguments {
    /// Change nothing, and name the files that are not in the standard layout
    #[arg(long)]
    pub(crate) check: bool,
    /// Spec files, and folders in which every file *.basis is changed; - is standard input, whose layout is printed
    #[arg(required = true, value_name = "PATH")]
    pub(crate) paths: Vec<PathBuf>,
}

const FMT_HELP: &str = "\
Exit status:
  0  every file is in the standard layout now; with --check, it was
  1  with --check: a file is not
  2  a file cannot be read or written, or a bracket in it has no partner

Examples:
  basis fmt specs
  basis fmt --check specs
  basis fmt - < quartic.basis";

/// What can be typed after `basis new`.
#[derive(Debug, Args)]
pub(crate) struct NewArguments {
    /// The name of the family, such as RationalCubic
    pub(crate) name: String,
    /// What to start from; without it what the name says, as in RationalCubic, or else `curve`
    #[arg(long, value_enum)]
    pub(crate) kind: Option<Kind>,
    /// The file to write; - is standard output
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
}

/// What a new spec starts from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Kind {
    /// Functions on an interval with a shape parameter
    Curve,
    /// Functions of every degree on an interval
    Degrees,
    /// Quotients on an interval with a weight
    Rational,
    /// Functions of an angle with a shape parameter
    Trigonometric,
    /// A function on several knot spans
    Spline,
    /// Functions on a triangle
    Triangle,
    /// Functions on a box
    Box,
    /// Two curves that join with a common tangent
    Join,
}

const NEW_HELP: &str = "\
Exit status:
  0  the file is written
  2  there is such a file already, or it cannot be written, or the command is used wrongly

Examples:
  basis new RationalCubic
  basis new Hyperbolas --kind rational
  basis new Patch --kind triangle -o specs/patch.basis";

/// What can be typed after `basis completions`.
#[derive(Debug, Args)]
pub(crate) struct CompletionsArguments {
    /// The shell
    pub(crate) shell: clap_complete::Shell,
}

const COMPLETIONS_HELP: &str = "\
Examples:
  basis completions bash > ~/.local/share/bash-completion/completions/basis
  basis completions zsh > ~/.zfunc/_basis
  basis completions fish > ~/.config/fish/completions/basis.fish";

/// What can be typed after `basis man`.
#[derive(Debug, Args)]
pub(crate) struct ManArguments {
    /// The subcommand whose page is printed, such as `check`; without it that of `basis`
    #[arg(conflicts_with = "output")]
    pub(crate) command: Option<String>,
    /// Write basis.1, basis-check.1 and so on into this folder
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
}

/// What can be typed after `basis lsp`.
#[derive(Debug, Args)]
pub(crate) struct LspArguments {
    /// Speak on standard input and output, which is the only way there is; many editors say so
    #[arg(long)]
    stdio: bool,
}

/// What can be typed after `basis table`.
#[derive(Debug, Args)]
pub(crate) struct TableArguments {
    /// Spec files, and folders in which every file *.basis is read; library:NAME is a spec of the library, library: all
    #[arg(required = true, value_name = "PATH")]
    pub(crate) paths: Vec<PathBuf>,
}

const TABLE_HELP: &str = "\
Exit status:
  0  the table is printed
  1  a claim is not as declared, or a spec has errors
  2  a file cannot be read, or the command is used wrongly

Examples:
  basis table specs
  basis table library:";

/// What can be typed after `basis verify`.
#[derive(Debug, Args)]
pub(crate) struct VerifyArguments {
    /// How to print the results
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(crate) format: Format,
    /// The folder with the certificates
    #[arg(value_name = "DIR")]
    pub(crate) folder: PathBuf,
    /// Specs, or folders of specs, all of which must have certificates in the folder; those that `basis check` was
    /// given must in any case
    #[arg(value_name = "PATH")]
    pub(crate) specs: Vec<PathBuf>,
}

const VERIFY_HELP: &str = "\
Exit status:
  0  every certificate proves what its spec claims, and none is missing
  1  a certificate is rejected or missing
  2  a certificate or its spec cannot be read, or the command is used wrongly

Examples:
  basis check --certificates proofs specs && basis verify proofs
  basis verify proofs specs/quartic.basis";

/// What can be typed after `basis eval`.
#[derive(Debug, Args)]
pub(crate) struct EvalArguments {
    /// The spec file, - for standard input, or library:NAME for a spec of the library
    pub(crate) file: PathBuf,
    /// The family, with its order if it has index parameters: 'Bernstein(3)' or 'Bernstein(n=3)'; not needed where the
    /// spec has only one
    pub(crate) family: Option<String>,
    /// The value of a shape parameter, inside its declared range: λ=1/2, or several, λ=-3..1:1/2; of a list one entry,
    /// `w[1]=1/2`, or all others, w=1/2
    #[arg(long = "shape", value_name = "NAME=VALUE", value_delimiter = ',', value_parser = axis)]
    pub(crate) shapes: Vec<Axis>,
    /// The point: a value for each domain variable, or several from one to another in steps, t=0..1:1/10; a variable
    /// that comes again begins another point
    #[arg(long = "at", value_name = "NAME=VALUE", value_delimiter = ',', value_parser = axis)]
    pub(crate) at: Vec<Axis>,
    /// Also print all derivatives in the domain variables up to this order
    #[arg(long, value_name = "K", default_value_t = 0, value_parser = order, allow_hyphen_values = true)]
    pub(crate) order: u32,
    /// Control points, such as "0,0 1,2 3,2 4,0", or a file with one point a line: what is printed are the points of
    /// the curve or surface, and its derivatives
    #[arg(long, value_name = "POINTS", allow_hyphen_values = true)]
    pub(crate) points: Option<String>,
    /// Also evaluate outside of the declared ranges and of the domain, about which no claim says anything
    #[arg(long)]
    pub(crate) anyway: bool,
    /// How to print the values
    #[arg(long, value_enum, default_value_t = EvalFormat::Text)]
    pub(crate) format: EvalFormat,
    /// Print decimals instead of fractions where there is one column for both: in tables of several points and in CSV
    #[arg(long)]
    pub(crate) decimal: bool,
}

/// How to print values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum EvalFormat {
    /// A table
    Text,
    /// One JSON object
    Json,
    /// One line for each point, with a header
    Csv,
}

const EVAL_HELP: &str = "\
Exit status:
  0  the values are printed
  2  the spec has errors or cannot be read, or the command is used wrongly

Examples:
  basis eval quartic.basis --shape λ=1/2 --at t=1/3
  basis eval quartic.basis QuarticBernstein --shape lambda=0.5 --at t=0 --order 2
  basis eval bernstein.basis 'Bernstein(n=3)' --at t=0.25 --format json
  basis eval library:quartic QuarticBernstein --shape λ=1/2 --at t=0..1:1/10 --format csv
  basis eval library:quartic QuarticBernstein --shape λ=2 --anyway --at t=1/2 --points '0,0 1,2 3,2 4,0'
  basis eval turn.basis Turn --at θ=0..pi/2:pi/8";

/// What can be typed after `basis explain`.
#[derive(Debug, Args)]
pub(crate) struct ExplainArguments {
    /// How to print the explanation
    #[arg(long, value_enum, default_value_t = ExplainFormat::Text)]
    pub(crate) format: ExplainFormat,
    /// The spec file, - for standard input, or library:NAME for a spec of the library
    pub(crate) file: PathBuf,
    /// A family, with its order if it has index parameters, 'Bernstein(3)', or a join or theorem; without a name all of
    /// the file, families in their lowest orders
    pub(crate) name: Option<String>,
    /// Also print the matrices that convert the family into another one that the spec knows, and back; without NAME
    /// the spec must have only one family
    #[arg(long, value_name = "FAMILY")]
    pub(crate) to: Option<String>,
}

const EXPLAIN_HELP: &str = "\
Exit status:
  0  the explanation is printed
  2  the spec has errors or cannot be read, or the command is used wrongly

Examples:
  basis explain quartic.basis
  basis explain library:papers/quartic
  basis explain bernstein.basis 'Bernstein(n=3)'
  basis explain quartic.basis QuarticBernstein --to 'Bernstein(4)'
  basis explain quadratic.basis G1
  basis explain quartic.basis --format latex > quartic.tex && pdflatex quartic.tex
  basis explain papers/quartic.basis | less";

/// What can be typed after `basis plot`.
#[derive(Debug, Args)]
pub(crate) struct PlotArguments {
    /// The spec file, - for standard input, or library:NAME for a spec of the library
    pub(crate) file: PathBuf,
    /// The family, with its order if it has index parameters: 'Bernstein(3)'; not needed where the spec has only one
    pub(crate) family: Option<String>,
    /// The value of a shape parameter, or a range of values: λ=1/2 or λ=-3..1; of a list one entry, `w[1]=1/2`, or all
    /// others, w=1/2
    #[arg(long = "shape", value_name = "NAME=VALUE", value_delimiter = ',', value_parser = shape)]
    pub(crate) shapes: Vec<ShapeArgument>,
    /// The control points of a curve in the plane, such as "0,0 1,2 3,2 4,0"
    #[arg(long, value_name = "POINTS", value_parser = point, value_delimiter = ' ', allow_hyphen_values = true)]
    pub(crate) points: Vec<[f64; 2]>,
    /// Where functions of three variables are cut, such as z=1/2 of a prism; without it where a claim fails, or in the
    /// middle
    #[arg(long = "at", value_name = "NAME=VALUE", value_parser = shape)]
    pub(crate) at: Option<ShapeArgument>,
    /// The picture to write; its name ends with .svg, .png or .html, and - is an SVG on standard output; without it
    /// QuarticBernstein.svg, the name of the family, in the current folder
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
}

const PLOT_HELP: &str = "\
Exit status:
  0  the picture is written
  2  the spec has errors or cannot be read, or the command is used wrongly

Examples:
  basis plot quartic.basis --shape λ=1/2 -o quartic.svg
  basis plot library:quartic --shape λ=-3..1 --points '0,0 1,2 3,2 4,0' -o curves.png
  basis plot library:triangular 'TriangularII(4)' -o maps.svg
  basis plot prism.basis --at z=1/4 -o prism.svg
  basis plot quartic.basis -o quartic.html";

/// How to print an explanation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ExplainFormat {
    /// Lines of text
    Text,
    /// One JSON object, with every formula in LaTeX as well, and the claims with their verdicts
    Json,
    /// A document for LaTeX: definition, theorem, counterexamples, control points of joins
    Latex,
}

/// How to print results.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// Tables
    Text,
    /// One JSON object
    Json,
}
