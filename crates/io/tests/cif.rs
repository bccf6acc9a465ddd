//! CIF: the phases of the literature from their files, and what is refused with which words.
//!
//! The files are made by tests/cif/make.py, their operations by gemmi.

use acutile_core::classify::Star;
use acutile_core::delaunay::{DelaunayError, Ties, triangulate};
use acutile_core::statement::Statement;
use acutile_exact::number::Number;
use acutile_io::import::cif::{CifOptions, Special, read_cif};
use acutile_io::import::crystal::Structure;
use acutile_paper::survey::Study;
use malachite::Rational;
use std::path::{Path, PathBuf};

fn path(name: &str) -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join(format!("tests/cif/{name}.cif"))
}

fn text(name: &str) -> String {
    std::fs::read_to_string(path(name)).expect("a file of tests/cif")
}

fn snapped(text: &str, snap: u32) -> Structure {
    let options = CifOptions {
        snap: Some(snap),
        ..CifOptions::default()
    };
    read_cif(text, &options).unwrap_or_else(|error| panic!("{error}"))
}

fn read(text: &str) -> Structure {
    read_cif(text, &CifOptions::default()).unwrap_or_else(|error| panic!("{error}"))
}

fn error(text: &str) -> String {
    error_with(text, &CifOptions::default())
}

fn error_with(text: &str, options: &CifOptions) -> String {
    read_cif(text, options)
        .err()
        .expect("it is refused")
        .to_string()
}

/// Atoms in a cell and coordination numbers 12, 14, 15, 16 of the Frank-Kasper phases: F. C. Frank,
/// J. S. Kasper, Acta Cryst. 12 (1959) 483; D. P. Shoemaker, C. B. Shoemaker, Acta Cryst. B 42 (1986) 3,
/// table 1; mu has 7, 2, 2, 2 in the rhombohedral cell of 13. The denominators are those of the files'
/// rounded fractions. All six are acute with the parameters of the files: that is what exact arithmetic says.
#[test]
fn frank_kasper_phases() {
    for (name, snap, atoms, expected) in [
        ("a15", 1, 8, [2, 6, 0, 0]),
        ("sigma", 1, 30, [10, 16, 4, 0]),
        ("c15", 1, 24, [16, 0, 0, 8]),
        ("c14", 3, 12, [8, 0, 0, 4]),
        ("z", 3, 7, [3, 2, 2, 0]),
        ("mu", 6, 39, [21, 6, 6, 6]),
    ] {
        let cif = snapped(&text(name), snap);
        assert_eq!(cif.points.points.len(), atoms, "{name}");
        assert_eq!(cif.name, name);
        assert!(
            !cif.notes.iter().any(|note| note.contains("warning")),
            "{:?}",
            cif.notes
        );
        let study = Study::of_points(&cif.points).expect(name);
        let counts = study.star_counts();
        let found =
            [12, 14, 15, 16].map(|n| counts.get(&Star::FrankKasper(n)).copied().unwrap_or(0));
        assert_eq!(found, expected, "{name}");
        assert_eq!(found.iter().sum::<usize>(), atoms, "{name}");
        // Euler's characteristic of the torus is 0 and each tetrahedron has 4 facets: t = e - v.
        let edges = (12 * found[0] + 14 * found[1] + 15 * found[2] + 16 * found[3]) / 2;
        assert_eq!(study.tiling.len(), edges - atoms, "{name}");
        assert_eq!(study.check_tcp(), Ok(()), "{name}");
        for statement in [Statement::Acute, Statement::Delaunay, Statement::Tcp] {
            assert!(study.states(&statement), "{name}: {statement:?}");
        }
    }
}

/// The tetrahedra of bcc are Sommerville's, with dihedral angles of 60 and 90 degrees, 6 in a
/// primitive cell.
#[test]
fn bcc_is_nonobtuse() {
    let study = Study::of_points(&read(&text("bcc")).points).expect("bcc");
    assert_eq!(
        (
            study.tiling.vertices.len(),
            study.tiling.len(),
            study.shapes().len()
        ),
        (2, 12, 1)
    );
    assert!(study.states(&Statement::Nonobtuse) && !study.states(&Statement::Acute));
}

