//! The parts of the whole check, as a child process runs them.

use crate::clock::processor_time;
use crate::data::a15;
use acutile_core::checker::{Findings, Model, check_acute, check_orientation, check_volume};
use acutile_core::tiling::{Tiling, match_facets};
use std::time::{Duration, Instant};

/// The work of the child; gives elapsed time, processor time and the parts.
pub fn check(n: u16, times: u32) -> (usize, Duration, Duration, String) {
    let tiling = a15(n);
    let (start, begin) = (Instant::now(), processor_time());
    for _ in 1..times {
        parts(&tiling);
    }
    let parts = parts(&tiling);
    let (elapsed, processors) = (start.elapsed(), processor_time().saturating_sub(begin));
    let texts = parts.map(|(name, time)| format!("{name} {:.3}", time.as_secs_f64()));
    let remark = format!("seconds of processors: {}", texts.join(", "));
    (tiling.len(), elapsed, processors, remark)
}

fn parts(tiling: &Tiling<3>) -> [(&'static str, Duration); 5] {
    let mut last = processor_time();
    let mut lap = || {
        let now = processor_time();
        now.saturating_sub(std::mem::replace(&mut last, now))
    };
    let mut findings = Findings::new(1);
    let model = Model::new(tiling);
    let made = lap();
    check_orientation(&model, &mut findings);
    let orientation = lap();
    check_acute(&model, &mut findings);
    let acuteness = lap();
    assert!(match_facets(tiling).mismatches.is_empty());
    let facets = lap();
    check_volume(&model, &mut findings);
    let volume = lap();
    assert!(findings.is_empty());
    [
        ("model", made),
        ("orientation", orientation),
        ("acuteness", acuteness),
        ("facets", facets),
        ("volume", volume),
    ]
}
