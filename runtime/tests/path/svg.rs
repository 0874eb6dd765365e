//! The attribute `d` of SVG paths, in and out.

use std::f64::consts::PI;

use basis_runtime::{Bezier, CurveError, ParametricCurve, Path, SvgMistake, to_svg};

use crate::closed;
use crate::random::Random;

fn read(text: &str) -> Vec<Path<[f64; 2]>> {
    Path::from_svg(text).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn points(path: &Path<[f64; 2]>) -> Vec<Vec<[f64; 2]>> {
    path.segments().iter().map(|s| s.control_points().to_vec()).collect()
}

#[test]
fn absolute_and_relative_commands_say_the_same() {
    let absolute = "M 10 20 L 30 40 H 50 V 10 C 60 10 70 20 70 30 S 60 50 50 50 Q 40 60 30 50 T 10 50 A 5 6 30 0 1 12 56 Z";
    let relative = "m10,20l20,20h20v-30c10,0,20,10,20,20s-10,20-20,20q-10,10-20,0t-20,0a5,6,30,0,1,2,6z";
    let ([a], [b]) = (&read(absolute)[..], &read(relative)[..]) else { panic!("one path each") };
    assert_eq!(points(a), points(b));
    let found = points(a);
    assert_eq!(found[4], [[70.0, 30.0], [70.0, 40.0], [60.0, 50.0], [50.0, 50.0]]); // S: (60, 10)–(70, 30) mirrored
    assert_eq!(found[6], [[30.0, 50.0], [20.0, 40.0], [10.0, 50.0]]);
    assert!(a.is_closed());
}

#[test]
fn compact_numbers_flags_and_repeated_commands() {
    assert_eq!(
        points(&read("M.5.5-1-1e1,2E-1+3")[0]),
        [[[0.5, 0.5], [-1.0, -10.0]], [[-1.0, -10.0], [0.2, 3.0]]]
    );
    let [a, b] = ["M0 0a1 1 0 01.5.5", "M0,0 A 1 1 0 0 1 0.5 0.5"].map(|text| points(&read(text)[0]));
    assert_eq!(a, b);
    // Without a curve before it the handle is where the pen is; after a quadratic `S` has none.
    assert_eq!(points(&read("M1 1S2 2 3 1")[0])[0][1], [1.0, 1.0]);
    assert_eq!(points(&read("M0 0Q1 1 2 0S3 1 4 0")[0])[1][1], [2.0, 0.0]);
    assert_eq!(points(&read("M0 0L1 1T3 1")[0])[1][1], [1.0, 1.0]);
}

#[test]
fn parts() {
    let paths = read("M0 0L1 0L1 1ZM5 5L6 5 m1 1 l1 0 z l0 2");
    assert_eq!(paths.len(), 4);
    assert!(paths[0].is_closed() && !paths[1].is_closed());
    assert_eq!(paths[0].segments().len(), 3); // the line back
    assert_eq!(points(&paths[2]), [[[7.0, 6.0], [8.0, 6.0]], [[8.0, 6.0], [7.0, 6.0]]]);
    assert_eq!(points(&paths[3]), [[[7.0, 6.0], [7.0, 8.0]]]); // after `z` from its start
    assert_eq!(read(""), []);
    assert_eq!(read("  M 1 1 "), []);
    assert_eq!(read("M1 1ZL2 2").len(), 1);
    // A path that comes back by itself gets no further line.
    assert_eq!(read("M0 0L1 0L0 0Z")[0].segments().len(), 2);
}

#[test]
fn arcs_lie_on_their_ellipse() {
    let mut random = Random::new(21);
    for _ in 0..300 {
        let number = |random: &mut Random, most: f64| -> f64 { random.between(-most, most) };
        let (rx, ry) = (number(&mut random, 3.0).abs() + 0.2, number(&mut random, 3.0).abs() + 0.2);
        let (turn, end) = (number(&mut random, 400.0), [number(&mut random, 2.0), number(&mut random, 2.0)]);
        let (large, sweep) = (random.below(2), random.below(2));
        let text = format!("M0 0A{rx} {ry} {turn} {large} {sweep} {} {}", end[0], end[1]);
        let arc = &read(&text)[0];
        assert_eq!((arc.start(), arc.end()), ([0.0, 0.0], end));
        // In the frame of the ellipse, scaled to a circle.
        let (sin, cos) = turn.to_radians().sin_cos();
        let circle = arc.map(|[x, y]| [(cos * x + sin * y) / rx, (cos * y - sin * x) / ry]);
        let chord = circle.end()[0].hypot(circle.end()[1]);
        let radius = (chord / 2.0).max(1.0);
        let length = circle.arclen(1e-10) / radius;
        let short = 2.0 * (chord / 2.0 / radius).min(1.0).asin();
        let expected = if large == 1 { 2.0 * PI - short } else { short };
        let slack = if radius > 1.0 { 1e-6 } else { 1e-8 };
        assert!((length - expected).abs() < slack, "{text}: {length} {expected}");
        let bend = circle.curvature(0.5);
        assert!((bend.abs() * radius - 1.0).abs() < 1e-8 && (bend > 0.0) == (sweep == 1), "{text} {bend}");
    }
    assert_eq!(points(&read("M0 0A0 5 0 0 0 3 3")[0]), [[[0.0, 0.0], [3.0, 3.0]]]);
    assert_eq!(read("M0 0A5 5 0 0 0 0 0"), []);
}

#[test]
fn what_is_written_is_read_back() {
    let mut random = Random::new(22);
    for _ in 0..100 {
        let drawn = closed(&mut random, 3).to_cubics(1e-3).unwrap();
        let text = to_svg(&drawn, 1e-9).unwrap();
        assert_eq!(read(&text), [drawn], "{text}");
        let single = Bezier::from_points([0; 4].map(|_| [random.between::<f32>(-9.0, 9.0), random.wild()]));
        let again = &Path::<[f32; 2]>::from_svg(&to_svg(&single, 1.0).unwrap()).unwrap()[0];
        assert_eq!(again.segments()[0].control_points(), single.control_points());
    }
}

#[test]
fn arcs_are_written_as_arcs() {
    let circle = Path::<[f64; 2]>::circle([1.0, 1.0], 1.0);
    assert_eq!(
        to_svg(&circle, 1e-6).unwrap(),
        "M2 1A1 1 0 0 1 1 2A1 1 0 0 1 0 1A1 1 0 0 1 1 0A1 1 0 0 1 2 1Z"
    );
    let mut random = Random::new(23);
    for _ in 0..200 {
        let radii: [f64; 2] = [random.between(0.1, 4.0), random.between(0.1, 4.0)];
        let centre = [random.between(-3.0, 3.0), random.between(-3.0, 3.0)];
        let whole = Path::ellipse(centre, radii, random.between(-4.0, 4.0));
        let (from, to) = (random.between(0.0, 4.0), random.between(0.0, 4.0));
        let arc = whole.subsegment(from..to).unwrap();
        let text = to_svg(&arc, 1e-6).unwrap();
        assert!(!text.contains('C'), "{text}");
        let again = &read(&text)[0];
        for point in arc.samples(33) {
            let away = again.nearest(point, 1e-10).unwrap().distance;
            assert!(away < 1e-7, "{text}: {away}");
        }
        assert!((again.arclen(1e-9) - arc.arclen(1e-9)).abs() < 1e-6);
    }
}

#[test]
fn other_curves_are_written_within_the_tolerance() {
    let mut random = Random::new(24);
    for _ in 0..20 {
        let path = closed(&mut random, 2);
        let again = &read(&to_svg(&path, 1e-3).unwrap())[0];
        for point in path.samples(101) {
            assert!(again.nearest(point, 1e-9).unwrap().distance <= 1e-3);
        }
    }
    let mut two = Path::rectangle([[0.0, 0.0], [1.0, 1.0]]);
    two.append(&Bezier::from_points([[1e-9, 3.0], [5.0, 4.0]]));
    assert_eq!(to_svg(&two, 0.1).unwrap(), "M0 0L1 0L1 1L0 1L0 0ZM1e-9 3L5 4");
    let long = Bezier::from_points([[0.0, 0.0], [5e20, -1.0]]);
    assert_eq!(to_svg(&long, 0.1).unwrap(), "M0 0L5e20-1");
    let space = Bezier::from_points([[0.0, 0.0, 1.0], [1.0, 0.0, 2.0]]);
    assert_eq!(to_svg(&space, 0.1), Err(CurveError::Dimension { expected: 2, found: 3 }));
    let infinite = Bezier::from_points([[0.0, f64::NAN], [1.0, 0.0]]);
    assert_eq!(to_svg(&infinite, 0.1), Err(CurveError::NotFinite));
}

#[test]
fn mistakes_have_a_place() {
    for (text, mistake, offset) in [
        ("L 1 1", SvgMistake::NoMove, 0),
        ("1 1", SvgMistake::Command('1'), 0),
        ("M 1", SvgMistake::Number { command: 'M', takes: 2 }, 3),
        ("M 1 1 L 2", SvgMistake::Number { command: 'L', takes: 2 }, 9),
        ("M1 1X", SvgMistake::Command('X'), 4),
        ("M1 1é", SvgMistake::Command('é'), 4),
        ("M1 1A1 1 0 2 0 3 3", SvgMistake::Flag, 11),
        ("M1e999 1", SvgMistake::Size, 1),
        ("M1 1Z5", SvgMistake::Command('5'), 5),
        ("M1,1,L2 2", SvgMistake::Command(','), 4),
        ("M1 1L2,,2", SvgMistake::Number { command: 'L', takes: 2 }, 7),
        ("M1 1 L", SvgMistake::Number { command: 'L', takes: 2 }, 6),
    ] {
        let error = Path::<[f64; 2]>::from_svg(text).unwrap_err();
        assert_eq!((error.mistake(), error.offset()), (mistake, offset), "{text}");
    }
}

#[test]
fn no_text_breaks_the_reader() {
    let mut random = Random::new(25);
    let alphabet: Vec<char> = "MmLlHhVvCcSsQqTtAaZz0123456789.-+eE, \n\u{e9}".chars().collect();
    let mut good = 0;
    for _ in 0..20_000 {
        let len = random.below(24);
        let text: String =
            "M0 0".chars().chain((0..len).map(|_| alphabet[random.below(alphabet.len())])).collect();
        match Path::<[f32; 2]>::from_svg(&text) {
            Ok(_) => good += 1,
            Err(error) => assert!(text.is_char_boundary(error.offset()), "{text:?} {error}"),
        }
    }
    assert!(good > 100);
}

/// The shortest decimals of small and large numbers, in both scalar types.
#[test]
fn numbers_with_exponents() {
    let line = |x: f32| Path::polyline(&[[0.0, 0.0], [x, 0.0]]).unwrap();
    for (x, text) in [
        (1e-6, "M0 0L1e-6 0"),
        (-1.25e-7, "M0 0L-1.25e-7 0"),
        (1e-45, "M0 0L1e-45 0"),
        (2e-5, "M0 0L0.00002 0"),
        (f32::MAX, "M0 0L3.4028235e38 0"),
        (1e20, "M0 0L1e20 0"),
    ] {
        assert_eq!(to_svg(&line(x), 1e-3).unwrap(), text);
        let [again] = Path::<[f32; 2]>::from_svg(text).unwrap().try_into().unwrap();
        assert_eq!(again.end(), [x, 0.0]);
    }
    for x in [1.5e-300, 5e-324, f64::MAX, -1e-6, 1.0 / 3e9] {
        let path = Path::polyline(&[[0.0, 0.0], [x, 0.0]]).unwrap();
        let text = to_svg(&path, 1e-3).unwrap();
        assert_eq!(text, format!("M0 0L{x:e} 0"));
        assert_eq!(read(&text)[0].end(), [x, 0.0]);
    }
}

/// What is finite as a number of the text need not be one of the path.
#[test]
fn numbers_that_are_too_large() {
    let mistake = |text: &str| Path::<[f32; 2]>::from_svg(text).map_err(|e| (e.mistake(), e.offset()));
    assert_eq!(mistake("M0 0L1e39 0"), Err((SvgMistake::Size, 5)));
    assert_eq!(mistake("M-1e39 0L1 0"), Err((SvgMistake::Size, 1)));
    assert_eq!(mistake("M0 0A1e39 1 0 0 0 1 1"), Err((SvgMistake::Size, 5)));
    assert_eq!(mistake("M3e38 0l3e38 0"), Err((SvgMistake::Size, 8)));
    assert_eq!(mistake("M3e38 0m3e38 0l0 0"), Err((SvgMistake::Size, 8)));
    assert_eq!(mistake("M0 0C0 0-3e38 0 3e38 0S1 1 2 2"), Err((SvgMistake::Size, 23)));
    assert!(mistake("M0 0L3e38 0").is_ok());
    let error = Path::<[f64; 2]>::from_svg("M1e308 0l1e308 0").unwrap_err();
    assert_eq!((error.mistake(), error.offset()), (SvgMistake::Size, 9));
}

/// Whether a curve has a segment that needs the tolerance or not, it is a positive number.
#[test]
fn the_tolerance_is_a_positive_number() {
    let polygon = Path::rectangle([[1.0, 1.0], [2.0, 3.0]]);
    let quintic =
        Bezier::from_points([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0], [3.0, 1.0], [4.0, 0.0], [5.0, 2.0]]);
    for tolerance in [f64::NAN, 0.0, -1.0, f64::INFINITY] {
        for error in [to_svg(&polygon, tolerance), to_svg(&quintic, tolerance)] {
            assert!(matches!(error, Err(CurveError::Tolerance { .. })), "{error:?}");
        }
    }
}
