//! Families with the names of types and traits that generated code uses.

macro_rules! in_its_module {
    ($($module:ident $name:ident),*) => {$(
        mod $module {
            basis_runtime::basis! {
                family $name {
                    domain 0 <= t <= 2;
                    shape 0 <= λ <= 1;
                    b[0] = 1 - λ*t/2;
                    b[1] = λ*t/2;
                    prove partition_of_unity;
                }
            }
            pub fn middle() -> [f64; 2] {
                $name::new(0.5).unwrap().values(1.0)
            }
        }
        assert_eq!($module::middle(), [0.75, 0.25]);
    )*};
}

fn main() {
    in_its_module! {
        option Option, result Result, vec Vec, string String, some Some, ok Ok, copy Copy, clone Clone, debug Debug,
        default Default, partial_eq PartialEq, basis Basis, scalar Scalar, point Point, curve Curve, form Form,
        values Values, points Points, bernstein Bernstein, array Array, phantom PhantomData, bound Bound,
        shape_error ShapeError, endpoint EndpointForm, core core, snake_case snake_case
    }
}
