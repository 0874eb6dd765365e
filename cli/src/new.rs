//! `basis new`: a spec to start from.

use std::fs::OpenOptions;
use std::io::{ErrorKind, Write as _};
use std::path::{Path, PathBuf};

use basis_engine::ascii::ascii;
use basis_engine::{Sources, query};
use clap::ValueEnum as _;

use crate::args::{Kind, NewArguments};
use crate::output::{self, Status};
use crate::spec::{EXTENSION, STDIN};

/// Writes the spec.
pub(crate) fn run(arguments: &NewArguments) -> Status {
    let name = &arguments.name;
    let fail = |message: String, help: &str| {
        let error = output::error(message).help(help);
        output::complain(&(error.render(&Sources::default(), true) + "\n"));
        Status::Unusable
    };
    if query::word(name).is_some() {
        let help = match arguments.kind.or_else(|| told(name)) {
            Some(kind) => format!("choose another: `basis new MyFamily --kind {}`", label(kind)),
            None => String::from("choose another: `basis new MyFamily`"),
        };
        return fail(format!("`{name}` is a word of the language, not the name of a family"), &help);
    }
    if !query::is_name(name) {
        let message = format!("`{name}` is not the name of a family");
        return fail(message, "write letters and digits, beginning with a letter: `basis new RationalCubic`");
    }
    let kind = arguments.kind.unwrap_or_else(|| kind_of(name));
    let text = text(kind, name);
    let path = arguments.output.clone().unwrap_or_else(|| file_name(name));
    if path == Path::new(STDIN) {
        return output::print(&text);
    }
    let written = OpenOptions::new()
        .write(true)
        .create_new(true)
        .open(&path)
        .and_then(|mut file| file.write_all(text.as_bytes()));
    let path = path.display();
    match written {
        Ok(()) => {
            let other = match arguments.kind {
                Some(_) => String::new(),
                None => format!(", with `--kind {}`", label(kind)),
            };
            output::print(&format!("wrote {path}{other}; `basis check {path}` proves its claims\n"))
        }
        Err(e) if e.kind() == ErrorKind::AlreadyExists => fail(
            format!("there is a file `{path}` already"),
            "choose another name, or another file with `-o FILE`",
        ),
        Err(e) => fail(format!("cannot write `{path}`: {e}"), "name another file with `-o FILE`"),
    }
}

fn kind_of(name: &str) -> Kind {
    told(name).unwrap_or(Kind::Curve)
}

/// The kind that a name tells: `RationalCubic` is rational.
fn told(name: &str) -> Option<Kind> {
    let name = ascii(name).to_ascii_lowercase();
    let words = [
        ("rational", Kind::Rational),
        ("trig", Kind::Trigonometric),
        ("spline", Kind::Spline),
        ("triang", Kind::Triangle),
    ];
    words.into_iter().find(|(word, _)| name.contains(word)).map(|(_, kind)| kind)
}

/// The name of a kind on the command line.
fn label(kind: Kind) -> String {
    kind.to_possible_value().map_or_else(String::new, |value| value.get_name().to_string())
}

/// `RationalCubic` → `rational_cubic.basis`.
fn file_name(name: &str) -> PathBuf {
    let mut stem = String::new();
    let mut before = '_';
    for c in ascii(name).chars() {
        if c.is_ascii_uppercase() && (before.is_ascii_lowercase() || before.is_ascii_digit()) {
            stem.push('_');
        }
        stem.push(c.to_ascii_lowercase());
        before = c;
    }
    PathBuf::from(format!("{stem}.{EXTENSION}"))
}

fn text(kind: Kind, name: &str) -> String {
    let template = match kind {
        Kind::Curve => CURVE,
        Kind::Degrees => DEGREES,
        Kind::Rational => RATIONAL,
        Kind::Trigonometric => TRIGONOMETRIC,
        Kind::Spline => SPLINE,
        Kind::Triangle => TRIANGLE,
        Kind::Box => BOX,
        Kind::Join => JOIN,
    };
    template.replace("NAME", name)
}

const CURVE: &str = "\
//! Where the formulas come from: author, title, definition.

/// What the family is; λ = 0 gives the quadratic Bernstein basis.
family NAME {
    domain 0 <= t <= 1;
    /// What the parameter does: the larger λ, the nearer a curve runs to its control polygon.
    shape -2 <= λ <= 1;

    b[0] = (1 - λ*t) * (1 - t)^2;
    b[1] = (2 + λ) * t * (1 - t);
    b[2] = (1 - λ + λ*t) * t^2;

    prove partition_of_unity;
    prove nonnegative;
    prove symmetric;
    prove independent except λ = -2;
    prove at t = 0 { b = [1, 0, 0]; D(b) = [-(2 + λ), 2 + λ, 0]; }
    prove at t = 1 { b = [0, 0, 1]; D(b) = [0, -(2 + λ), 2 + λ]; }
    prove at λ = 0 { b = Bernstein(2); }
}
";

