//! Damaged mesh files of every format: reading never panics and is quick, and what is read is
//! proved only where it is the undamaged mesh.

use acutile_core::anatomy::volumes;
use acutile_core::checker::{Options, examine};
use acutile_core::tiling::{AnyTiling, Domain};
use acutile_io::mesh::surface::{self, Surface};
use acutile_io::mesh::{
    Family, Format, Lattice, Mesh, MeshError, Numbering, load, periodic_tiling, region_tiling,
    write,
};
use std::path::Path;
use std::time::{Duration, Instant};

/// Splitmix64: a sequence for each seed.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ z >> 31
    }

    fn below(&mut self, bound: usize) -> usize {
        (self.next() % bound.max(1) as u64) as usize
    }
}

/// The cube of side 1 in six tetrahedra. All of its nodes are one vertex modulo Z^3, so no node can be
/// moved alone, and no tetrahedron can be changed.
fn cube() -> Mesh {
    let coordinate = |k: u32, bit: u32| f64::from(k >> bit & 1);
    let points: Vec<[f64; 3]> = (0..8)
        .map(|k| [coordinate(k, 0), coordinate(k, 1), coordinate(k, 2)])
        .collect();
    let tetrahedra = vec![
        [0, 1, 3, 7],
        [0, 1, 7, 5],
        [0, 2, 7, 3],
        [0, 2, 6, 7],
        [0, 4, 5, 7],
        [0, 4, 7, 6],
    ];
    Mesh {
        nodes: Numbering::consecutive(1, points.len()),
        elements: Numbering::consecutive(1, tetrahedra.len()),
        points,
        tetrahedra,
        ..Mesh::default()
    }
}

/// Ranges of words, for a file that is text all through.
fn words(bytes: &[u8]) -> Vec<(usize, usize)> {
    let mut words = Vec::new();
    let mut start = None;
    for (at, byte) in bytes.iter().enumerate() {
        match (byte.is_ascii_whitespace(), start) {
            (false, None) => start = Some(at),
            (true, Some(from)) => {
                words.push((from, at));
                start = None;
            }
            _ => {}
        }
    }
    words
}

const HUGE: [&str; 8] = [
    "-1",
    "4294967296",
    "99999999999999999999",
    "1e999",
    "nan",
    "9007199254740993",
    "-inf",
    "0",
];

fn damaged(bytes: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    let at = random.below(bytes.len());
    let words = words(&bytes);
    let word = words
        .get(random.below(words.len()))
        .copied()
        .unwrap_or((0, 0));
    match random.below(8) {
        0 => bytes.truncate(at),
        1 => bytes[at] ^= 1 << random.below(8),
        2 => bytes[at] = random.next() as u8,
        3 => {
            let other = words
                .get(random.below(words.len()))
                .copied()
                .unwrap_or((0, 0));
            let (first, second) = if word.0 < other.0 {
                (word, other)
            } else {
                (other, word)
            };
            if first.1 <= second.0 {
                let (a, b) = (
                    bytes[first.0..first.1].to_vec(),
                    bytes[second.0..second.1].to_vec(),
                );
                bytes.splice(second.0..second.1, a);
                bytes.splice(first.0..first.1, b);
            }
        }
        4 => drop(bytes.splice(word.0..word.1, HUGE[random.below(HUGE.len())].bytes())),
        5 => {
            let huge = [u64::MAX, 1 << 62, 1 << 31, 0, 0x7ff0_0000_0000_0000][random.below(5)];
            let end = bytes.len().min(at + [4, 8][random.below(2)]);
            let digits = huge.to_le_bytes();
            bytes[at..end].copy_from_slice(&digits[..end - at]);
        }
        6 => {
            let end = bytes.len().min(at + random.below(30));
            drop(bytes.drain(at..end));
        }
        _ => {
            let end = bytes.len().min(at + random.below(30));
            let piece = bytes[at..end].to_vec();
            bytes.splice(at..at, piece);
        }
    }
    bytes
}