/// fcc has one octahedral hole for each atom. In diamond the centres of the six-rings are the 16c
/// positions, 16 in a cell of 8 atoms; six atoms lie around each.
#[test]
fn fcc_and_diamond_have_cells_that_are_not_tetrahedra() {
    for (name, atoms, cells) in [("fcc", 4, 4), ("diamond", 8, 16)] {
        let cif = read(&text(name));
        assert_eq!(cif.points.points.len(), atoms, "{name}");
        match triangulate(&cif.points, Ties::Refuse) {
            Err(DelaunayError::Cospherical(sets)) => {
                assert_eq!(sets.len(), cells, "{name}");
                assert!(sets.iter().all(|set| set.corners.len() == 6), "{name}");
            }
            other => panic!("{name}: {other:?}"),
        }
        assert!(triangulate(&cif.points, Ties::Pull).is_ok());
    }
}

/// -cos 97.5° = sin 7.5° = 0.13052619222005159154840622789549 (Abramowitz, Stegun 4.3.129, or any calculator).
#[test]
fn angles_with_irrational_cosines_are_rounded_and_told() {
    let cif = read(&text("monoclinic"));
    let expected: Rational = "-130526192220052/1000000000000000"
        .parse()
        .expect("a rational");
    let product = Rational::from_signeds(61, 10) * Rational::from_signeds(89, 10) * expected;
    assert_eq!(cif.points.frame.gram[0][2].to_rational(), Some(&product));
    assert_eq!(
        cif.points.frame.gram[0][1].to_rational(),
        Some(&Rational::from(0))
    );
    assert_eq!(
        cif.notes[..3],
        [
            "numbers with a standard uncertainty, like 0.1234(5): 1; it is left out, and the number before it is exact",
            "beta: the cosine is taken to be -0.130526192220052 (15 decimals; what is proved is proved of that lattice)",
            "2 sites, 4 operations, 8 images, 8 atoms in a cell: A1 4, A2 4",
        ]
    );
    assert!(Study::of_points(&cif.points).is_ok());
}

/// The volume of the cell is gemmi's.
#[test]
fn triclinic() {
    let cif = read(&text("triclinic"));
    let g = cif.points.frame.gram.each_ref().map(|row| {
        row.each_ref()
            .map(|x| x.to_string().parse::<Rational>().expect("rational"))
    });
    let minor = |i: usize, j: usize| &g[1][i] * &g[2][j] - &g[1][j] * &g[2][i];
    let squared = &g[0][0] * minor(1, 2) - &g[0][1] * minor(0, 2) + &g[0][2] * minor(0, 1);
    // gemmi.UnitCell(5.12, 6.34, 7.01, 81.3, 77.7, 68.9).volume = 206.72544785261377
    let volume = acutile_exact::number::parse_rational("206.72544785261377").expect("a decimal");
    let difference = squared / (&volume * &volume) - Rational::from(1);
    let tolerance = Rational::from_signeds(1, 1_000_000_000_000i64);
    assert!(difference < tolerance && difference > -tolerance);
    let study = Study::of_points(&cif.points).expect("a tiling");
    assert_eq!(study.tiling.vertices.len(), 5);
    assert!(!study.states(&Statement::Nonobtuse));
}

/// The literature's Z has 7 atoms. Read as written, its site at (1/3, 2/3, 1/2) has six images: exact
/// arithmetic says so, and warns.
#[test]
fn rounded_thirds_give_more_atoms_and_a_warning() {
    let as_written = CifOptions {
        special: Special::AsWritten,
        ..CifOptions::default()
    };
    let written =
        |text: &str| read_cif(text, &as_written).unwrap_or_else(|error| panic!("{error}"));
    assert!(
        error(&text("z")).contains("site Zr1 (0.3333, 0.6667, 0.5) is near a special position")
    );
    let cif = written(&text("z"));
    assert_eq!(cif.points.points.len(), 11);
    let warnings: Vec<&String> = cif
        .notes
        .iter()
        .filter(|note| note.contains("warning"))
        .collect();
    // Of the two thirds each has three images, all near each other: 2 * 3 pairs. The last warning is the distance.
    assert_eq!(warnings.len(), 5);
    assert_eq!(
        warnings[0],
        "warning: the atoms Zr1 (0.3333, 0.6667, 0.5) and Zr1 (0.3333, 0.6666, 0.5) differ by no more than the precision of the written digits"
    );
    assert!(
        warnings[3].starts_with("warning: 6 such pairs, which stay different atoms; --special"),
        "{}",
        warnings[3]
    );
    let snapped = snapped(&text("z"), 3);
    assert_eq!(snapped.points.points.len(), 7);
    assert_eq!(
        snapped.notes[..3],
        [
            "Zr1: x = 0.3333 replaced by 1/3",
            "Zr1: y = 0.6667 replaced by 2/3",
            "3 sites, 24 operations, 72 images, 7 atoms in a cell: Al1 3, Zr1 2, Zr2 2",
        ]
    );
    let says_two = text("z").replace(
        "_atom_site_label\n",
        "_atom_site_label\n_atom_site_symmetry_multiplicity\n",
    );
    let says_two = says_two
        .replace("Al1 ", "Al1 3 ")
        .replace("Zr1 ", "Zr1 2 ")
        .replace("Zr2 ", "Zr2 2 ");
    let notes = written(&says_two).notes;
    assert!(
        notes.contains(&"warning: site Zr1 gives 6 atoms, the file says 2".to_owned()),
        "{notes:?}"
    );
}

