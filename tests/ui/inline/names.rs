//! Unknown and doubled names, on the token itself.
use basis_runtime::basis;

basis! {
    family Unknown {
        domain 0 <= t <= 1;
        shape 0 <= lambda <= 1;
        b[0] = 1 - lamda*t;
        b[1] = x;
        prove b[0] = c;
        prove 1 = 1;
    }
    family Doubled {
        domain 0 <= t <= 1;
        shape 0 <= λ <= 1;
        shape 0 <= λ <= 2;
        let c = 1;
        let c = 2;
        b[0] = c*λ;
    }
    family Doubled {
        domain 0 <= t <= 1;
        b[0] = t;
    }
}

fn main() {}
