//! The figures as data, for machines.

use super::{Extreme, Place, Statistics};
use crate::tiling::SimplexId;
use serde_json::{Value, json};

/// Counts, extremes with rational bounds and their holders, the histogram. `simplex` names a simplex.
pub fn data(statistics: &Statistics, simplex: &dyn Fn(SimplexId) -> String) -> Value {
    let [acute, right, obtuse] = statistics.kinds;
    let [acute_angles, right_angles, obtuse_angles] = statistics.angles;
    let place = |place: &Place| json!({ "name": simplex(place.simplex), "facets": place.facets });
    let name = |index: &SimplexId| json!({ "name": simplex(*index) });
    let left_out = statistics.left_out.iter().map(|s| simplex(*s));
    json!({
        "simplices": statistics.simplices,
        "left_out": left_out.collect::<Vec<_>>(),
        "kinds": { "acute": acute, "right": right, "obtuse": obtuse },
        "angles": { "acute": acute_angles, "right": right_angles, "obtuse": obtuse_angles },
        "degrees_per_bin": statistics.degrees_per_bin,
        "histogram": statistics.histogram,
        "smallest_dihedral": extreme(&statistics.smallest, place),
        "largest_dihedral": extreme(&statistics.largest, place),
        "least_radius_edge": extreme(&statistics.lowest_ratio, name),
        "greatest_radius_edge": extreme(&statistics.highest_ratio, name),
        "aspect": statistics.aspects.map(|aspects| {
            aspects.map(|(value, index)| json!({ "value": value, "name": simplex(index) }))
        }),
    })
}

fn extreme<P>(extreme: &Option<Extreme<P>>, holder: impl Fn(&P) -> Value) -> Value {
    let Some(extreme) = extreme else {
        return Value::Null;
    };
    json!({
        "bounds": [extreme.bounds.0.to_string(), extreme.bounds.1.to_string()],
        "closed_form": extreme.closed_form,
        "count": extreme.count,
        "first": extreme.holders.iter().map(holder).collect::<Vec<_>>(),
    })
}