/// bcc by its primitive cell. The angle is arccos(-1/3), irrational in degrees, and the twofold rotation
/// about [001] requires exactly -1/3. It takes a1 to a2, and a3 to -(a1 + a2 + a3), so a1 · a3 = c becomes
/// -1 - 2c. With 100 degrees c = -0.17364817767.
#[test]
fn an_operation_that_fits_within_the_digits_makes_the_cell_exact() {
    let cif = |angle: &str| {
        format!(
            "data_bcc\n_cell_length_a 1\n_cell_length_b 1\n_cell_length_c 1\n_cell_angle_alpha {angle}\n_cell_angle_beta {angle}\n\
             _cell_angle_gamma {angle}\nloop_\n_symmetry_equiv_pos_as_xyz\nx,y,z\ny-z,x-z,-z\nloop_\n_atom_site_fract_x\n\
             _atom_site_fract_y\n_atom_site_fract_z\n0 0 0\n"
        )
    };
    let bcc = read(&cif("109.4712206"));
    let note = "lengths and angles fit the operations within their digits only: the metric is replaced by its mean under the operations";
    assert!(bcc.notes.contains(&note.to_owned()), "{:?}", bcc.notes);
    // The mean of a·b, which the rotation keeps, and of a·c and b·c, which it mixes, keeps a·b + a·c + b·c = -1.
    let entry = |i: usize, j: usize| {
        let entry = bcc.points.frame.gram[i][j].to_rational().cloned();
        entry.expect("a rational")
    };
    assert_eq!(entry(0, 2) + entry(1, 2) + entry(0, 1), -entry(0, 0));
    assert_eq!(
        error(&cif("100")),
        "line 11: the symmetry operation \"y-z,x-z,-z\" does not fit the cell: it takes a·c = -0.1736481777 to -0.6527036447"
    );
}

const P1: &str = "data_a\n_cell_length_a 2\n_cell_length_b 3\n_cell_length_c 4\n_cell_angle_alpha 90\n_cell_angle_beta 90\n\
                  _cell_angle_gamma 90\n_symmetry_space_group_name_H-M 'P 1'\nloop_\n_atom_site_label\n_atom_site_fract_x\n\
                  _atom_site_fract_y\n_atom_site_fract_z\n_atom_site_occupancy\nA 0 0 0 1\nB 0.5 0.3 0.1 .\n";

