//! Paths from text.

use alloc::vec::Vec;

use super::{SvgError, SvgMistake};
use crate::path::{Path, PathSegment};
use crate::vector::is_finite;
use crate::{Point, Scalar};

impl<P: Point> Path<P> {
    /// The paths of the attribute `d` of an SVG path, one for each part that begins with `M` and has a segment: all
    /// commands of SVG 2, absolute and relative. Arcs become rational quadratic segments and stay exact; `Z` adds the
    /// line back to the start where one is missing.
    ///
    /// As SVG has it, an arc whose radii are too small gets larger ones, one with a radius 0 is a line, one from a
    /// point to itself is left out. The axes are those of the text: in SVG y points down, so that a positive angle turns
    /// clockwise on the screen. Components of points beyond the second are zero.
    ///
    /// ```
    /// use basis_runtime::{ParametricCurve, Path, to_svg};
    ///
    /// let [leaf] = Path::<[f32; 2]>::from_svg("M0 0q4-6 8 0a5 5 0 01-8 0z")?.try_into().unwrap();
    /// assert_eq!(leaf.segments().len(), 3);
    /// assert!(leaf.is_closed());
    /// assert_eq!(to_svg(&leaf, 1e-3).unwrap(), "M0 0Q4-6 8 0A5 5 0 0 1 4 2A5 5 0 0 1 0 0Z");
    ///
    /// let error = Path::<[f32; 2]>::from_svg("M 1 2 L 3").unwrap_err();
    /// assert_eq!(error.to_string(), "byte 9: a number is missing: the command `L` takes 2 at a time");
    /// # Ok::<(), basis_runtime::SvgError>(())
    /// ```
    ///
    /// # Errors
    /// [`SvgError`] with the place of the first mistake.
    pub fn from_svg(text: &str) -> Result<Vec<Self>, SvgError> {
        const { assert!(P::DIM >= 2, "a path of SVG has points in the plane") };
        let mut reader = Reader { text, at: 0 };
        let mut pen =
            Pen { paths: Vec::new(), segments: Vec::new(), start: [0.0; 2], here: [0.0; 2], handle: None };
        let mut command = '\0';
        reader.skip(false);
        while let Some(next) = reader.peek() {
            if next.is_ascii_alphabetic() || command == '\0' || matches!(command, 'Z' | 'z') {
                if !"MmLlHhVvCcSsQqTtAaZz".contains(next) {
                    return Err(SvgError::new(SvgMistake::Command(next), reader.at));
                }
                if command == '\0' && !matches!(next, 'M' | 'm') {
                    return Err(SvgError::new(SvgMistake::NoMove, reader.at));
                }
                command = next;
                reader.at += 1;
                reader.skip(false);
                if !matches!(command, 'M' | 'm' | 'Z' | 'z') && pen.segments.is_empty() {
                    // After `Z` the next part begins where the last one did.
                    pen.start = pen.here;
                }
            } else if !next.is_ascii_digit() && !matches!(next, '+' | '-' | '.') {
                return Err(SvgError::new(SvgMistake::Command(next), reader.at));
            }
            pen.draw(&mut reader, command)?;
            // Further pairs after a move are lines.
            command = match command {
                'M' => 'L',
                'm' => 'l',
                other => other,
            };
            let before = reader.at;
            reader.skip(true);
            // A comma stands between numbers.
            let number = reader.peek().is_some_and(|c| c.is_ascii_digit() || matches!(c, '+' | '-' | '.'));
            if let Some(comma) = reader.text[before..reader.at].find(',')
                && !number
            {
                return Err(SvgError::new(SvgMistake::Command(','), before + comma));
            }
        }
        pen.finish();
        Ok(pen.paths)
    }
}

/// What has been drawn.
struct Pen<P: Point> {
    paths: Vec<Path<P>>,
    segments: Vec<PathSegment<P>>,
    start: [f64; 2],
    here: [f64; 2],
    /// The degree and the last inner control point of the segment before.
    handle: Option<(usize, [f64; 2])>,
}

impl<P: Point> Pen<P> {
    fn finish(&mut self) {
        if !self.segments.is_empty() {
            self.paths.push(Path { segments: core::mem::take(&mut self.segments) });
        }
    }

