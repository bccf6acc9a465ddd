//! Places for words beside lines: off all lines, and not on top of one another.

use super::drawing::{FONT, Place, text_width};

/// Words that want a place, and the places in order of preference; in millimetres.
pub struct Request {
    pub text: String,
    pub places: Vec<Place>,
}

/// Beside a line: near its middle, on either side.
pub fn beside_line(text: String, [a, b]: [Place; 2]) -> Request {
    let along = [b[0] - a[0], b[1] - a[1]];
    let length = along[0].hypot(along[1]).max(1e-9);
    let normal = [-along[1] / length, along[0] / length];
    let far = reach(&text, normal) + GAP;
    let at = |part: f64, side: f64| [0, 1].map(|k| a[k] + part * along[k] + side * far * normal[k]);
    let parts = [0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74];
    let places = parts
        .into_iter()
        .flat_map(|part| [at(part, 1.0), at(part, -1.0)]);
    Request {
        places: places.collect(),
        text,
    }
}

/// Around a point, away from `middle` first.
pub fn around_point(text: String, point: Place, middle: Place) -> Request {
    let outward = (point[1] - middle[1]).atan2(point[0] - middle[0]);
    let turn = |k: i32| {
        f64::from((k + 1) / 2 * if k % 2 == 0 { 1 } else { -1 }) * std::f64::consts::PI / 8.0
    };
    let places = (0..16).map(|k| {
        let (sine, cosine) = (outward + turn(k)).sin_cos();
        let far = reach(&text, [cosine, sine]) + GAP;
        [point[0] + far * cosine, point[1] + far * sine]
    });
    Request {
        places: places.collect(),
        text,
    }
}

/// A place for each request, and how many lines and words are hit all the same.
pub fn placed(requests: &[Request], lines: &[[Place; 2]]) -> (Vec<Place>, usize) {
    let (mut chosen, mut hits) = (Vec::<(Place, Place)>::new(), 0);
    for request in requests {
        let half = half_size(&request.text);
        let cost = |at: &Place| {
            let on_lines = lines.iter().filter(|line| meets(*at, half, line)).count();
            let is_on = |(other, size): &&(Place, Place)| {
                (0..2).all(|k| (at[k] - other[k]).abs() < half[k] + size[k])
            };
            on_lines + 3 * chosen.iter().filter(is_on).count()
        };
        let best = request.places.iter().map(|at| (cost(at), *at));
        let Some((cost, at)) = best.min_by_key(|(cost, _)| *cost) else {
            continue;
        };
        hits += cost;
        chosen.push((at, half));
    }
    (chosen.into_iter().map(|(at, _)| at).collect(), hits)
}

/// Between words and their line.
const GAP: f64 = 0.4;

/// Half the width and half the height of words; figures have no letters below the line.
fn half_size(text: &str) -> Place {
    [text_width(text) / 2.0, 0.4 * FONT]
}

/// From the middle of words to their border in a direction.
fn reach(text: &str, direction: Place) -> f64 {
    let half = half_size(text);
    half[0] * direction[0].abs() + half[1] * direction[1].abs()
}

/// Whether a segment meets the box with this middle: the segment cut by the four sides has a part left.
fn meets(at: Place, half: Place, [a, b]: &[Place; 2]) -> bool {
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for k in 0..2 {
        let step = b[k] - a[k];
        let ends = [at[k] - half[k] - a[k], at[k] + half[k] - a[k]];
        if step.abs() < 1e-9 {
            if ends[0] > 0.0 || ends[1] < 0.0 {
                return false;
            }
            continue;
        }
        let [low, high] = ends.map(|end| end / step);
        from = from.max(low.min(high));
        to = to.min(low.max(high));
    }
    from <= to
}

#[cfg(test)]
mod tests {
    use super::{around_point, beside_line, half_size, meets, placed};

    #[test]
    fn a_segment_through_a_box_meets_it_and_one_beside_it_does_not() {
        let half = [2.0, 1.0];
        assert!(meets([0.0, 0.0], half, &[[-5.0, 0.0], [5.0, 0.0]]));
        assert!(meets([0.0, 0.0], half, &[[-1.0, 0.0], [1.0, 0.5]]));
        assert!(!meets([0.0, 0.0], half, &[[-5.0, 1.5], [5.0, 1.5]]));
        assert!(!meets([0.0, 0.0], half, &[[3.0, -5.0], [3.0, 5.0]]));
        assert!(!meets([0.0, 0.0], half, &[[0.0, 4.0], [8.0, 0.0]]));
    }

    /// Angles at the sides of a triangle and names at its corners: nothing is on a side or on another word.
    #[test]
    fn words_are_off_lines_and_apart() {
        let corners = [[0.0, 0.0], [40.0, 0.0], [15.0, 30.0]];
        let lines = [[0, 1], [1, 2], [2, 0]].map(|ends| ends.map(|k| corners[k]));
        let mut requests: Vec<_> = lines.map(|line| beside_line("70.53°".into(), line)).into();
        requests.extend((0..3).map(|k| around_point(k.to_string(), corners[k], [18.0, 10.0])));
        let (places, hits) = placed(&requests, &lines);
        assert_eq!((places.len(), hits), (6, 0));
        for (at, request) in places.iter().zip(&requests) {
            assert!(
                lines
                    .iter()
                    .all(|line| !meets(*at, half_size(&request.text), line))
            );
        }
    }
}
