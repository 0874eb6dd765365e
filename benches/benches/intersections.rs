//! Where cubics meet each other and lines, beside lyon_geom, curvo and kurbo: `cargo bench -p basis-benches --bench
//! intersections`.
//!
//! Prints a table in Markdown. All libraries get the same curves. The places that exist are those that any of them finds
//! and that are places: the points of both curves there are nearer to each other than 1e-8 of the size of the curves. A library
//! misses a place if none of its own is beside it in both parameters, nor has it in its intervals. kurbo knows lines alone.

use std::time::{Duration, Instant};

use basis_benches::Random;
use basis_runtime::{Bezier, Meeting, ParametricCurve};
use curvo::prelude::{HasIntersectionParameter as _, Intersects as _, NurbsCurve2D};
use divan::black_box;
use kurbo::{CubicBez, Line, PathSeg};
use lyon_geom::{CubicBezierSegment, LineSegment};
use nalgebra::Point2;

type P2 = [f64; 2];
type Cubic = [P2; 4];

/// In place of a thousand, what the environment variable `PAIRS` says.
fn pairs() -> usize {
    std::env::var("PAIRS").ok().and_then(|text| text.parse().ok()).unwrap_or(1000)
}

/// How near parameters of one place are.
const BESIDE: f64 = 1e-3;

fn main() {
    let count = pairs();
    println!("| {count} pairs | places | library | missed | µs for a pair |");
    println!("| --- | --- | --- | --- | --- |");
    let mut random = Random::default();
    let pairs: Vec<[Cubic; 2]> = (0..count).map(|_| [random.cubic(), random.cubic()]).collect();
    table("random cubics", &pairs, [Some(&ours), Some(&lyons), Some(&curvos), None]);
    let touching: Vec<[Cubic; 2]> = (0..count).map(|_| touching(&mut random)).collect();
    table("cubics that touch", &touching, [Some(&ours), Some(&lyons), Some(&curvos), None]);
    let lines: Vec<[Cubic; 2]> = (0..count).map(|_| [random.cubic(), line(&random.cubic())]).collect();
    table(
        "cubics and lines",
        &lines,
        [Some(&our_lines), Some(&lyon_lines), Some(&curvos), Some(&kurbo_lines)],
    );
}

/// Parameters at which a library says that two curves meet, and the intervals in which they do.
struct Answer {
    at: [f64; 2],
    around: [[f64; 2]; 2],
}

impl Answer {
    /// Of a library that knows places alone.
    fn alone(s: f64, t: f64) -> Self {
        Self { at: [s, t], around: [[s, s], [t, t]] }
    }

    fn is_of(&self, place: [f64; 2]) -> bool {
        let [s, t] = place;
        let [first, second] = self.around;
        beside(self.at, place) || first[0] <= s && s <= first[1] && second[0] <= t && t <= second[1]
    }
}

impl From<&Meeting<P2>> for Answer {
    fn from(meeting: &Meeting<P2>) -> Self {
        Self { at: meeting.at, around: [meeting.first, meeting.second] }
    }
}

/// The places at which a library says that two curves meet.
type Finds<'a> = Option<&'a dyn Fn(&[Cubic; 2]) -> Vec<Answer>>;