/// The tetrahedra by the bits of their corners, the first three of them and the last in an order
/// that keeps the orientation.
fn geometry(mesh: &Mesh) -> Vec<([[u64; 3]; 4], bool)> {
    let mut list: Vec<_> = mesh
        .tetrahedra
        .iter()
        .map(|corners| {
            let mut bits = corners.map(|c| mesh.points[c as usize].map(|x| (x + 0.0).to_bits()));
            let pairs = (0..4).flat_map(|i| (0..i).map(move |j| (i, j)));
            let even = pairs.filter(|&(i, j)| bits[i] < bits[j]).count() % 2 == 0;
            bits.sort_unstable();
            (bits, even)
        })
        .collect();
    list.sort_unstable();
    list
}

fn read(format: Format, files: &[Vec<u8>], folder: &Path) -> Result<Mesh, MeshError> {
    if format != Format::TetGen {
        return format.family().read(&files[0]);
    }
    for (extension, bytes) in ["node", "ele"].iter().zip(files) {
        std::fs::write(folder.join(format!("m.{extension}")), bytes).expect("written");
    }
    load(&folder.join("m.node"), Family::TetGen).map(|loaded| loaded.mesh)
}

#[test]
fn damaged_files_are_refused_or_refuted() {
    let lattice = Lattice::parse("1,0,0;0,1,0;0,0,1").expect("a lattice");
    let folder = tempfile::tempdir().expect("a folder");
    let original = geometry(&cube());
    for (name, format) in acutile_io::mesh::format::NAMES {
        let files: Vec<Vec<u8>> = write(&cube(), format)
            .into_iter()
            .map(|f| f.bytes)
            .collect();
        let (mut refused, mut refuted, mut unchanged) = (0, 0, 0);
        for seed in 0..1000 {
            let mut random = Random(seed);
            let mut files = files.clone();
            let chosen = random.below(files.len());
            files[chosen] = damaged(&files[chosen], &mut random);
            let begin = Instant::now();
            match read(format, &files, folder.path()) {
                Err(error) => {
                    assert!(!error.to_string().is_empty());
                    refused += 1;
                }
                Ok(mesh) if geometry(&mesh) == original => unchanged += 1,
                Ok(mesh) => {
                    if let Ok(converted) = periodic_tiling(mesh, &lattice, None) {
                        let options = Options {
                            sides: converted.sides,
                            ..Options::default()
                        };
                        let AnyTiling::Space(tiling) = &converted.tiling else {
                            continue;
                        };
                        if examine(tiling, &options, &|_| ()).is_ok() {
                            // A node that is moved inwards leaves a void in each cell. All of
                            // space is tiled by the undamaged mesh alone.
                            assert_eq!(
                                tiling.frame.domain,
                                Domain::Region(3),
                                "{name}, seed {seed}"
                            );
                            let volume: f64 = volumes(tiling).iter().sum();
                            assert!(volume < 1.0, "{name}, seed {seed}: {volume}");
                        }
                    }
                    refuted += 1;
                }
            }
            assert!(
                begin.elapsed() < Duration::from_secs(10),
                "{name}, seed {seed}: slow"
            );
        }
        // The damage is neither always fatal nor mostly harmless, except that zlib notices
        // whatever happens to the data.
        let is_packed = format == Format::Vtu;
        assert!(
            refused > 100 && (is_packed || refuted > 50),
            "{name}: {refused} {refuted} {unchanged}"
        );
    }
}

#[test]
fn damaged_files_of_other_programs_never_panic() {
    let folder = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("tests/meshes");
    let mut count = 0;
    for entry in std::fs::read_dir(&folder).expect("the folder") {
        let path = entry.expect("an entry").path();
        let Some(family) = Family::of_path(&path).filter(|family| *family != Family::TetGen) else {
            continue;
        };
        let bytes = std::fs::read(&path).expect("the file");
        for seed in 0..100 {
            let damaged = damaged(&bytes, &mut Random(seed));
            if let Ok(mesh) = family.read(&damaged) {
                // Links may have lost their sense, but finding that out is safe, too.
                if !mesh.periodic.is_empty() {
                    let _ = Lattice::of_links(&mesh).map(|lattice| lattice.to_string());
                }
            }
            count += 1;
        }
    }
    assert!(count >= 2500, "{count} files");
}