    /// One command, with as many numbers as it takes once.
    fn draw(&mut self, reader: &mut Reader<'_>, command: char) -> Result<(), SvgError> {
        let upper = command.to_ascii_uppercase();
        let origin = if command == upper { [0.0; 2] } else { self.here };
        let handle = self.handle.take();
        let takes = match upper {
            'M' | 'L' | 'T' => 2,
            'H' | 'V' => 1,
            'S' | 'Q' => 4,
            'C' => 6,
            'A' => 7,
            _ => 0,
        };
        let (at, before) = (reader.at, self.segments.len());
        let mut numbers = [0.0; 7];
        for (i, number) in numbers.iter_mut().enumerate().take(takes) {
            if i > 0 {
                reader.skip(true);
            }
            *number = if upper == 'A' && (i == 3 || i == 4) {
                reader.flag()?
            } else {
                let at = reader.at;
                let number = reader.number().map_err(|at| match at {
                    (true, at) => SvgError::new(SvgMistake::Size, at),
                    (false, at) => SvgError::new(SvgMistake::Number { command, takes }, at),
                })?;
                if !P::Scalar::of(number).is_finite() {
                    return Err(SvgError::new(SvgMistake::Size, at));
                }
                number
            };
        }
        let point = |i: usize| [numbers[i] + origin[0], numbers[i + 1] + origin[1]];
        // The last handle, mirrored in the point where it ended.
        let mirrored = |degree: usize, here: [f64; 2]| match handle {
            Some((of, [x, y])) if of == degree => [2.0 * here[0] - x, 2.0 * here[1] - y],
            _ => here,
        };
        match upper {
            'M' => {
                self.finish();
                self.here = point(0);
                self.start = self.here;
            }
            'L' => self.bezier(&[point(0)]),
            'H' => self.bezier(&[[numbers[0] + origin[0], self.here[1]]]),
            'V' => self.bezier(&[[self.here[0], numbers[0] + origin[1]]]),
            'C' => self.bezier(&[point(0), point(2), point(4)]),
            'S' => self.bezier(&[mirrored(3, self.here), point(0), point(2)]),
            'Q' => self.bezier(&[point(0), point(2)]),
            'T' => self.bezier(&[mirrored(2, self.here), point(0)]),
            'A' => self.arc(numbers, point(5)),
            _ => {
                let start = to_point::<P>(self.start);
                if self.segments.last().is_some_and(|last| last.end() != start) {
                    self.bezier(&[self.start]);
                }
                self.here = self.start;
                self.finish();
                self.handle = None;
            }
        }
        // Numbers that are small enough can add up to one that is not.
        let drawn = self.segments.iter().skip(before).flat_map(PathSegment::control_points);
        let finite = is_finite(to_point::<P>(self.here)) && drawn.copied().all(is_finite);
        if finite { Ok(()) } else { Err(SvgError::new(SvgMistake::Size, at)) }
    }

    /// A segment from here on over these control points.
    fn bezier(&mut self, points: &[[f64; 2]]) {
        let all = core::iter::once(self.here).chain(points.iter().copied()).map(to_point);
        self.segments.push(PathSegment::trusted(all.collect(), Vec::new()));
        self.handle = points.len().checked_sub(2).map(|inner| (points.len(), points[inner]));
        self.here = points.last().copied().unwrap_or(self.here);
    }

