//! A ramp for a motor, without the standard library and without an allocator.
//!
//! `cargo build -p basis-example-no-std --lib --target thumbv7em-none-eabihf` builds it for a microcontroller (after
//! `rustup target add thumbv7em-none-eabihf`), `cargo run -p basis-example-no-std` prints the ramp on the desk.
#![no_std]

use basis_runtime::{Curve, ShapeError, basis};

basis! {
    /// From 0 to 1 with velocity 0 at both ends; the larger s, the steeper the middle.
    family Ramp {
        domain 0 <= t <= 1;
        shape -1 <= s <= 2;
        b[0] = (1 - t)^2*(1 + 2*t) + s*t^2*(1 - t)^2*(1 - 2*t);
        b[1] = t^2*(3 - 2*t) - s*t^2*(1 - t)^2*(1 - 2*t);
        prove partition_of_unity;
        prove nonnegative;
        prove D(b[1]) >= 0; // it never turns back
        prove at t = 0 { D(b) = [0, 0]; }
        prove at t = 1 { D(b) = [0, 0]; }
    }
}

/// A movement from one angle to another in radians.
#[derive(Clone, Copy, Debug)]
pub struct Movement(Curve<Ramp<f32>, f32>);

impl Movement {
    /// The movement between two angles, as steep in the middle as `s` says.
    ///
    /// # Errors
    /// When `s` is not in its range, -1 to 2.
    pub fn new(from: f32, to: f32, s: f32) -> Result<Self, ShapeError> {
        Ok(Self(Curve::new(Ramp::new(s)?, [from, to])))
    }

    /// The angle and the angular velocity at a time from 0 to 1.
    pub fn at(&self, time: f32) -> [f32; 2] {
        self.0.eval_with_derivs(time)
    }
}

#[cfg(test)]
mod tests {
    use super::Movement;

    #[test]
    fn begins_and_ends_at_rest() {
        for s in [-1.0, 0.0, 2.0] {
            let movement = Movement::new(0.5, 2.0, s).unwrap();
            assert_eq!(movement.at(0.0), [0.5, 0.0]);
            assert_eq!(movement.at(1.0), [2.0, 0.0]);
            assert!((0..100).all(|i| movement.at(i as f32 / 100.0)[1] > -1e-6));
        }
        assert!(Movement::new(0.0, 1.0, 3.0).is_err());
    }
}
