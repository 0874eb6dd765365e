//! Missing and doubled functions, a gap in the indices.
use basis_runtime::basis;

basis! {
    family Gap {
        domain 0 <= t <= 1;
        b[0] = 1 - t;
        b[3] = t;
    }
    family Twice {
        domain 0 <= t <= 1;
        b[0] = 1 - t;
        b[0] = t;
    }
    family Late {
        domain 0 <= t <= 1;
        b[1] = t;
    }
    family Nothing {
        domain 0 <= t <= 1;
    }
}

fn main() {}
