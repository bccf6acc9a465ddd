//! The kernel alone, on certificates over Q and over Q(√5): of A15, of the icosahedral tiling, and of A15 moved by long numbers.

use crate::clock::on_processor;
use crate::data::{FIELDS, a15, bent, entry};
use crate::row::{Table, Target};
use acutile_core::checker::Options;
use acutile_core::proved::prove;
use acutile_core::tiling::{Tiling, supercell};
use acutile_kernel::{Limits, verify};

/// The rows of the verifier.
pub fn measure(table: &Table) {
    table.head("the verifier, from the bytes of a certificate");
    let a15 = a15(8);
    let icosahedral = supercell(&entry("icosahedral"), [7; 3]);
    for (name, tiling, target) in [
        ("Q, A15", a15.clone(), Target::Least(1_200_000.0)),
        (
            "Q(sqrt 5), icosahedral",
            icosahedral,
            Target::Least(500_000.0),
        ),
        (
            "Q(sqrt 5), A15 moved",
            bent(&a15, FIELDS[0].1),
            Target::None,
        ),
    ] {
        let bytes = certificate(&tiling);
        let time = on_processor(3, || check(&bytes));
        let rate = tiling.len() as f64 / time.as_secs_f64();
        let note = format!("{} tetrahedra, {} bytes", tiling.len(), bytes.len());
        table.row(name, rate, "tetrahedra/s", target, &note);
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
