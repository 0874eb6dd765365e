//! Mass and stiffness matrices, compared with the exact ones that the engine integrates.

use basis_engine::algebra::rational::ToFloat as _;
use basis_engine::explain::{MatrixKind, matrices};
use basis_engine::{Disk, Family, Library, Prover, Source, Subject};
use basis_tests::exact::fraction;

macro_rules! families {
    ($($spec:tt)*) => {
        basis_runtime::basis! { $($spec)* }
        const SPEC: &str = stringify!($($spec)*);
    };
}

families! {
    family Curve {
        domain -1 <= t <= 2;
        shape -3 <= k <= 1;
        b[0] = (1 - k*t)*(2 - t)^3;
        b[1] = t^2 + k;
        b[2] = t;
    }
    family Constant {
        domain 0 <= t <= 2;
        b[0] = 1;
    }
    family Corner {
        domain triangle (u, v, w);
        shape 0 <= k <= 2;
        b[0] = u*(2*u - 1) + 3*k*u*v*w;
        b[1] = 4*u*v - k*w^3;
        b[2] = w;
    }
    family Solid {
        domain tetrahedron (u, v, w, x);
        b[0] = u^2 - x;
        b[1] = v*w;
        b[2] = x;
    }
    family Sheet {
        domain 0 <= p <= 2, -1 <= q <= 3, 0 <= r <= 1;
        shape 0 <= k <= 2;
        b[0] = p*q*r;
        b[1] = 1 - k*p^2*r;
        b[2] = q^3;
    }
}

/// The exact matrix of a family with a value of its shape parameter, if it has one.
fn exact(family: &str, kind: MatrixKind, k: f64) -> Vec<Vec<f64>> {
    let library = Library::from_source(&Disk, &Prover, Source::text("families.basis", SPEC));
    let item = library.item(family, &[]).unwrap_or_else(|_| panic!("{SPEC}"));
    let Subject::Family(family) = item.subject else { panic!("a family") };
    let family: &Family = &family;
    let found = matrices(&library, family, None).into_iter().find(|m| m.kind == kind).expect("there is one");
    let at = vec![fraction(k); family.names.len()];
    found
        .entries
        .iter()
        .map(|row| row.iter().map(|f| f.eval(&at).expect("finite").to_f64()).collect())
        .collect()
}

fn compare<const N: usize>(family: &str, k: f64, mass: [[f64; N]; N], stiffness: [[f64; N]; N]) {
    for (kind, computed) in [(MatrixKind::Mass, mass), (MatrixKind::Stiffness, stiffness)] {
        let exact = exact(family, kind, k);
        let size = exact.iter().flatten().fold(0.0_f64, |size, x| size.max(x.abs()));
        for i in 0..N {
            for j in 0..N {
                let error = (computed[i][j] - exact[i][j]).abs();
                assert!(
                    error <= 8.0 * f64::EPSILON * size,
                    "{family} {kind:?} {i} {j}: {computed:?} {exact:?}"
                );
                assert_eq!(computed[i][j].to_bits(), computed[j][i].to_bits());
            }
        }
    }
}

#[test]
fn agree_with_exact_integrals() {
    for k in [0.0, 0.3, 1.0] {
        let curve = Curve::new(k).expect("inside of the range");
        compare("Curve", k, curve.mass_matrix(), curve.stiffness_matrix());
        let corner = Corner::new(k).expect("inside of the range");
        compare("Corner", k, corner.mass_matrix(), corner.stiffness_matrix());
        let sheet = Sheet::new(k).expect("inside of the range");
        compare("Sheet", k, sheet.mass_matrix(), sheet.stiffness_matrix());
    }
    let solid = Solid::<f64>::new();
    compare("Solid", 0.0, solid.mass_matrix(), solid.stiffness_matrix());
    let constant = Constant::<f64>::new();
    assert_eq!((constant.mass_matrix(), constant.stiffness_matrix()), ([[2.0]], [[0.0]]));
}

/// Twice the area times 1/12 and 1/24, and the well-known element matrix of the Laplace operator.
#[test]
fn of_linear_functions_on_a_triangle() {
    basis_runtime::basis! {
        family Linear { domain triangle (u, v, w); b[0] = u; b[1] = v; b[2] = w; }
    }
    let (m, o) = (1.0 / 12.0, 1.0 / 24.0);
    assert_eq!(Linear::<f64>::new().mass_matrix(), [[m, o, o], [o, m, o], [o, o, m]]);
    assert_eq!(
        Linear::<f64>::new().stiffness_matrix(),
        [[0.5, 0.0, -0.5], [0.0, 0.5, -0.5], [-0.5, -0.5, 1.0]]
    );
}
