//! The kernel alone, on certificates of A15 over Q and over a quadratic field.

use crate::clock::on_processor;
use crate::data::{FIELDS, a15, bent};
use crate::row::{Table, Target};
use acutile_core::checker::Options;
use acutile_core::proved::prove;
use acutile_core::tiling::Tiling;
use acutile_kernel::{Limits, verify};

/// The rows of the verifier.
pub fn measure(table: &Table) {
    table.head("the verifier, from the bytes of a certificate");
    let a15 = a15(8);
    for (name, tiling, target) in [
        ("Q", a15.clone(), 1_200_000.0),
        (FIELDS[0].0, bent(&a15, FIELDS[0].1), 500_000.0),
    ] {
        let bytes = certificate(&tiling);
        let time = on_processor(3, || check(&bytes));
        let rate = tiling.len() as f64 / time.as_secs_f64();
        let note = format!("{} tetrahedra, {} bytes", tiling.len(), bytes.len());
        table.row(name, rate, "tetrahedra/s", Target::Least(target), &note);
    }
}

/// The certificate of a tiling.
pub fn certificate(tiling: &Tiling<3>) -> Vec<u8> {
    let proved = prove(tiling, &Options::default(), &|_| ()).expect("it is a tiling");
    proved.certificate().to_vec()
}

/// Runs the kernel; gives the number of tetrahedra.
pub fn check(mut bytes: &[u8]) -> usize {
    let verified = verify(&mut bytes, &Limits::DEFAULT).expect("it is right");
    verified.simplices as usize
}
