//! Damaged files of crystal structures: reading never panics and is quick.

use crate::crystals::{POSCAR, XYZ, hcp, pymatgen, with};
use acutile_io::import::cif::Special;
use acutile_io::import::crystal::{Kind, read};

/// Splitmix64.
struct Random(u64);

impl Random {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ z >> 31) % bound.max(1) as u64) as usize
    }
}

/// A few bytes replaced, removed, repeated or moved.
fn damaged(text: &str, random: &mut Random) -> String {
    let mut bytes = text.as_bytes().to_vec();
    for _ in 0..=random.below(3) {
        let at = random.below(bytes.len());
        let to = (at + random.below(12)).min(bytes.len());
        match random.below(5) {
            0 => bytes[at] = b" \n,-.0159eE/*'\"[]{}:;?xXT\xff"[random.below(26)],
            1 => drop(bytes.drain(at..to)),
            2 => {
                let copy = bytes[at..to].to_vec();
                bytes.splice(at..at, copy);
            }
            3 => bytes.truncate(at.max(1)),
            _ => {
                let digits = ["99999999999", "1e99", "-1", "0", "nan", "1e-90"][random.below(6)];
                bytes.splice(at..to, digits.bytes());
            }
        }
        if bytes.is_empty() {
            bytes.push(b'0');
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// 1,000 damaged files of each format are read or refused, without a panic, in seconds.
#[test]
fn damaged_files() {
    let cif = hcp("Mg1 0.3333 0.6667 0.25\nMg2 0.1 0.2 0.75").replace(
        "_space_group_name",
        "_space_group_name_Hall '-P 6c 2c'\n_space_group_IT_number 194\n_space_group_name",
    );
    let options = [Special::Refuse, Special::Move, Special::AsWritten].map(with);
    let mut read_well = 0;
    for (kind, text) in [
        (Kind::Poscar, POSCAR.to_owned()),
        (Kind::Xyz, XYZ.to_owned()),
        (Kind::Pymatgen, pymatgen()),
        (Kind::Cif, cif),
    ] {
        let mut random = Random(16);
        let start = std::time::Instant::now();
        for round in 0..1000 {
            let text = damaged(&text, &mut random);
            read_well += usize::from(read(kind, &text, &options[round % 3]).is_ok());
        }
        assert!(start.elapsed().as_secs() < 300, "{kind:?}");
    }
    assert!(read_well > 100, "{read_well}");
}
