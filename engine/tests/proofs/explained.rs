//! What is said of families without being asked: exceptional shape values, and ranges on which the functions are nonnegative.

use basis_engine::explain::{describe_exception, exceptional_set, nonnegative_ranges};
use basis_engine::{Disk, Library, Prover, Selected, Source, Subject};

/// What is said of shape parameters never takes an angle and its tangent for two numbers.
#[test]
fn exceptions_and_ranges_are_those_of_angles() {
    let spec = "family CBezier {
        shape 0 < α < pi;
        domain 0 <= t <= α;
        b[0] = b[3](α - t);
        b[1] = 1 - b[0] - b[2] - b[3];
        b[2] = (1 - cos(t))/(1 - cos(α)) - b[3];
        b[3] = (t - sin(t))/(α - sin(α));
    }
    family WithAFactor {
        shape 0 <= λ <= 1;
        domain 0 <= t <= pi/2;
        b[0] = t - sin(t);
        b[1] = λ*t + cos(t);
        b[2] = λ*sin(t);
    }
    family Negative {
        shape 0 <= λ <= 1;
        domain 0 <= t <= pi/2;
        b[0] = sin(t) - λ*t;
        b[1] = cos(t);
    }
    family Wide {
        shape 0 < h <= 5;
        domain 0 <= x <= h;
        f[0] = x/h;
        f[1] = 1 - f[0];
    }
    family Part {
        shape 0 < α <= pi/4;
        domain 0 <= t <= α;
        b[0] = sin(t);
        b[1] = sin(α - t);
    }";
    let library = Library::from_source(&Disk, &Prover, Source::text("explained.basis", spec));
    let items = library.items(Selected::EveryOrder);
    let said = |k: usize| {
        let Subject::Family(family) = &items[k].subject else { panic!("{:?}", items[k].subject) };
        let set = exceptional_set(family);
        let exceptions: Vec<String> = set.exceptions.iter().map(|e| describe_exception(family, e)).collect();
        let ranges: Vec<String> = nonnegative_ranges(family).iter().map(ToString::to_string).collect();
        (exceptions, set.open, ranges)
    };
    let declared = |range: &str| vec![format!("{range} (as declared; no other values were looked at)")];
    assert_eq!(said(0), (Vec::new(), None, declared("0 < α < pi")));
    assert_eq!(said(1), (vec![String::from("λ = 0: b[2] = 0")], None, declared("0 <= λ <= 1")));
    let negative = String::from("λ: a function is negative somewhere on the declared ranges");
    assert_eq!(said(2), (Vec::new(), None, vec![negative]));
    assert_eq!(said(3), (Vec::new(), None, vec![String::from("0 < h")]));
    assert_eq!(said(4), (Vec::new(), None, declared("0 < α <= pi/4")));
}
