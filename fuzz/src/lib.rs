//! The targets: functions of bytes that must neither panic nor run without end.
//!
//! With cargo-fuzz, from the root: `RUSTC_BOOTSTRAP=1 cargo fuzz run --sanitizer none spec -- -max_total_time=600`.
//! Without it: `cargo run --release --manifest-path fuzz/Cargo.toml --no-default-features --example replay -- spec 60`, which
//! changes the files of `fuzz/corpus` at random for 60 seconds. `cargo xtask nightly fuzz` does the first, or the second
//! where cargo-fuzz cannot be installed.

pub mod emitted;

use std::rc::Rc;

use basis_engine::algebra::work::Work;
use basis_engine::query::{forget_tokens, format};
use basis_engine::{Disk, Library, Prover, Request, Severity, Source, Verdict};
use basis_kernel::algebra::poly::{Poly, Var};
use basis_kernel::algebra::range::{Range, Region};
use basis_kernel::algebra::rational::Rational;
use basis_kernel::{Domain, Proof, Quotient, Refutation, Relation, Statement, text};
use basis_runtime::bspline::{BSplineCurve, BSplineSurface, KnotVector, Net, NurbsCurve};
use basis_runtime::{BernsteinBasis, ParametricCurve, Surface, TensorSurface, Tessellation};

/// The targets by name.
pub const TARGETS: [(&str, fn(&[u8])); 7] = [
    ("parser", parser),
    ("spec", spec),
    ("certificate", certificate),
    ("tokens", tokens),
    ("knots", knots),
    ("nets", nets),
    ("emitted", emitted::emitted),
];

/// The most bytes of a text: longer ones are not more interesting, but slower.
const MAX_TEXT: usize = 2048;

fn as_text(data: &[u8]) -> Option<&str> {
    std::str::from_utf8(data).ok().filter(|text| text.len() <= MAX_TEXT)
}

/// A spec as a file that is read and not expanded: every message can be shown, and without errors it has none in the standard
/// layout either, which stays as it is.
pub fn parser(data: &[u8]) {
    forget_tokens(); // of the inputs before
    let Some(text) = as_text(data) else { return };
    let is_wrong = |text: &str| {
        let library = Library::from_source(&Disk, &Prover, Source::text("fuzz.basis", text));
        let all = library.diagnostics();
        for diagnostic in &all {
            let shown = diagnostic.render(library.sources(), false);
            assert!(shown.starts_with("error: ") || shown.starts_with("warning: "), "{shown}");
        }
        all.iter().any(|d| d.severity == Severity::Error)
    };
    if is_wrong(text) {
        return;
    }
    let laid_out = format(text).expect("a spec without errors has its brackets in pairs");
    assert!(!is_wrong(&laid_out), "of\n{text}");
    assert_eq!(format(&laid_out).as_ref(), Ok(&laid_out), "of\n{text}");
}

/// A spec as a file: every message can be shown, every verdict checks out from the text of its certificate or witness.
pub fn spec(data: &[u8]) {
    forget_tokens(); // of the inputs before
    let Some(text) = as_text(data) else { return };
    let report = basis_engine::check(Source::text("fuzz.basis", text));
    for diagnostic in &report.diagnostics {
        let shown = diagnostic.render(&report.sources, false);
        assert!(shown.starts_with("error: ") || shown.starts_with("warning: "), "{shown}");
    }
    for item in &report.items {
        for (_, verdict) in &item.claims {
            match verdict {
                Verdict::Proved(evidence) => {
                    for (_, proof) in evidence.steps() {
                        let written = text::certificate_text(proof.certificate());
                        let read =
                            text::certificate(&written).expect("a certificate is read as it is written");
                        let statement = Rc::new(proof.statement().clone());
                        assert!(Proof::new(statement, read, &mut Work::usual(10)).is_ok(), "{written}");
                    }
                }
                Verdict::Refuted(witness) => {
                    let refutation = witness.refutation();
                    let written = text::witness_text(refutation.witness());
                    let read = text::witness(&written).expect("a witness is read as it is written");
                    let statement = Rc::new(refutation.statement().clone());
                    assert!(Refutation::new(statement, read, &mut Work::usual(10)).is_ok(), "{written}");
                }
                Verdict::Undecided(_) => {}
            }
        }
    }
}

/// x₀ − 1/3 ≥ 0 on the unit square, which is false, and x₀² ≥ 0, which is true.
fn about(numerator: Poly) -> Rc<Statement> {
    let ranges = vec![(Var(0), Range::unit()), (Var(1), Range::unit())];
    let domain = Rc::new(Domain::of(Region { ranges }));
    Rc::new(Statement::Sign { value: Quotient::from(numerator), relation: Relation::NonNegative, domain })
}

/// A text as a certificate, a witness, or both on two lines: read only as it is written, and it proves and refutes nothing
/// that is otherwise.
pub fn certificate(data: &[u8]) {
    let Some(whole) = as_text(data) else { return };
    let x = Poly::var(Var(0));
    let work = || Work::new(200_000);
    for line in whole.lines().take(2) {
        if let Ok(read) = text::certificate(line) {
            assert_eq!(text::certificate_text(&read), line);
            let false_one = about(&x - &Poly::constant(Rational::new(1, 3)));
            assert!(Proof::new(false_one, read.clone(), &mut work()).is_err(), "{line}");
            let rows = vec![vec![x.clone(), Poly::one()], vec![&x * &x, x.clone()]];
            let region = Region { ranges: vec![(Var(0), Range::unit())] };
            let dependent = Rc::new(Statement::Independent { rows, except: Vec::new(), region });
            assert!(Proof::new(dependent, read, &mut work()).is_err(), "{line}");
        }
        if let Ok(read) = text::witness(line) {
            assert_eq!(text::witness_text(&read), line);
            assert!(Refutation::new(about(&x * &x), read.clone(), &mut work()).is_err(), "{line}");
            let rows = vec![vec![Poly::one(), x.clone()], vec![Poly::zero(), Poly::one()]];
            let region = Region { ranges: vec![(Var(0), Range::unit())] };
            let independent = Rc::new(Statement::Independent { rows, except: Vec::new(), region });
            assert!(Refutation::new(independent, read, &mut work()).is_err(), "{line}");
        }
    }
}

