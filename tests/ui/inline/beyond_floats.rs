//! Numbers beyond f64: the spec is exact and true, but no code can be generated for it.
use basis_runtime::basis;

basis! {
    family Large {
        domain 0 <= t <= 1;
        b[0] = t*10^309;
        prove nonnegative;
    }
    family Small {
        domain 0 <= t <= 1;
        b[0] = t/10^320;
    }
    family Wide {
        domain 0 <= t <= 10^400;
        b[0] = t;
    }
    family Shaped {
        domain 0 <= t <= 1;
        shape 0 <= k <= 10^400;
        b[0] = k*t;
    }
    family OnATriangle {
        domain triangle (u, v, w);
        b[0] = u*10^309;
    }
    family OfHighDegree {
        domain 0 <= t <= 10^10;
        b[0] = t^40;
    }
    join Far {
        scalar 10^400 <= c;
        curve P = Bernstein(1);
        curve Q = Bernstein(1);
        let Q[0] = P[0] + c*(P[1] - P[0]);
        prove Q(0) == P(0) + c*D(P)(0);
    }
}

fn main() {}
