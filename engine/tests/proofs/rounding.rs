//! Rounding errors beside their proved bounds: no error is larger, on any family of the library.

use basis_engine::algebra::rational::{Rational, ToFloat as _};
use basis_engine::model::Factor;
use basis_engine::plan::Input;
use basis_engine::rounding::{self, Error};
use basis_engine::steps::{FamilySteps, Steps};
use basis_engine::{Disk, Family, Library, Prover, Selected, Source, Subject, Verdict};

/// Numbers that look random and are the same in every run.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 33
    }

    /// A float between two others: often an end of the range or next to one.
    fn between(&mut self, low: f32, high: f32) -> f32 {
        let inside = low + (high - low) * (self.next() as f32 / (1_u64 << 31) as f32);
        match self.next() % 8 {
            0 => low,
            1 => high,
            2 => high.next_down(),
            3 => (low + (high - low) * 0.5f32.powi((self.next() % 12) as i32)).clamp(low, high),
            _ => inside.clamp(low, high),
        }
    }
}

/// A float as the rational number that it is.
fn exact(x: f32) -> Rational {
    let (mut halvings, mut x) = (0, f64::from(x));
    while x.fract() != 0.0 {
        x *= 2.0;
        halvings += 1;
    }
    &Rational::from(x as i64) * &Rational::new(1, 2).pow(halvings)
}

/// Finite ends of a range inside of a declared one.
fn ends(range: &basis_engine::algebra::range::Range) -> [f32; 2] {
    let end = |end: Option<&Rational>| end.map(|x| x.to_f64() as f32);
    match (end(range.low.value()), end(range.high.value())) {
        (Some(a), Some(b)) => [a, b],
        (Some(a), None) => [a, a + 8.0],
        (None, Some(b)) => [b - 8.0, b],
        (None, None) => [-8.0, 8.0],
    }
}

fn inside(random: &mut Random, range: &basis_engine::algebra::range::Range) -> f32 {
    let [low, high] = ends(range);
    loop {
        // No smaller than 2⁻¹⁰, or zero, so that the exact values stay short and nothing underflows.
        let x = random.between(low, high);
        let x = if x.abs() < 1.0 / 1024.0 { 0.0 } else { x };
        if range.contains(&exact(x)) {
            return x;
        }
    }
}

/// A point of the domain; barycentric coordinates add up to 1 exactly.
fn coordinates(family: &Family, random: &mut Random) -> Vec<f32> {
    let mut all = Vec::new();
    for factor in family.factors() {
        let corners = match factor {
            Factor::Interval(p) => {
                all.push(inside(random, &p.range));
                continue;
            }
            Factor::Simplex(independent, _) => independent.len() + 1,
        };
        let whole = 1_u64 << 10;
        let mut cuts: Vec<u64> =
            (1..corners).map(|_| [0, whole, random.next() % whole][random.next() as usize % 3]).collect();
        cuts.extend([0, whole]);
        cuts.sort_unstable();
        all.extend(cuts.windows(2).map(|pair| (pair[1] - pair[0]) as f32 / whole as f32));
    }
    all
}

/// The largest of the ratios of errors and bounds at some random inputs; no error is beyond its bound.
fn largest_ratio(family: &Family, steps: &Steps, bounds: &[Option<Error>], random: &mut Random) -> f64 {
    let epsilon = Rational::new(1, 1 << 23);
    let mut largest = 0.0_f64;
    for _ in 0..60 {
        let shapes: Vec<f32> = family.shapes.iter().map(|p| inside(random, &p.range)).collect();
        let coordinates = coordinates(family, random);
        let points: Vec<f32> = (0..family.functions.len()).map(|_| random.between(-1.0, 1.0)).collect();
        let points: Vec<f32> =
            points.into_iter().map(|p| if p.abs() < 1.0 / 1024.0 { 1.0 } else { p }).collect();
        let input = |input: Input| match input {
            Input::Shape(k) => shapes[k],
            Input::Coordinate(k) => coordinates[k],
            Input::Point(k) => points[k],
            Input::Derivative(_) | Input::Bound(_) => unreachable!("not an input of values"),
        };
        // The bounds are about what does not underflow.
        let Some(trace) = steps.trace::<f32>(input) else { continue };
        let exact_trace = steps.trace::<f64>(|i| f64::from(input(i))).unwrap_or_default();
        if exact_trace.iter().any(|x| *x != 0.0 && x.abs() < f64::from(f32::MIN_POSITIVE)) {
            continue;
        }
        let computed: Vec<f32> = steps.outputs.iter().map(|output| trace[*output]).collect();
        let Some(values) = steps.evaluate::<Rational>(|i| exact(input(i))) else { continue };
        for ((computed, value), bound) in computed.iter().zip(&values).zip(bounds) {
            let Some(bound) = bound else { continue };
            let error = (&exact(*computed) - value).abs();
            let allowed = match bound {
                Error::Relative(k) => &(k * &epsilon) * &value.abs(),
                Error::Absolute(k) => k * &epsilon,
            };
            assert!(
                error <= allowed,
                "{}: {computed} for {value}, an error of {}, at {shapes:?}, {coordinates:?}, {points:?}",
                family.title(),
                error.to_f64() / epsilon.to_f64()
            );
            if !allowed.is_zero() {
                largest = largest.max(error.to_f64() / allowed.to_f64());
            }
        }
    }
    largest
}

