//! The space fullerenes of Dutour Sikirić, Delgado-Friedrichs and Deza, by the digests of their minimal symbols.
//!
//! A space fullerene is the dual of a TCP triangulation. The list is that of M. Dutour Sikirić, O. Delgado-Friedrichs
//! and M. Deza, "Space fullerenes: a computer search for new Frank-Kasper structures", Acta Cryst. A 66 (2010), 602-615,
//! in the numbering of the PyPI package genice2, which has their cages. `examples/space-fullerenes.py` computes the
//! digests from that package. No coordinates are copied: equal minimal symbols mean isomorphic triangulations.

/// Number, name (`-` if it has none of its own), digest.
const LIST: &str = include_str!("fullerenes.txt");

/// The name of the space fullerene whose minimal symbol has this digest.
pub fn space_fullerene(digest: &str) -> Option<String> {
    let rows = LIST.lines().map(|line| line.split(' ').collect::<Vec<_>>());
    rows.filter(|row| row[2] == digest)
        .map(|row| match row[1] {
            "-" => format!("space fullerene {}", row[0]),
            name => format!("space fullerene {} ({name})", row[0]),
        })
        .next()
}