/// One file with one thing wrong: the message says where, what was found and what is needed.
#[test]
fn messages() {
    let a15 = text("a15");
    let edit = |text: &str, from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        error(&text.replacen(from, to, 1))
    };
    let p1 = |from: &str, to: &str| edit(P1, from, to);
    for (found, expected) in [
        (
            error(""),
            "line 1: no data block, expected a CIF, which begins with data_NAME",
        ),
        (
            error("# nothing\n"),
            "line 1: no data block, expected a CIF, which begins with data_NAME",
        ),
        (
            error("_cell_length_a 1\n"),
            "line 1: found \"_cell_length_a\", expected data_NAME first",
        ),
        (error("data_a _b"), "line 1: \"_b\" has no value"),
        (
            error("data_a\nstray"),
            "line 2: found \"stray\", expected a tag, loop_ or data_NAME",
        ),
        (error("data_a\nloop_\n1 2"), "line 2: loop_ has no tags"),
        (error("data_a\nloop_ _b _c"), "line 2: loop_ has no values"),
        (
            error("data_a"),
            "data_a: no sites, expected a loop_ with _atom_site_fract_x, _y and _z",
        ),
        (
            p1("_cell_length_b 3\n", ""),
            "data_a: _cell_length_b is missing",
        ),
        (
            p1("_cell_length_b 3", "_cell_length_b ?"),
            "data_a: _cell_length_b is missing",
        ),
        (
            p1("_cell_length_b 3", "_cell_length_b -3"),
            "line 3: _cell_length_b: found -3, expected more than 0",
        ),
        (
            p1("_cell_length_b 3", "_cell_length_b 3 4"),
            "line 3: found \"4\", expected a tag, loop_ or data_NAME",
        ),
        (
            p1("_cell_length_b 3", "_cell_length_a 3"),
            "line 3: \"_cell_length_a\" stands in this data block twice",
        ),
        (
            p1("_cell_length_b 3", "_CELL.length_A 3"),
            "line 3: \"_CELL.length_A\" stands in this data block twice",
        ),
        (
            p1("_cell_length_b 3", "_cell_length_b three"),
            "line 3: _cell_length_b: found \"three\", expected a number like 0.25, 0.3333(2) or 1/3, of at most 100 digits",
        ),
        (
            p1("_cell_angle_beta 90", "_cell_angle_beta 180"),
            "line 6: _cell_angle_beta: found 180, expected more than 0 and below 180",
        ),
        (
            p1("_cell_angle_beta 90", "_cell_angle_beta 0.0"),
            "line 6: _cell_angle_beta: found 0.0, expected more than 0 and below 180",
        ),
        (
            // 90, 60 and 30 degrees: the third axis would lie in the plane of the others.
            error(
                &P1.replace("_cell_angle_beta 90", "_cell_angle_beta 30")
                    .replace("_cell_angle_gamma 90", "_cell_angle_gamma 120"),
            ),
            "data_a: there is no cell with these angles: its volume would not be positive",
        ),
        (
            p1("'P 1'", "'P q'"),
            "line 8: the space group is \"P q\", which is in no table of settings, and its symmetry operations are not listed: \
             add a loop_ with _space_group_symop_operation_xyz and all operations ('x,y,z' alone for P1)",
        ),
        (
            p1(
                "_symmetry_space_group_name_H-M 'P 1'\n",
                "_space_group_IT_number 223\n",
            ),
            "line 8: the space group number 223 has no setting that fits the cell, and its symmetry operations are not listed: \
             add a loop_ with _space_group_symop_operation_xyz and all operations ('x,y,z' alone for P1)",
        ),
        (
            p1("'P 1'", "' '"),
            "data_a: no symmetry operations and no space group: add a loop_ with _space_group_symop_operation_xyz and all operations ('x,y,z' alone for P1)",
        ),
        (
            p1("_symmetry_space_group_name_H-M 'P 1'\n", ""),
            "data_a: no symmetry operations and no space group: add a loop_ with _space_group_symop_operation_xyz and all operations ('x,y,z' alone for P1)",
        ),
        (
            p1(
                "_symmetry_space_group_name_H-M 'P 1'\n",
                "_symmetry_Int_Tables_number 231\n",
            ),
            "line 8: found \"231\", expected the number of a space group, 1 to 230",
        ),
        (
            p1("_atom_site_fract_z\n", ""),
            "line 9: loop_ has 4 tags and 10 values, which fill no whole number of rows",
        ),
        (
            p1("_atom_site_fract_z", "_atom_site_fract_w"),
            "data_a: _atom_site_fract_z is missing",
        ),
        (
            p1("B 0.5", "B 0.5.1"),
            "line 16: x of site B: found \"0.5.1\", expected a number like 0.25, 0.3333(2) or 1/3, of at most 100 digits",
        ),
        (
            p1("B 0.5", "B ?"),
            "line 16: x of site B: is not known (?); leave the site out with --except",
        ),
        (
            p1("0 1\n", "0 0.75\n"),
            "line 15: site A has the occupancy 0.75: disorder cannot be a point set; choose sites with --only or --except, or take \
             each as an atom with --ignore-occupancy",
        ),
        (
            p1("B 0.5 0.3 0.1", "B 1.0 0 -2"),
            "line 16: site B has an atom at the place of one of site A (line 15): disorder cannot be a point set; choose sites with \
             --only, or merge them with --ignore-occupancy",
        ),
        (
            error(&format!("{P1}{}", P1.replace("data_a", "data_b"))),
            "data blocks: 2 have sites, choose one with --block: \"a\", \"b\"",
        ),
        (
            edit(&a15, "'-z,x,y'", "'-z,x,y,t'"),
            "line 47: the symmetry operation \"-z,x,y,t\" has 4 parts, expected three like x,y,z",
        ),
        (
            edit(&a15, "_cell_length_b 4.564", "_cell_length_b 4.565"),
            "line 14: the symmetry operation \"-y+1/2,x+1/2,z+1/2\" does not fit the cell: it takes a·a = 20.830096 to 20.839225",
        ),
        (
            edit(&a15, "IT_number 223", "IT_number 136"),
            "line 4: space group 136 does not agree with the 48 listed operations at line 13, of number 223, \
             P m -3 n: complete the list, or remove the number if the list is right",
        ),
        (
            edit(&a15, "'P m -3 n'", "'I m -3 m'"),
            "line 3: the symbol \"I m -3 m\" does not agree with the listed operations: it stands for 96 operations, and 48 are \
             listed at line 13, those of number 223, P m -3 n; complete the list, or remove the symbol or the list, whichever is wrong",
        ),
    ] {
        assert_eq!(found, expected);
    }
}