#[test]
fn no_error_is_beyond_its_bound() {
    let random = &mut Random(7);
    let (mut counts, mut patches, mut spanned) = ([0; 3], [0; 2], [0; 2]);
    for (name, text) in basis_specs::SPECS {
        let library = Library::from_source(&Disk, &Prover, Source::text(format!("{name}.basis"), text));
        let mut last = String::new();
        for item in library.items(Selected::EveryOrder) {
            let Subject::Family(family) = &item.subject else { continue };
            if family.name == last {
                continue;
            }
            last.clone_from(&family.name);
            // Sines have no exact values, and nothing is proved of knots that are shape values.
            let spans: Vec<&Family> = match family.pieces.as_slice() {
                [] => vec![family],
                pieces => pieces.iter().map(|piece| &**piece).collect(),
            };
            let known = |_: &FamilySteps<'_>| spans.iter().all(|span| span.analytic.is_empty());
            let Some(steps) = FamilySteps::new(family).filter(known) else { continue };
            let bounds: Vec<Option<Error>> = rounding::values(family)
                .unwrap_or_default()
                .into_iter()
                .map(|b| b.map(|b| b.error))
                .collect();
            for bound in &bounds {
                counts[match bound {
                    Some(Error::Relative(_)) => 0,
                    Some(Error::Absolute(_)) => 1,
                    None => 2,
                }] += 1;
            }
            for (k, span) in spans.iter().enumerate() {
                largest_ratio(span, &steps.on_span(k).values(), &bounds, random);
            }
            if spans.len() > 1 {
                spanned[usize::from(bounds.iter().flatten().count() == family.functions.len())] += 1;
                continue;
            }
            let none = vec![0; family.domain.len()];
            let point = steps.curve(1).or_else(|| steps.patch(&none)).expect("a curve or a patch");
            let bound = rounding::point(family);
            if family.interval().is_none() {
                patches[usize::from(bound.is_some())] += 1;
            }
            if let Some(bound) = bound {
                // Exact values of long sums of products take long.
                if family.functions.len() <= 21 {
                    largest_ratio(family, &steps.on_control_points(&point), &[Some(bound.error)], random);
                }
            }
        }
    }
    let [relative, absolute, none] = counts;
    // Functions that change their sign have absolute ones, some with shape values in a denominator and without end none.
    assert!(relative > 5 * absolute && relative > 10 * none, "{counts:?}");
    // Of a patch with a shape parameter in a denominator there is none.
    assert!(patches[1] > 10 * patches[0], "{patches:?}");
    assert!(spanned[1] > 2 * spanned[0], "{spanned:?}");
}

/// The least claim, in hundredths of ε, that is proved is the largest bound of a function. So it is on several spans,
/// where a function may have a relative bound on one and not on another, and where a claim is decided first with little
/// work.
#[test]
fn claims_say_what_bounds_say() {
    let families = [
        "domain 0 <= x <= 1, 1 <= x <= 2; shape 0 <= c <= 1; \
         f[0] = 1000*(x + c)*(1 + x + c*x^2) | (3/2 - x)*(1 + c);",
        "domain triangle (u, v, w); shape 0 <= a <= 2, -1 <= c <= 1; \
         f[0] = u^2*(1 + a*v); f[1] = (u - w)*(1 + c*v)/(1 + a + a^2);",
        "domain 3 <= t <= 4; shape 5 <= s <= 6; f[0] = (s*t - 12)^2; f[1] = (t - 2)*(6 - t)/(s + t);",
    ];
    for text in families {
        let family = |claim: &str| format!("family F {{ {text} {claim} }}");
        let library = |spec: &str| Library::from_source(&Disk, &Prover, Source::text("claims.basis", spec));
        let alone = library(&family(""));
        let items = alone.items(Selected::EveryOrder);
        let Subject::Family(subject) = &items[0].subject else { panic!("a family") };
        let bounds = rounding::values(subject).unwrap();
        let largest = bounds.into_iter().map(|bound| bound.unwrap().error.epsilons().clone()).max().unwrap();
        for (claimed, is_proved) in [(largest.clone(), true), (&largest - &Rational::new(1, 100), false)] {
            let library = library(&family(&format!("prove rounding <= {claimed};")));
            let checked = basis_engine::decide_all(
                library.items(Selected::EveryOrder),
                &mut basis_engine::state::Run::default(),
            );
            let (_, verdict) = &checked[0].claims[0];
            assert_eq!(matches!(verdict, Verdict::Proved(_)), is_proved, "{text} {claimed} {verdict:?}");
        }
    }
}

