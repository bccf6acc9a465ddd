//! Integers in options.

use std::ops::RangeInclusive;

/// Reads an integer in this range. An error names the range.
pub fn integer_in<T: TryFrom<u64>>(
    range: RangeInclusive<u64>,
) -> impl Fn(&str) -> Result<T, String> + Clone + Send + Sync + 'static {
    move |text| {
        let (low, high) = (range.start(), range.end());
        let is_integer = text.parse::<i128>().is_ok();
        let in_range = text.parse().ok().filter(|n| range.contains(n));
        let value = in_range.and_then(|n| T::try_from(n).ok());
        value.ok_or_else(|| {
            let expected = format!("expected an integer from {low} to {high}");
            if is_integer {
                format!("{text} is out of range, {expected}")
            } else {
                expected
            }
        })
    }
}