/// A spec in a call of `basis!`, from its tokens: what comes out is Rust, or an error.
pub fn tokens(data: &[u8]) {
    forget_tokens(); // of the inputs before
    let Some(text) = as_text(data) else { return };
    let Ok(tokens) = text.parse::<proc_macro2::TokenStream>() else { return };
    let library = Library::from_tokens(&Disk, &Prover, tokens, None);
    let request = Request { families: Vec::new(), runtime: "::basis_runtime".parse().expect("a path") };
    let (code, diagnostics) = basis_engine::expand(&library, &request);
    if !diagnostics.iter().any(|d| d.severity == Severity::Error) {
        let file: Result<syn::File, _> = syn::parse2(code);
        assert!(file.is_ok(), "{}", file.err().map(|e| e.to_string()).unwrap_or_default());
    }
}

/// Numbers from bytes: most of them ordinary, some of every other kind.
struct Numbers<'d>(&'d [u8]);

impl Numbers<'_> {
    fn byte(&mut self) -> u8 {
        let Some((first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        *first
    }

    fn float(&mut self) -> f64 {
        match self.byte() {
            0 => f64::NAN,
            1 => f64::INFINITY,
            2 => -f64::MAX,
            3 => 1e-310,
            4 => {
                let bytes: [u8; 8] = std::array::from_fn(|_| self.byte());
                f64::from_le_bytes(bytes)
            }
            k => f64::from(k) / 16.0 - 8.0 + f64::from(self.byte()) / 4096.0,
        }
    }

    fn point(&mut self) -> [f64; 3] {
        std::array::from_fn(|_| self.float())
    }
}

/// A knot vector and everything that is made of it.
pub fn knots(data: &[u8]) {
    let mut numbers = Numbers(data);
    let degree = usize::from(numbers.byte() % 6);
    let count = usize::from(numbers.byte() % 20);
    let mut own: Vec<f64> = (0..count).map(|_| numbers.float()).collect();
    if numbers.byte() % 8 > 0 {
        own.sort_by(f64::total_cmp);
    }
    let Ok(knots) = KnotVector::new(degree, own) else { return };
    let t = numbers.float();
    assert_eq!(knots.functions() + knots.degree() + 1, knots.as_slice().len());
    assert_eq!(knots.greville().len(), knots.functions());
    if let Ok((_, values)) = knots.values(t) {
        let sum: f64 = values.iter().sum();
        let wide = knots.as_slice().iter().all(|x| x.abs() < 1e100 && (*x == 0.0 || x.abs() > 1e-100));
        assert!(!wide || (sum - 1.0).abs() < 1e-6 || sum.is_nan(), "{sum} at {t} of {knots:?}");
    }
    let _ = (knots.derivatives(t, 3), knots.reversed(), knots.mapped([numbers.float(), numbers.float()]));
    let points: Vec<[f64; 3]> = (0..knots.functions()).map(|_| numbers.point()).collect();
    let Ok(curve) = BSplineCurve::new(knots.clone(), points.clone()) else { return };
    let _ = (curve.eval(t), curve.eval_checked(t), curve.derivative(t, 2), curve.split(t), curve.to_bezier());
    let _ = (curve.insert_knots(&[t]), curve.remove_knot(t, 1, 1e-3), curve.elevate(), curve.clamped());
    let _ = (curve.refined(), curve.reversed(), curve.merged(&curve));
    let weights: Vec<f64> = (0..knots.functions()).map(|_| numbers.float()).collect();
    if let Ok(rational) = NurbsCurve::new(knots.clone(), points.clone(), weights) {
        let _ = (rational.eval(t), rational.split(t), rational.elevate(), rational.to_bezier());
    }
    if knots.functions() <= 6 {
        let net = Net::from_fn(knots.functions(), knots.functions(), |i, j| {
            let (p, q) = (points[i], points[j]);
            [p[0], q[1], p[2] + q[2]]
        });
        let Ok(net) = net else { return };
        if let Ok(surface) = BSplineSurface::new(knots.clone(), knots, net) {
            let _ = (surface.eval(t, t), surface.normal(t, numbers.float()));
        }
    }
}

/// A net of control points to a mesh.
pub fn nets(data: &[u8]) {
    let mut numbers = Numbers(data);
    let net: [[[f64; 3]; 3]; 4] = std::array::from_fn(|_| std::array::from_fn(|_| numbers.point()));
    let surface = TensorSurface::new(BernsteinBasis::<f64, 4>::new(), BernsteinBasis::<f64, 3>::new(), net);
    let size = net.iter().flatten().flatten().fold(1e-3_f64, |most, x| most.max(x.abs()));
    let tolerance = size * (0.01 + f64::from(numbers.byte()) / 512.0);
    let Ok(tessellation) = Tessellation::new(tolerance) else { return };
    if let Ok(mesh) = tessellation.with(&surface).mesh() {
        mesh.check().expect("a mesh is right");
        assert!(mesh.positions.iter().flatten().all(|x| x.is_finite()), "{mesh:?}");
    }
}