#[test]
fn options_choose_and_say_what_there_is() {
    let only = |labels: &[&str]| CifOptions {
        only: labels.iter().map(|&l| l.to_owned()).collect(),
        ..CifOptions::default()
    };
    assert_eq!(
        error_with(P1, &only(&["A", "C"])),
        "--only: there is no site C; the sites are \"A\", \"B\""
    );
    let half = P1.replace("0.1 .", "0.1 0.5(1)");
    assert_eq!(
        read_cif(&half, &only(&["A"]))
            .map(|cif| cif.points.points.len())
            .ok(),
        Some(1)
    );
    let all = CifOptions {
        ignore_occupancy: true,
        ..CifOptions::default()
    };
    assert_eq!(
        read_cif(&half, &all)
            .map(|cif| cif.points.points.len())
            .ok(),
        Some(2)
    );
    let same = P1.replace("0.5 0.3 0.1", "1 0 0.0");
    assert_eq!(
        read_cif(&same, &all)
            .map(|cif| cif.points.points.len())
            .ok(),
        Some(1)
    );
    let two = format!(
        "{P1}{}",
        P1.replace("data_a", "data_B").replace("A 0 0 0 1\n", "")
    );
    let block = |name: &str| CifOptions {
        block: Some(name.to_owned()),
        ..CifOptions::default()
    };
    assert_eq!(
        read_cif(&two, &block("b"))
            .map(|cif| cif.points.points.len())
            .ok(),
        Some(1)
    );
    assert_eq!(
        error_with(&two, &block("c")),
        "--block: there is no data block c; there are \"a\", \"B\""
    );
    let dummy = P1
        .replace("_occupancy", "_calc_flag")
        .replace("A 0 0 0 1", "A 0 0 0 dum");
    assert_eq!(
        error(&dummy),
        "line 15: site A is a dummy (_atom_site_calc_flag dum), no atom: leave it out with --except"
    );
}

/// Spellings that the standard allows or that programs write give the same points.
#[test]
fn spellings() {
    let plain = read(P1);
    for other in [
        P1.to_uppercase()
            .replace("_ATOM_SITE_LABEL", "_atom_site.LABEL"),
        P1.replace("_cell_length_", "_cell.length_")
            .replace("_atom_site_", "_atom_site."),
        P1.replace('\n', "\r\n"),
        P1.replace('\n', "\r"),
        format!("\u{feff}#\\#CIF_1.1\n{P1}"),
        P1.replace("_cell_length_b 3", "_cell_length_b\n;3\n;"),
        P1.replace("_cell_length_b 3", "_cell_length_b '3.00(4)' # three"),
        P1.replace(
            "_cell_length_a 2",
            "_publ_text\n;loop_\n data_b 'it's\n;\n_cell_length_a 2",
        ),
        P1.replace("'P 1'", "p1"),
        P1.replace(
            "_symmetry_space_group_name_H-M 'P 1'",
            "_space_group_IT_number 1",
        ),
        P1.replace(
            "_symmetry_space_group_name_H-M 'P 1'",
            "loop_ _space_group_symop.id _space_group_symop.operation_xyz 1 'X, +y, z'",
        ),
        P1.replace("0.5 0.3 0.1", "1/2 3e-1 +.1"),
    ] {
        let cif = read(&other);
        assert_eq!(cif.points.points, plain.points.points, "{other}");
        assert_eq!(cif.points.frame.gram, plain.points.frame.gram, "{other}");
    }
}