/// Files of the formats that are read and not written: 1,000 damages of each.
#[test]
fn damaged_files_of_formats_that_are_only_read_never_panic() {
    let cases = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("tests/meshes/cases");
    for (name, family) in [
        ("cube.inp", Family::Abaqus),
        ("cube.bdf", Family::Nastran),
        ("cube.mesh", Family::Mfem),
        ("version1.msh", Family::Msh),
        ("cube40.msh", Family::Msh),
        ("cube40_binary.msh", Family::Msh),
        ("binary_elementdata_no_newline.msh", Family::Msh),
        ("lz4.vtu", Family::Vtu),
        ("cube_lzma.vtu", Family::Vtu),
        ("curved10.vtu", Family::Vtu),
        ("gmsh_order2.mesh", Family::Medit),
        ("gmsh_disk2.mesh", Family::Medit),
        ("gmsh_disk2.msh", Family::Msh),
        ("gmsh_disk2.bdf", Family::Nastran),
        ("curved10.bdf", Family::Nastran),
        ("vtk_texts_42_binary.vtk", Family::Vtk),
        ("vtk_texts_51.vtk", Family::Vtk),
    ] {
        let bytes = std::fs::read(cases.join(name)).expect("the file");
        assert!(family.read(&bytes).is_ok(), "{name}");
        let (mut refused, begin) = (0, Instant::now());
        for seed in 0..1000 {
            match family.read(&damaged(&bytes, &mut Random(seed))) {
                Ok(mesh) => assert!(mesh.cell_count() > 0, "{name}, seed {seed}"),
                Err(error) => {
                    assert!(!error.to_string().is_empty());
                    refused += 1;
                }
            }
        }
        assert!(refused > 100, "{name}: {refused}");
        assert!(begin.elapsed() < Duration::from_secs(120), "{name}: slow");
    }
}

/// TetGen's second-order tetrahedra, with one of the two files damaged; and what is read becomes a tiling
/// or is refused.
#[test]
fn damaged_second_order_files_of_tetgen_never_panic() {
    let cases = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("tests/meshes/cases");
    let folder = tempfile::tempdir().expect("a folder");
    let file = |extension: &str| {
        std::fs::read(cases.join(format!("tetgen_o2.{extension}"))).expect("the file")
    };
    let files = [file("node"), file("ele")];
    let read = |files: &[Vec<u8>]| read(Format::TetGen, files, folder.path());
    assert!(!read(&files).expect("a mesh").tetrahedra.is_empty());
    let (mut refused, begin) = (0, Instant::now());
    for seed in 0..1000 {
        let mut random = Random(seed);
        let mut files = files.to_vec();
        let chosen = random.below(2);
        files[chosen] = damaged(&files[chosen], &mut random);
        match read(&files) {
            Ok(mesh) => {
                assert!(mesh.cell_count() > 0, "seed {seed}");
                if let Err(error) = region_tiling(mesh, None) {
                    assert!(!error.to_string().is_empty());
                }
            }
            Err(error) => {
                assert!(!error.to_string().is_empty());
                refused += 1;
            }
        }
    }
    assert!(refused > 100, "{refused}");
    assert!(begin.elapsed() < Duration::from_secs(120), "slow");
}

#[test]
fn damaged_surfaces_never_panic() {
    let cases = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("tests/meshes/cases");
    for (name, read) in [
        (
            "cube.stl",
            surface::read_stl as fn(&[u8]) -> Result<Surface, MeshError>,
        ),
        ("cube_binary.stl", surface::read_stl),
        ("cube.obj", surface::read_obj),
    ] {
        let bytes = std::fs::read(cases.join(name)).expect("the file");
        assert_eq!(
            read(&bytes).expect("a surface").triangles.len(),
            12,
            "{name}"
        );
        let errors = (0..1000).filter(|&seed| read(&damaged(&bytes, &mut Random(seed))).is_err());
        assert!(errors.count() > 100, "{name}");
    }
}

#[test]
fn any_bytes_at_all_never_panic() {
    let families = [
        Family::Msh,
        Family::Vtk,
        Family::Vtu,
        Family::Medit,
        Family::Meditb,
        Family::Abaqus,
        Family::Nastran,
        Family::Mfem,
    ];
    for seed in 0..500 {
        let mut random = Random(seed);
        let bytes: Vec<u8> = (0..random.below(200))
            .map(|_| random.next() as u8)
            .collect();
        for family in families {
            assert!(family.read(&bytes).is_err());
        }
    }
}