    /// An arc by its end, as SVG describes it; from the formulas of appendix B.2.4 of SVG 2.
    fn arc(&mut self, [rx, ry, rotation, large, sweep, ..]: [f64; 7], end: [f64; 2]) {
        let [mut rx, mut ry] = [rx.abs(), ry.abs()];
        let half = [0, 1].map(|d| (self.here[d] - end[d]) / 2.0);
        if half == [0.0; 2] {
            return;
        }
        if rx == 0.0 || ry == 0.0 {
            self.bezier(&[end]);
            return;
        }
        let (sin, cos) = (rotation % 360.0).to_radians().sin_cos();
        // Half of the chord in the directions of the axes, in units of the radii.
        let [mut x, mut y] = [(cos * half[0] + sin * half[1]) / rx, (cos * half[1] - sin * half[0]) / ry];
        let square = x * x + y * y;
        if square > 1.0 {
            let grow = Scalar::sqrt(square);
            (rx, ry, x, y) = (rx * grow, ry * grow, x / grow, y / grow);
        }
        // On the unit circle: the centre is beside the middle of the chord from (x, y) to (-x, -y).
        let square = (x * x + y * y).min(1.0);
        let side = if (large != 0.0) == (sweep != 0.0) { -1.0 } else { 1.0 };
        let away = side * Scalar::sqrt((1.0 - square) / square);
        let centre = [away * y, -away * x];
        let start = Scalar::atan2(y - centre[1], x - centre[0]);
        // Half of the turn, which the chord and the distance of its middle from the centre tell.
        let short = 2.0 * Scalar::atan2(Scalar::sqrt(square), Scalar::sqrt(1.0 - square));
        let turn = if large == 0.0 { short } else { 2.0 * core::f64::consts::PI - short };
        let turn = if sweep == 0.0 { -turn } else { turn };
        let axes = [[rx * cos, rx * sin], [-ry * sin, ry * cos]];
        let middle = [0, 1]
            .map(|d| f64::midpoint(self.here[d], end[d]) + axes[0][d] * centre[0] + axes[1][d] * centre[1]);
        let arc = Path::<[f64; 2]>::ellipse_arc(middle, axes, start, turn);
        let last = arc.segments().len() - 1;
        for (k, segment) in arc.segments().iter().enumerate() {
            let mut points: Vec<P> = segment.control_points().iter().map(|&p| to_point(p)).collect();
            // The ends are those of the text, exactly.
            if k == 0 {
                points[0] = to_point(self.here);
            }
            if k == last {
                points[2] = to_point(end);
            }
            let weights = segment.weights().unwrap_or_default().iter().map(|&w| P::Scalar::of(w)).collect();
            self.segments.push(PathSegment::trusted(points, weights));
        }
        self.here = end;
    }
}

fn to_point<P: Point>(at: [f64; 2]) -> P {
    P::from_components(|d| P::Scalar::of(at.get(d).copied().unwrap_or(0.0)))
}

/// Numbers and letters, one after the other.
struct Reader<'t> {
    text: &'t str,
    at: usize,
}

impl Reader<'_> {
    fn peek(&self) -> Option<char> {
        self.text[self.at..].chars().next()
    }

    fn byte(&self, at: usize) -> u8 {
        self.text.as_bytes().get(at).copied().unwrap_or(0)
    }

    /// White space, and one comma where it may stand.
    fn skip(&mut self, mut comma: bool) {
        loop {
            match self.byte(self.at) {
                b' ' | b'\t' | b'\n' | b'\r' | 0x0c => self.at += 1,
                b',' if comma => {
                    comma = false;
                    self.at += 1;
                }
                _ => return,
            }
        }
    }

    /// A flag is one character, so that `a1 1 0 01.5.5` has two of them.
    fn flag(&mut self) -> Result<f64, SvgError> {
        let flag = match self.byte(self.at) {
            b'0' => 0.0,
            b'1' => 1.0,
            _ => return Err(SvgError::new(SvgMistake::Flag, self.at)),
        };
        self.at += 1;
        Ok(flag)
    }

    /// The next number, or its place and whether it is there and too large.
    fn number(&mut self) -> Result<f64, (bool, usize)> {
        let start = self.at;
        let digits = |mut at: usize| {
            while self.byte(at).is_ascii_digit() {
                at += 1;
            }
            at
        };
        let mut at = start + usize::from(matches!(self.byte(start), b'+' | b'-'));
        let whole = digits(at);
        let mut count = whole - at;
        at = whole;
        if self.byte(at) == b'.' {
            let fraction = digits(at + 1);
            count += fraction - at - 1;
            // `1.` is no number of SVG, but everybody reads it.
            at = fraction;
        }
        if count == 0 {
            return Err((false, start));
        }
        if matches!(self.byte(at), b'e' | b'E') {
            let sign = at + 1 + usize::from(matches!(self.byte(at + 1), b'+' | b'-'));
            let exponent = digits(sign);
            if exponent > sign {
                at = exponent;
            }
        }
        self.at = at;
        match self.text[start..at].parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            _ => Err((true, start)),
        }
    }
}