/// On several spans a function has one bound: relative where it is on all of them.
#[test]
fn spans_have_bounds_in_common() {
    let spec = "family Hump { domain 0 <= x <= 1, 1 <= x <= 5/2; shape 0 <= c <= 1; \
                f[0] = x^2*(1 + c*x) | (5/2 - x)*(1 + c)*2/3; f[1] = 1 - x | (x - 1)*(x - 2); f[2] = 0 | (x - 1)^3; } \
                family Thirds { domain 0 <= x <= 1/3, 1/3 <= x <= 1; f[0] = x | 1/3; } \
                family Parts { shape 0 < h; shape 0 < k; domain 0 <= x <= h, h <= x <= h + 3*k; \
                f[0] = x^2/h^2 | (h + 3*k - x)^3/(27*k^3); f[1] = x | h; }";
    let library = Library::from_source(&Disk, &Prover, Source::text("hump.basis", spec));
    let families = library.items(Selected::EveryOrder);
    let Subject::Family(family) = &families[0].subject else { panic!("a family") };
    let bounds: Vec<Option<Error>> =
        rounding::values(family).unwrap().into_iter().map(|b| b.map(|b| b.error)).collect();
    assert!(matches!(
        bounds[..],
        [Some(Error::Relative(_)), Some(Error::Absolute(_)), Some(Error::Relative(_))]
    ));
    let steps = FamilySteps::new(family).unwrap();
    let random = &mut Random(3);
    let mut largest = 0.0_f64;
    for (k, piece) in family.pieces.iter().enumerate() {
        let values = steps.on_span(k).values();
        largest = (0..40).map(|_| largest_ratio(piece, &values, &bounds, random)).fold(largest, f64::max);
    }
    assert!(largest > 0.5, "{largest}");
    // The float that 1/3 is compared as is not 1/3, and is taken for it; sums of shape values as knots are.
    let bounds = |k: usize| {
        let Subject::Family(family) = &families[k].subject else { panic!("a family") };
        let all = rounding::values(family)?;
        Some(all.into_iter().map(|bound| bound.map(|b| b.error)).collect::<Vec<_>>())
    };
    assert!(bounds(1).is_some_and(|all| matches!(all[..], [Some(Error::Relative(_))])));
    let parts = bounds(2).expect("bounds");
    assert!(matches!(&parts[..], [Some(Error::Relative(bound)), _] if bound.to_f64() < 12.0), "{parts:?}");
}

/// Families that are not in the library: all functions and points have bounds, and no error is larger.
#[test]
fn other_families_are_within_their_bounds() {
    let spec = "family Shape { domain 0 <= t <= 1; shape -2 <= a <= 1; shape -2 <= b <= 1; \
                f[0] = (1 - t)^3*(1 - a*t/2); f[1] = t*(1 - t)^2*(3 + a*(1 - t)/2); \
                f[2] = t^2*(1 - t)*(3 + b*t/2); f[3] = t^3*(1 - b*(1 - t)/2); } \
                family Uneven { domain -1 <= t <= 3; shape 1/4 <= a <= 4, 1/4 <= b <= 4; \
                let q = a*(3 - t)^2 + (3 - t)*(t + 1) + b*(t + 1)^2; \
                f[0] = a*(3 - t)^2/q; f[1] = (3 - t)*(t + 1)/q; f[2] = b*(t + 1)^2/q; } \
                family Triangle { domain triangle (u, v, w); shape -1 <= a <= 1; \
                f[0] = u^2*(1 - a*(v + w)); f[1] = v*(3*v - 1)*(3*v - 2)/2; f[2] = 9*u*w*(3*u - 1)/2; } \
                family Box { domain 0 <= x <= 1, -1 <= y <= 2; shape 0 <= k <= 3; \
                f[0] = (1 - x)^2*(2 - y)*(1 + k*x*(y + 1)); f[1] = (x - 1/2)*(y - 1/2); }";
    let library = Library::from_source(&Disk, &Prover, Source::text("others.basis", spec));
    let random = &mut Random(11);
    for item in library.items(Selected::EveryOrder) {
        let Subject::Family(family) = &item.subject else { panic!("a family") };
        let bounds: Vec<Option<Error>> =
            rounding::values(family).unwrap().into_iter().map(|b| b.map(|b| b.error)).collect();
        assert!(bounds.iter().all(Option::is_some), "{}: {bounds:?}", family.title());
        let steps = FamilySteps::new(family).unwrap();
        let none = vec![0; family.domain.len()];
        let point = steps.curve(1).or_else(|| steps.patch(&none)).expect("a curve or a patch");
        let on_points = steps.on_control_points(&point);
        let of_point = [rounding::point(family).map(|bound| bound.error)];
        assert!(of_point[0].is_some(), "{}", family.title());
        for _ in 0..20 {
            largest_ratio(family, &steps.values(), &bounds, random);
            largest_ratio(family, &on_points, &of_point, random);
        }
    }
}