const DEGREES: &str = "\
//! Where the formulas come from: author, title, definition.

/// What the family is, for every degree n.
family NAME(n in 1..=10) {
    domain 0 <= t <= 1;

    b[i] = binomial(n, i) * t^i * (1 - t)^(n - i) for i in 0..=n;

    prove partition_of_unity;
    prove nonnegative;
    prove symmetric;
    prove independent;
    // Linear precision: control points at i/n give the straight line.
    prove sum(i/n * b[i] for i in 0..=n) = t;
    prove at t = 0 { b[0] = 1; D(b[0]) = -n; D(b[1]) = n; }
}
";

const RATIONAL: &str = "\
//! Where the formulas come from: author, title, definition.

/// What the family is; ω = 1 gives the quadratic Bernstein basis.
family NAME {
    domain 0 <= t <= 1;
    /// What the weight does: the larger ω, the nearer a curve runs to its control polygon.
    shape 0 < ω;

    let w = (1 - t)^2 + 2*ω*t*(1 - t) + t^2;
    b[0] = (1 - t)^2/w;
    b[1] = 2*ω*t*(1 - t)/w;
    b[2] = t^2/w;

    prove partition_of_unity;
    prove nonnegative;
    prove symmetric;
    prove independent;
    prove at t = 0 { b = [1, 0, 0]; D(b) = [-2*ω, 2*ω, 0]; }
    prove at ω = 1 { b = Bernstein(2); }
}
";

const TRIGONOMETRIC: &str = "\
//! Where the formulas come from: author, title, definition.

/// What the family is, in the variable θ itself.
family NAME {
    domain 0 <= θ <= pi/2;
    /// What the parameter does: the larger λ, the nearer a curve runs to its control polygon.
    shape -1 <= λ <= 1;

    b[0] = (1 - λ*sin(θ)) * (1 - sin(θ));
    b[1] = (1 + λ) * (sin(θ) + cos(θ) - 1);
    b[2] = (1 - λ*cos(θ)) * (1 - cos(θ));

    prove partition_of_unity;
    prove nonnegative;
    prove symmetric;
    prove independent except λ = -1;
    prove at θ = 0 { b = [1, 0, 0]; D(b) = [-(1 + λ), 1 + λ, 0]; }
    prove at θ = pi/2 { b = [0, 0, 1]; D(b) = [0, -(1 + λ), 1 + λ]; }
}
";

const SPLINE: &str = "\
//! Where the formulas come from: author, title, definition.

/// What the functions are, with one formula for each span.
family NAME {
    domain 0 <= x <= 1, 1 <= x <= 2, 2 <= x <= 3;

    f[0] = x^2/2 | (-2*x^2 + 6*x - 3)/2 | (3 - x)^2/2;

    prove smooth(1);
    refute smooth(2);
    prove nonnegative;
    prove symmetric;
    prove integral(f[0]) = 1;
    prove at x = 1 { f[0] = 1/2; D(f[0]) = 1; }
    prove f[0] <= 3/4;
}
";

const TRIANGLE: &str = "\
//! Where the formulas come from: author, title, definition.

/// What the family is, on a triangle with the barycentric coordinates u, v and w = 1 - u - v.
family NAME {
    domain triangle (u, v, w);

    // `permute` stands for all functions that follow by permuting indices and variables together.
    permute b[2, 0, 0] = u^2;
    permute b[1, 1, 0] = 2*u*v;

    prove partition_of_unity;
    prove nonnegative;
    prove symmetric;
    prove independent;
    // The corners are interpolated.
    prove at u = 1, v = 0 { b[2, 0, 0] = 1; }
}
";

const BOX: &str = "\
//! Where the formulas come from: author, title, definition.

/// What the family is, on a square.
family NAME {
    domain 0 <= u <= 1, 0 <= v <= 1;

    b[0, 0] = (1 - u)*(1 - v);
    b[0, 1] = (1 - u)*v;
    b[1, 0] = u*(1 - v);
    b[1, 1] = u*v;

    prove partition_of_unity;
    prove nonnegative;
    prove symmetric;
    prove independent;
    prove at u = 0 { b[0, 0] = 1 - v; b[0, 1] = v; b[1, 0] = 0; b[1, 1] = 0; }
}
";

const JOIN: &str = "\
//! Where the statement comes from: author, title, theorem.

use library \"quadratic\";

/// The first points of a curve Q that continues a curve P with a common tangent: P'(1) = δ Q'(0).
join NAME {
    curve P = QuadraticBezier(λ1);
    curve Q = QuadraticBezier(λ2);
    scalar 0 < δ;
    assume λ2 > -2;

    let Q[0] = P[2];
    let Q[1] = Q[0] + (λ1 + 2)/(δ*(λ2 + 2)) * (P[2] - P[1]);

    prove Q(0) == P(1);
    prove D(P)(1) == δ*D(Q)(0);
}
";