fn table(name: &str, pairs: &[[Cubic; 2]], libraries: [Finds<'_>; 4]) {
    let found: Vec<Vec<Vec<Answer>>> =
        libraries.iter().map(|finds| finds.map_or(Vec::new(), |f| pairs.iter().map(f).collect())).collect();
    let mut places: Vec<Vec<[f64; 2]>> = vec![Vec::new(); pairs.len()];
    for answers in &found {
        for ((places, answers), pair) in places.iter_mut().zip(answers).zip(pairs) {
            for &Answer { at, .. } in answers {
                if is_place(pair, at) && !places.iter().any(|&place| beside(place, at)) {
                    places.push(at);
                }
            }
        }
    }
    let total: usize = places.iter().map(Vec::len).sum();
    // In turns, so that all of them have the same weather.
    let mut best = [Duration::MAX; 4];
    for _ in 0..20 {
        for (best, finds) in best.iter_mut().zip(&libraries) {
            let Some(finds) = finds else { continue };
            let start = Instant::now();
            for pair in pairs {
                black_box(finds(black_box(pair)));
            }
            *best = start.elapsed().min(*best);
        }
    }
    for (k, library) in ["ours", "lyon_geom", "curvo", "kurbo"].into_iter().enumerate() {
        if libraries[k].is_none() {
            continue;
        }
        let missed: usize = places
            .iter()
            .zip(&found[k])
            .map(|(places, own)| {
                places.iter().filter(|&&p| !own.iter().any(|answer| answer.is_of(p))).count()
            })
            .sum();
        let micros = 1e6 * best[k].as_secs_f64() / pairs.len() as f64;
        println!("| {name} | {total} | {library} | {missed} | {micros:.2} |");
    }
}

fn beside(a: [f64; 2], b: [f64; 2]) -> bool {
    (0..2).all(|k| (a[k] - b[k]).abs() <= BESIDE)
}

fn is_place([a, b]: &[Cubic; 2], at: [f64; 2]) -> bool {
    let (p, q) = (Bezier::from_points(*a).eval(at[0]), Bezier::from_points(*b).eval(at[1]));
    (p[0] - q[0]).hypot(p[1] - q[1]) <= 1e-8
}

/// The straight line between both ends, as a cubic.
fn line(&[from, .., to]: &Cubic) -> Cubic {
    [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0].map(|x| [0, 1].map(|d| from[d] + x * (to[d] - from[d])))
}

fn ours([a, b]: &[Cubic; 2]) -> Vec<Answer> {
    let found = Bezier::from_points(*a).intersections(&Bezier::from_points(*b), 1e-9);
    found.unwrap_or_default().iter().map(Answer::from).collect()
}

fn our_lines([a, b]: &[Cubic; 2]) -> Vec<Answer> {
    let found = Bezier::from_points(*a).intersections(&Bezier::from_points([b[0], b[3]]), 1e-9);
    found.unwrap_or_default().iter().map(Answer::from).collect()
}

fn lyon(points: &Cubic) -> CubicBezierSegment<f64> {
    let [from, ctrl1, ctrl2, to] = points.map(lyon_geom::Point::from);
    CubicBezierSegment { from, ctrl1, ctrl2, to }
}

fn lyons([a, b]: &[Cubic; 2]) -> Vec<Answer> {
    lyon(a).cubic_intersections_t(&lyon(b)).iter().map(|&(s, t)| Answer::alone(s, t)).collect()
}

fn lyon_lines([a, b]: &[Cubic; 2]) -> Vec<Answer> {
    let [from, to] = [b[0], b[3]].map(lyon_geom::Point::from);
    lyon(a)
        .line_segment_intersections_t(&LineSegment { from, to })
        .iter()
        .map(|&(s, t)| Answer::alone(s, t))
        .collect()
}

fn curvos(pair: &[Cubic; 2]) -> Vec<Answer> {
    let [a, b] = pair.map(|points| NurbsCurve2D::bezier(&points.map(Point2::from)));
    let found = a.find_intersection(&b, None).unwrap_or_default();
    found.iter().map(|meeting| Answer::alone(meeting.a_parameter(), meeting.b_parameter())).collect()
}

fn kurbo_lines([a, b]: &[Cubic; 2]) -> Vec<Answer> {
    let [p0, p1, p2, p3] = a.map(|[x, y]| kurbo::Point::new(x, y));
    let [from, to] = [b[0], b[3]].map(|[x, y]| kurbo::Point::new(x, y));
    let line = Line::new(from, to);
    let found = PathSeg::Cubic(CubicBez { p0, p1, p2, p3 }).intersect_line(line);
    found.iter().map(|meeting| Answer::alone(meeting.segment_t, meeting.line_t)).collect()
}

/// A cubic, and another one that touches it at a random point of both.
fn touching(random: &mut Random) -> [Cubic; 2] {
    let (first, second) = (random.cubic(), random.cubic());
    let [s, t] = [0.1 + 0.8 * random.unit(), 0.1 + 0.8 * random.unit()];
    let [point, velocity] = Bezier::from_points(first).eval_with_derivs(s);
    let [other, slope] = Bezier::from_points(second).eval_with_derivs(t);
    // Turned so that the tangents are parallel, and moved so that the points coincide.
    let angle = velocity[1].atan2(velocity[0]) - slope[1].atan2(slope[0]);
    let (sin, cos) = angle.sin_cos();
    let turned = second.map(|[x, y]| {
        let (x, y) = (x - other[0], y - other[1]);
        [point[0] + cos * x - sin * y, point[1] + sin * x + cos * y]
    });
    [first, turned]
}
