//! Prints the ramp, on a machine that has a screen.

use basis_example_no_std::Movement;

fn main() {
    let movement = Movement::new(0.0, std::f32::consts::PI, 1.0).expect("1 is in the range");
    println!("time  angle  velocity");
    for i in 0..=8 {
        let time = i as f32 / 8.0;
        let [angle, velocity] = movement.at(time);
        println!("{time:5.3} {angle:6.4}  {velocity:6.4}");
    }
}