/// A list of operations with one missing, or with one sign or letter changed, is not the group of Pm-3n any
/// more. A cell with one length or angle changed is not its cell. So there are 48 + 48 + 4 planted defects,
/// each refused.
#[test]
fn planted_defects_are_refused() {
    let whole = text("a15");
    let lines: Vec<&str> = whole.lines().collect();
    let operations: Vec<usize> = (0..lines.len())
        .filter(|&k| lines[k].starts_with('\''))
        .collect();
    assert_eq!(operations.len(), 48);
    let with = |k: usize, line: Option<String>| {
        let mut kept: Vec<String> = lines.iter().map(|&line| line.to_owned()).collect();
        match line {
            Some(line) => kept[k] = line,
            None => drop(kept.remove(k)),
        }
        kept.join("\n")
    };
    for &k in &operations {
        assert!(!error(&with(k, None)).is_empty());
        let changed = if lines[k].contains("-x") {
            lines[k].replace("-x", "+x")
        } else {
            lines[k].replace('x', "-x").replace("+-", "-")
        };
        assert!(error(&with(k, Some(changed))).contains("line"));
    }
    for (from, to) in [
        ("a 4.564", "a 4.563"),
        ("c 4.564", "c 5"),
        ("alpha 90", "alpha 91"),
        ("gamma 90", "gamma 120"),
    ] {
        assert!(
            error(&whole.replacen(from, to, 1)).contains("does not fit the cell"),
            "{to}"
        );
    }
}

#[test]
fn limits_are_declined() {
    let is_limit = |text: &str| {
        read_cif(text, &CifOptions::default())
            .err()
            .expect("it is refused")
            .is_limit()
    };
    let symbol = "_symmetry_space_group_name_H-M 'P 1'\n";
    let operations = (0..1001).map(|k| format!("x+{k}/1001,y,z\n"));
    let list = format!(
        "loop_\n_symmetry_equiv_pos_as_xyz\n{}",
        operations.collect::<String>()
    );
    assert!(is_limit(&P1.replace(symbol, &list)));
    let sites: String = (0..200_000)
        .map(|k| format!("C 0.25 0.25 0.{k:06} 1\n"))
        .collect();
    assert!(is_limit(&format!("{P1}{sites}")));
    assert!(is_limit(&format!("{P1}#{}", " ".repeat(1 << 25))));
    assert!(!is_limit(&P1.replace("B 0.5", "B ?")));
}

/// C14 with uncertainties, and sites whose thirds are exact.
fn uncertain_c14(z: &str, x: &str, y: &str) -> String {
    text("c14")
        .replace("length_a 5.223", "length_a 5.223(1)")
        .replace("length_b 5.223", "length_b 5.223(1)")
        .replace("length_c 8.566", "length_c 8.566(3)")
        .replace("0.33333 0.66667 0.06286", &format!("1/3 2/3 {z}"))
        .replace("0.83048 0.66096 0.25", &format!("{x} {y} 0.25"))
}

fn within_su(text: &str) -> Result<Structure, String> {
    let options = CifOptions {
        within_su: true,
        ..CifOptions::default()
    };
    read_cif(text, &options).map_err(|error| error.to_string())
}

fn ratio(numerator: i64, denominator: i64) -> Rational {
    Rational::from_signeds(numerator, denominator)
}

