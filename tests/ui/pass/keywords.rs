//! Families, shape parameters and joins with the names of keywords of any edition.
#![allow(non_camel_case_types)]

basis_runtime::basis! {
    family gen {
        domain 0 <= t <= 1;
        shape 0 <= gen <= 1;
        shape 0 <= async <= 1;
        shape 0 <= dyn <= 1;
        shape 0 <= try <= 1;
        b[0] = gen + async*t + dyn*t^2 + try*t^3;
    }
    family dyn { domain 0 <= t <= 1; b[0] = t; }
    family async { domain 0 <= t <= 1; b[0] = t; }
    family await { domain 0 <= t <= 1; b[0] = t; }
    family try { domain 0 <= t <= 1; b[0] = t; }
    family union { domain 0 <= t <= 1; b[0] = t; }
    family macro_rules { domain 0 <= t <= 1; b[0] = t; }
    family abstract { domain 0 <= t <= 1; b[0] = t; }
    join gen {
        curve P = Bernstein(1);
        curve Q = Bernstein(1);
        let Q[0] = P[1];
        prove P(1) == Q(0);
    }
}

fn main() {
    let family = r#gen::new(1.0, 0.5, 0.25, 0.125).unwrap();
    assert_eq!(family.values(1.0), [1.875]);
    assert_eq!([family.r#gen(), family.r#async(), family.r#dyn(), family.r#try()], [1.0, 0.5, 0.25, 0.125]);
    assert_eq!(r#dyn::new().values(0.5), [0.5]);
    assert_eq!(union::new().values(0.5), [0.5]);
    let points: [f64; 2] = [0.0, 1.0];
    assert_eq!(joins::r#gen(&points), Ok([1.0]));
}
