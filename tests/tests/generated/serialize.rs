//! Generated types, curves and what is measured of them are written and read with serde.

use basis_runtime::{Bezier, Contact, Curve, ParametricCurve, PiecewiseCurve, basis};

basis!("../../../specs/quartic.basis");
basis!("../../../specs/bernstein.basis", Bernstein(3));
basis!("../../../specs/triangular.basis", TriangularII(3));

const POINTS: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]];

fn quartic() -> Curve<QuarticBernstein, [f64; 2]> {
    Curve::new(QuarticBernstein::new(0.5).unwrap(), POINTS)
}

#[test]
fn shape_values_by_name() {
    let family = QuarticBernstein::new(0.5).unwrap();
    assert_eq!(serde_json::to_string(&family).unwrap(), r#"{"lambda":0.5}"#);
    assert_eq!(serde_json::from_str::<QuarticBernstein>(r#"{"lambda":0.5}"#).unwrap(), family);
    assert_eq!(serde_json::from_str::<QuarticBernstein>(r#"{"more":[1],"lambda":0.5}"#).unwrap(), family);
    assert_eq!(serde_json::from_str::<QuarticBernstein>("[0.5]").unwrap(), family);
    assert_eq!(serde_json::to_string(&Bernstein::<f64>::new()).unwrap(), "{}");
    assert_eq!(serde_json::from_str::<Bernstein>("{}").unwrap(), Bernstein::new());
    let two = TriangularII::new(2.0, 0.5).unwrap();
    assert_eq!(serde_json::to_string(&two).unwrap(), r#"{"lambda1":2.0,"lambda2":0.5}"#);
    assert_eq!(serde_json::from_str::<TriangularII>(r#"{"lambda2":0.5,"lambda1":2.0}"#).unwrap(), two);
}

#[test]
fn shape_values_are_checked() {
    let error = |text| serde_json::from_str::<QuarticBernstein>(text).unwrap_err().to_string();
    assert!(error(r#"{"lambda":2.0}"#).contains("λ = 2 is outside the declared range -3 <= λ <= 1"));
    assert!(error("{}").contains("missing field `lambda`"));
    assert!(error(r#"{"lambda":0.5,"lambda":0.5}"#).contains("duplicate field `lambda`"));
    assert!(error("[]").contains("invalid length 0, expected 1 shape values"));
}

#[test]
fn curves() {
    let text = r#"{"basis":{"lambda":0.5},"points":[[0.0,0.0],[1.0,2.0],[3.0,2.0],[4.0,0.0]]}"#;
    assert_eq!(serde_json::to_string(&quartic()).unwrap(), text);
    let read: Curve<QuarticBernstein, [f64; 2]> = serde_json::from_str(text).unwrap();
    assert_eq!(read, quartic());
    assert_eq!(read.eval(0.3), quartic().eval(0.3));
    let bezier = Bezier::from_points(POINTS);
    let text = serde_json::to_string(&bezier).unwrap();
    assert_eq!(serde_json::from_str::<Bezier<[f64; 2], 4>>(&text).unwrap(), bezier);
    for (points, found) in [("[[0.0,0.0]]", 1), ("[[0,0],[0,0],[0,0],[0,0],[0,0]]", 5)] {
        let text = format!(r#"{{"basis":{{}},"points":{points}}}"#);
        let error = serde_json::from_str::<Bezier<[f64; 2], 4>>(&text).unwrap_err().to_string();
        assert!(error.contains(&format!("invalid length {found}, expected 4 control points")), "{error}");
    }
}

#[test]
fn curves_of_several_segments() {
    let mut curve = PiecewiseCurve::from(quartic());
    let draft = PiecewiseCurve::from(Curve::new(QuarticBernstein::new(-1.0).unwrap(), POINTS));
    curve.append(&curve.continued(Contact::Tangent { f: 0.75 }, &draft).unwrap());
    let text = serde_json::to_string(&curve).unwrap();
    assert_eq!(
        serde_json::from_str::<PiecewiseCurve<Curve<QuarticBernstein, [f64; 2]>>>(&text).unwrap(),
        curve
    );
    assert!(serde_json::from_str::<PiecewiseCurve<Curve<QuarticBernstein, [f64; 2]>>>("[]").is_err());
    let contact = Contact::Curvature { f: 0.75, c: 0.5 };
    let text = serde_json::to_string(&contact).unwrap();
    assert_eq!(serde_json::from_str::<Contact<f64>>(&text).unwrap(), contact);
    let joint = curve.joints()[0];
    let text = serde_json::to_string(&joint).unwrap();
    assert_eq!(serde_json::from_str::<basis_runtime::Joint<f64>>(&text).unwrap(), joint);
    let nearest = curve.nearest([1.0, 1.0], 1e-9).unwrap();
    let text = serde_json::to_string(&nearest).unwrap();
    assert_eq!(serde_json::from_str::<basis_runtime::Nearest<[f64; 2]>>(&text).unwrap(), nearest);
}

#[test]
fn everything_can_be_shared_between_threads() {
    fn shared<T: Send + Sync + 'static>() {}
    shared::<QuarticBernstein>();
    shared::<Curve<QuarticBernstein<f32>, glam::Vec3>>();
    shared::<PiecewiseCurve<Curve<Bernstein, [f64; 2]>>>();
    shared::<basis_runtime::CurveError>();
    shared::<basis_runtime::Frame<[f64; 3]>>();
}