/// By hand: c/a is between 8.563/5.224 and 8.569/5.222; z and x are free, and y = 2x follows.
#[test]
fn free_numbers_with_uncertainties() {
    let text = uncertain_c14("0.06286(6)", "0.83048(4)", "0.66096");
    let structure = within_su(&text).expect("three parameters");
    let variation = structure.variation.expect("asked for");
    let intervals: Vec<(&str, Rational, Rational)> = variation
        .intervals
        .iter()
        .map(|interval| {
            (
                interval.name.as_str(),
                interval.low.clone(),
                interval.high.clone(),
            )
        })
        .collect();
    assert_eq!(
        intervals,
        [
            ("c_over_a", ratio(8563, 5224), ratio(8569, 5222)),
            ("z_mg1", ratio(6280, 100_000), ratio(6292, 100_000)),
            ("x_zn2", ratio(83044, 100_000), ratio(83052, 100_000)),
        ]
    );
    // At any values the points are those of a file with these values.
    for (z, x, y) in [
        ("0.06286", "0.83048", "0.66096"),
        ("0.0629", "0.8305", "0.661"),
    ] {
        let other = read(&uncertain_c14(z, x, y));
        let point = [ratio(8566, 5223), decimal(z), decimal(x)].map(Number::from);
        let moved: Vec<[Number; 3]> = variation
            .points
            .iter()
            .map(|position| position.each_ref().map(|p| p.value(&point)))
            .collect();
        assert_eq!(moved, other.points.points);
        let square = Number::from(ratio(5223 * 5223, 1_000_000));
        for (row, expected) in variation.gram.iter().zip(&other.points.frame.gram) {
            for (entry, expected) in row.iter().zip(expected) {
                assert_eq!(&(&entry.value(&point) * &square), expected);
            }
        }
    }
}

fn decimal(text: &str) -> Rational {
    acutile_exact::number::parse_rational(text).expect("a decimal")
}

#[test]
fn uncertainties_that_are_no_box() {
    let none = within_su(&text("sigma")).err().expect("no uncertainty");
    assert!(
        none.contains("no number with a standard uncertainty"),
        "{none}"
    );
    // Snapped and special coordinates are exact: 0.25 is fixed by symmetry, though it has an uncertainty.
    let fixed = uncertain_c14("0.06286", "0.83048", "0.66096").replace("0.25\n", "0.25(1)\n");
    let variation = within_su(&fixed)
        .expect("c/a")
        .variation
        .expect("asked for");
    assert_eq!(variation.intervals.len(), 1);
    let site = |k: usize| format!("A{k} 0.1{k}(1) 0.2{k}(1) 0.3{k}(1)\n");
    let sites: String = (1..=6).map(site).collect();
    let many = format!(
        "data_many\n_cell_length_a 5\n_cell_length_b 6\n_cell_length_c 7\n_cell_angle_alpha 90\n_cell_angle_beta 90\n\
         _cell_angle_gamma 90\n_symmetry_equiv_pos_as_xyz 'x,y,z'\nloop_\n_atom_site_label\n_atom_site_fract_x\n\
         _atom_site_fract_y\n_atom_site_fract_z\n{sites}"
    );
    let refused = within_su(&many).err().expect("too many");
    assert!(
        refused.contains("18 numbers") && refused.contains("at most 16"),
        "{refused}"
    );
    // Four sites are 12 coordinates; three lengths are two quotients, and an angle is one cosine.
    let fewer: String = (1..=4).map(site).collect();
    let angle = many
        .replace(&sites, &fewer)
        .replace("length_b 6", "length_b 6.00(1)")
        .replace("length_c 7", "length_c 7.00(1)")
        .replace("beta 90", "beta 90.0(5)");
    let variation = within_su(&angle)
        .expect("15 parameters")
        .variation
        .expect("asked for");
    assert_eq!(variation.intervals.len(), 15);
    let cosine = &variation.intervals[2];
    assert_eq!(cosine.name, "cos_beta");
    // cos 90.5° = -0.0087265…, cos 89.5° = 0.0087265…
    assert!(cosine.low > ratio(-87_266, 10_000_000) && cosine.low < ratio(-87_265, 10_000_000));
    assert!(cosine.high > ratio(87_265, 10_000_000) && cosine.high < ratio(87_266, 10_000_000));
}