/// Work that one function needs is not taken from others, and bounds on simplices are for coordinates with the sum 1.
#[test]
fn every_function_of_an_element_has_a_small_bound() {
    let largest = |spec: &str, name: &str| {
        let (_, text) = basis_specs::SPECS.iter().find(|(other, _)| *other == spec).expect("a spec");
        let library = Library::from_source(&Disk, &Prover, Source::text(format!("{spec}.basis"), text));
        let items = library.items(Selected::EveryOrder);
        let found = items.iter().find_map(|item| match &item.subject {
            Subject::Family(family) if family.title() == name => Some(rounding::values(family)),
            _ => None,
        });
        let bounds = found.flatten().expect("bounds");
        let errors = bounds.into_iter().map(|bound| bound.expect("a bound").error.epsilons().to_f64());
        errors.fold(0.0, f64::max)
    };
    assert!(largest("elements/boxes", "DouglasSantosSheenYe") < 14.0);
    assert!(largest("elements/boxes", "Hexahedron20") < 12.0);
    assert!(largest("lagrange", "TriangularLagrange(3)") < 9.0);
}

#[test]
fn bounds_are_near_the_largest_errors() {
    let spec = "family Quadratic { domain 0 <= t <= 1; b[0] = (1 - t)^2; b[1] = 2*t*(1 - t); b[2] = t^2; }";
    let library = Library::from_source(&Disk, &Prover, Source::text("quadratic.basis", spec));
    let items = library.items(Selected::EveryOrder);
    let Subject::Family(family) = &items[0].subject else { panic!("a family") };
    let bounds: Vec<Option<Error>> =
        rounding::values(family).unwrap().into_iter().map(|b| b.map(|b| b.error)).collect();
    let steps = FamilySteps::new(family).unwrap().values();
    let random = &mut Random(1);
    let largest = (0..40).map(|_| largest_ratio(family, &steps, &bounds, random)).fold(0.0, f64::max);
    assert!(largest > 0.8, "{largest}");
}

/// Where there is no bound it is said why, with a range of the shape values that has one.
#[test]
fn ranges_without_bounds_are_named() {
    let lines = |spec: &str| {
        let library = Library::from_source(&Disk, &Prover, Source::text("open.basis", spec));
        let items = library.items(Selected::EveryOrder);
        let Subject::Family(family) = &items[0].subject else { panic!("a family") };
        basis_engine::explain::rounding(family)
    };
    let moved = "family Moved { domain 0 <= x <= 1; shape 0 < a < 1; b[0] = (x - a)*(x - 1)/a; b[1] = x; }";
    let found = lines(moved);
    let reason = "no bound: the values of `b[0]` grow beyond all bounds where a goes to 0; for `1/64 <= a <= 63/64` it is ";
    assert!(found[0].0 == "b[0]" && found[0].1.starts_with(reason), "{found:?}");
    assert!(found[2].0 == "C(x)" && found[2].1.starts_with(reason), "{found:?}");
    // The bound that is named is that of the family with this range.
    let narrow = lines(&moved.replace("0 < a < 1", "1/64 <= a <= 63/64"));
    assert_eq!(found[0].1, format!("{reason}{}", narrow[0].1));
    let open = lines("family Open { domain 0 <= x < 1; b[0] = (1 - 3*x)/(1 - x); b[1] = x; }");
    assert_eq!(open[0].1, "no bound: the values of `b[0]` grow beyond all bounds where x goes to 1");
}
