//! Work on all cores.
//!
//! The iterators of rayon are compiled anew for every closure, and were a third of the code of this
//! crate. Here rayon calls a trait object, once for each chunk of work, and is compiled once.

use rayon::prelude::*;
use std::ops::Range;
use std::sync::OnceLock;

/// Few enough for all cores to have work, and enough to be worth a call.
const CHUNK: usize = 256;

/// The results of `work` for 0, …, n - 1, a range of at most `size` of them at a time; in order.
pub fn by_chunks<T: Send + Sync>(
    n: usize,
    size: usize,
    work: impl Fn(Range<usize>) -> T + Sync,
) -> Vec<T> {
    let slots: Vec<OnceLock<T>> = (0..n.div_ceil(size)).map(|_| OnceLock::new()).collect();
    each(slots.len(), &|chunk| {
        slots[chunk].get_or_init(|| work(chunk * size..n.min((chunk + 1) * size)));
    });
    let values = slots.into_iter().map(OnceLock::into_inner);
    values
        .map(|value| value.expect("every chunk has been worked on"))
        .collect()
}

/// The values of `value` at 0, …, n - 1.
pub fn map<T: Send + Sync>(n: usize, value: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let chunks = by_chunks(n, CHUNK, |range| range.map(&value).collect::<Vec<T>>());
    chunks.into_iter().flatten().collect()
}

/// The values for the items of a list that each take long.
pub fn map_slow<I: Sync, T: Send + Sync>(items: &[I], value: impl Fn(&I) -> T + Sync) -> Vec<T> {
    by_chunks(items.len(), 1, |range| value(&items[range.start]))
}

fn each(n: usize, work: &(dyn Fn(usize) + Sync)) {
    (0..n).into_par_iter().for_each(work);
}