/// A rotation exchanges two axes and reverses the third one: so cos β = -cos α. Another one reverses
/// one axis: so two angles are right, whatever their uncertainties are.
#[test]
fn cosines_that_differ_in_sign_are_one_number() {
    let text = |angles: [&str; 3], operation: &str| {
        let [alpha, beta, gamma] = angles;
        format!(
            "data_signs\n_cell_length_a 5\n_cell_length_b 5\n_cell_length_c 7\n_cell_angle_alpha {alpha}\n\
             _cell_angle_beta {beta}\n_cell_angle_gamma {gamma}\nloop_\n_symmetry_equiv_pos_as_xyz\n'x,y,z'\n\
             '{operation}'\nloop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n\
             _atom_site_fract_z\nA 0 0 0\n"
        )
    };
    let gram = |text: &str| {
        let variation = within_su(text).expect(text).variation.expect("asked for");
        let names = variation.intervals.iter().map(|i| i.name.clone()).collect();
        (names, variation.gram)
    };
    let (names, [[_, _, beta], [_, _, alpha], _]): (Vec<String>, _) =
        gram(&text(["80.0(1)", "100.0(1)", "70.0(2)"], "y,x,-z"));
    assert_eq!(names, ["cos_alpha", "cos_gamma"]);
    // b_1 · b_3 = -b_2 · b_3 = -7/5 cos α, over the square of the first length.
    let point = [ratio(1, 6), ratio(1, 3)].map(Number::from);
    assert_eq!(alpha.value(&point), Number::from(ratio(7, 30)));
    assert_eq!(beta.value(&point), Number::from(ratio(-7, 30)));
    let (names, [[_, gamma, beta], [_, _, alpha], _]) =
        gram(&text(["90.0(1)", "95.0(1)", "90.0(2)"], "-x,y,-z"));
    assert_eq!(names, ["cos_beta"]);
    let point = [Number::from(ratio(1, 6))];
    assert_eq!(beta.value(&point), Number::from(ratio(7, 30)));
    assert!(alpha.is_zero() && gamma.is_zero());
}

/// A box must contain all structures within the uncertainties, or be refused.
#[test]
fn uncertainties_at_the_ends_are_covered() {
    let text = |cell: &str, x: &str, more: (&str, &str)| {
        format!(
            "data_ends\n{cell}_symmetry_equiv_pos_as_xyz 'x,y,z'\nloop_\n_atom_site_label\n_atom_site_fract_x\n\
             _atom_site_fract_y\n_atom_site_fract_z\n{}A 0 0 0 {}\nB {x} 0.4 0.3 {}\n",
            more.0, more.1, more.1
        )
    };
    let cell = |a: &str, gamma: &str| {
        format!(
            "_cell_length_a {a}\n_cell_length_b 6\n_cell_length_c 7\n_cell_angle_alpha 90\n_cell_angle_beta 90\n\
             _cell_angle_gamma {gamma}\n"
        )
    };
    // 180 degrees are within 175 and 6, and their cosine is -1; no angle of a cell is beyond.
    for (gamma, low, high) in [("175(6)", -1, 0), ("5(6)", 0, 1)] {
        let variation = within_su(&text(&cell("5", gamma), "0.3", ("", "")));
        let cosine = &variation
            .expect(gamma)
            .variation
            .expect("asked for")
            .intervals[0];
        assert_eq!(cosine.name, "cos_gamma");
        assert!(low == 0 || cosine.low == low, "{gamma}: {}", cosine.low);
        assert!(high == 0 || cosine.high == high, "{gamma}: {}", cosine.high);
    }
    for a in ["5(5)", "5(6)"] {
        let refused = within_su(&text(&cell(a, "90"), "0.3", ("", "")));
        assert!(
            refused
                .err()
                .expect(a)
                .contains("not more than its uncertainty")
        );
    }
    let apart = text(
        &cell("5", "90"),
        "0.3(1)",
        ("_atom_site_fract_x_su\n", "0.01"),
    );
    let refused = within_su(&apart).err().expect("a tag of its own");
    assert!(refused.contains("_atom_site_fract_x_su"), "{refused}");
    // 1/3 is where --snap moves the atom; the number itself is free between 0.3324 and 0.3342.
    let options = CifOptions {
        within_su: true,
        snap: Some(3),
        ..CifOptions::default()
    };
    let snapped = text(&cell("5", "90"), "0.3333(9)", ("", "")).replace("0.4 0.3", "0.6667 0.3333");
    let structure = read_cif(&snapped, &options).expect("one number");
    let variation = structure.variation.expect("asked for");
    let x = &variation.intervals[0];
    assert_eq!((&x.low, &x.high), (&decimal("0.3324"), &decimal("0.3342")));
}
