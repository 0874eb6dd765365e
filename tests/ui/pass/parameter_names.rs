//! Shape parameters with names of Rust's keywords, of local names, and of other alphabets.
#![deny(warnings)]

basis_runtime::basis! {
    family Names {
        domain -1 <= u <= 1;
        shape type; shape loop; shape t; shape s; shape x; shape c0; shape r0; shape points; shape order; shape S;
        shape P; shape f64; shape core; shape Δ_1; shape φ; shape é; shape value; shape λ12;
        b[0] = type + loop + t + s + x + c0 + r0 + points + order + S + P + f64 + core + Δ_1 + φ + é + value + λ12*u;
        b[1] = (1 - u)^2*x/(1 + s^2);
    }
}

fn main() {
    let names = Names::new(
        1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 13.0, 14.0, 15.0, 16.0, 17.0, 18.0_f64,
    )
    .unwrap();
    assert_eq!(names.values(1.0), [171.0, 0.0]);
    assert_eq!(names.values(-1.0)[0], 135.0);
    assert_eq!([names.r#type(), names.r#loop(), names.t(), names.Delta_1(), names.phi()], [1.0, 2.0, 3.0, 14.0, 15.0]);
    assert_eq!(names.lambda12(), 18.0);
}
