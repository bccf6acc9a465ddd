//! Crystal structures as people have them: special positions, symbols, spellings, other formats. The numbers of
//! atoms are those of the structure types in the literature: hcp 2, C14 12, A15 8, diamond 8.

use acutile_io::import::cif::{CifOptions, Special, names, read_cif};
use acutile_io::import::crystal::{Kind, Structure, kind, read, text_of};
use malachite::Rational;
use std::path::Path;

/// A CIF from its parts; an angle of gamma that is 120 makes a hexagonal cell.
fn cif(symmetry: &str, [a, b, c]: [&str; 3], gamma: &str, sites: &str) -> String {
    format!(
        "data_t\n_cell_length_a {a}\n_cell_length_b {b}\n_cell_length_c {c}\n_cell_angle_gamma {gamma}\n{symmetry}\n\
         loop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n{sites}\n"
    )
}

fn symbol(symbol: &str) -> String {
    format!("_space_group_name_H-M_alt '{symbol}'")
}

fn operations(list: &[&str]) -> String {
    format!(
        "loop_\n_space_group_symop_operation_xyz\n'{}'",
        list.join("'\n'")
    )
}

pub fn hcp(site: &str) -> String {
    cif(&symbol("P 63/m m c"), ["3.21", "3.21", "5.21"], "120", site)
}

fn a15(symmetry: &str) -> String {
    cif(symmetry, ["4.72"; 3], "90", "Si1 0 0 0\nV1 0.25 0 0.5")
}

pub fn with(special: Special) -> CifOptions {
    CifOptions {
        special,
        ..CifOptions::default()
    }
}

fn atoms(text: &str, options: &CifOptions) -> usize {
    count(&read_cif(text, options).unwrap_or_else(|error| panic!("{error}\n{text}")))
}

fn count(structure: &Structure) -> usize {
    structure.points.points.len()
}

fn error(text: &str) -> String {
    error_with(text, &CifOptions::default())
}

fn error_with(text: &str, options: &CifOptions) -> String {
    match read_cif(text, options) {
        Ok(structure) => panic!("{:?}\n{text}", structure.notes),
        Err(error) => error.to_string(),
    }
}

#[test]
fn sites_near_special_positions() {
    for (site, as_written) in [
        ("Mg1 0.3333 0.6667 0.25", 6),
        ("Mg1 0.3333 0.6666 0.25", 6),
        ("Mg1 0.333 0.667 0.25", 6),
        ("Mg1 0.33333 0.66667 0.25", 6),
        ("Mg1 0.6667 0.3333 0.75", 6),
    ] {
        let text = hcp(site);
        let refused = error(&text);
        assert!(
            refused.contains("as written it stands for 6 atoms, on the special position for 2"),
            "{refused}"
        );
        assert!(refused.contains("--special moves"), "{refused}");
        assert_eq!(atoms(&text, &with(Special::Move)), 2, "{site}");
        assert_eq!(
            atoms(&text, &with(Special::AsWritten)),
            as_written,
            "{site}"
        );
    }
    let moved = read_cif(&hcp("Mg1 0.3333 0.6667 0.25"), &with(Special::Move)).expect("hcp");
    let note =
        "site Mg1: (3333/10000, 6667/10000, 1/4) moved to (1/3, 2/3, 1/4), which 12 operations fix";
    assert!(moved.notes.iter().any(|n| n == note), "{:?}", moved.notes);
    // A site that is exact, and one that is far from any special position, stay.
    assert_eq!(atoms(&hcp("Mg1 1/3 2/3 0.25"), &CifOptions::default()), 2);
    assert_eq!(
        atoms(&hcp("Mg1 0.34 0.64 0.31"), &CifOptions::default()),
        24
    );
    // z = 0.01 is as far from the mirror plane as its digits tell.
    let mirror = cif(&symbol("P m m m"), ["3", "4", "5"], "90", "A 0.1 0.2 0.01");
    assert_eq!(atoms(&mirror, &CifOptions::default()), 8);
}

/// C14, MgZn2: 12 atoms, though Zn2 is written with y off 2x by one unit.
#[test]
fn c14_and_a_cell_written_in_full() {
    let c14 = cif(
        &symbol("P 63/m m c"),
        ["5.223", "5.223", "8.566"],
        "120",
        "Mg1 0.33333 0.66667 0.0630\nZn1 0 0 0\nZn2 0.83046 0.66093 0.25",
    );
    assert!(error(&c14).contains("Zn2"));
    assert_eq!(atoms(&c14, &with(Special::Move)), 12);
    // Both atoms of hcp are listed: the second is an image of the first.
    let full = hcp("Mg1 0.3333 0.6667 0.25\nMg2 0.6667 0.3333 0.75");
    let structure = read_cif(&full, &with(Special::Move)).expect("hcp");
    assert_eq!(count(&structure), 2);
    let note = "site Mg2 is an image of site Mg1, and adds no atom";
    assert!(
        structure.notes.iter().any(|n| n == note),
        "{:?}",
        structure.notes
    );
    // Atoms of different elements at one place are disorder.
    let mixed = full.replace("Mg2", "Zn2");
    assert!(error_with(&mixed, &with(Special::Move)).contains("disorder"));
}

/// x = 0.22093667, y = 0.44187333 = 2x - 0.00000001, as pymatgen writes a site of multiplicity 9.
#[test]
fn multiplicities_are_compared() {
    let text = |multiplicity: &str| {
        cif(
            &symbol("R 3 m :H"),
            ["9.619", "9.619", "3.1499"],
            "120",
            &format!("S1 0.22093667 0.44187333 0.05026333 {multiplicity}"),
        )
        .replace("fract_z\n", "fract_z\n_atom_site_symmetry_multiplicity\n")
    };
    let structure = read_cif(&text("9"), &with(Special::Move)).expect("hR6");
    assert_eq!(count(&structure), 9);
    assert!(!structure.notes.iter().any(|note| note.contains("warning")));
    let wrong = read_cif(&text("18"), &with(Special::Move)).expect("hR6");
    let warning = "warning: site S1 gives 9 atoms, the file says 18";
    assert!(
        wrong.notes.iter().any(|note| note == warning),
        "{:?}",
        wrong.notes
    );
}

#[test]
fn snapping_changes_a_site_or_not() {
    let snap = |n: u32| CifOptions {
        snap: Some(n),
        ..CifOptions::default()
    };
    let p1 = cif(
        &symbol("P 1"),
        ["5.2", "5.2", "8.5"],
        "120",
        "A1 0.3333 0.6667 0.6\nB1 0.3 0.7 0.34\nC1 0 0 0",
    );
    for n in [3, 12] {
        let structure = read_cif(&p1, &snap(n)).expect("three atoms");
        let plain = read_cif(&p1, &CifOptions::default()).expect("three atoms");
        assert_eq!(structure.points.points, plain.points.points, "--snap {n}");
        assert!(structure.notes[0].starts_with("A1: the site is kept as it is written"));
    }
    assert_eq!(atoms(&hcp("Mg1 0.3333 0.6667 0.25"), &snap(12)), 2);
    assert_eq!(atoms(&hcp("Mg1 0.333 0.666 0.25"), &snap(3)), 2);
    // x = 1/7 and y = 0.284 is no position (x, 2x, 1/4) any more.
    let grown = hcp("Mg1 0.142 0.284 0.25");
    assert!(error_with(&grown, &snap(7)).contains("--snap 7 takes site Mg1 from 6 to 12 images"));
}

#[test]
fn symbols_without_operations() {
    let default = CifOptions::default();
    for symmetry in [
        symbol("P m -3 n"),
        symbol("Pm-3n"),
        symbol("P m 3 n"),
        symbol("P 42/m -3 2/n"),
        "_space_group_IT_number 223".to_owned(),
        "_space_group_name_Hall '-P 4n 2 3'".to_owned(),
        format!("_symmetry_Int_Tables_number 0\n{}", symbol("P m -3 n")),
    ] {
        assert_eq!(atoms(&a15(&symmetry), &default), 8, "{symmetry}");
    }
    let diamond =
        |symmetry: &str, x: &str| cif(symmetry, ["3.567"; 3], "90", &format!("C1 {x} {x} {x}"));
    assert_eq!(atoms(&diamond(&symbol("F d -3 m :1"), "0"), &default), 8);
    assert_eq!(
        atoms(&diamond(&symbol("F d -3 m :2"), "0.125"), &default),
        8
    );
    assert_eq!(atoms(&diamond(&symbol("F d -3 m S"), "0"), &default), 8);
    let ambiguous = error(&diamond(&symbol("F d -3 m"), "0"));
    for choice in [
        "F d -3 m :1 (Hall symbol F 4d 2 3 -1d)",
        "F d -3 m :2 (Hall symbol -F 4vw 2vw 3)",
    ] {
        assert!(ambiguous.contains(choice), "{ambiguous}");
    }
    assert!(
        error(&diamond("_space_group_IT_number 227", "0")).contains("2 settings that fit the cell")
    );
    // The cell tells hexagonal from rhombohedral axes, and the unique axis.
    let corundum = cif(
        &symbol("R -3 c"),
        ["4.76", "4.76", "12.99"],
        "120",
        "Al1 0 0 0.3522\nO1 0.3064 0 0.25",
    );
    assert_eq!(atoms(&corundum, &default), 30);
    let monoclinic = cif(&symbol("P 21/c"), ["5", "6", "7"], "90", "A 0.1 0.2 0.3")
        .replace("_cell_angle_gamma 90", "_cell_angle_beta 105");
    let structure = read_cif(&monoclinic, &default).expect("P 21/c");
    assert_eq!(count(&structure), 4);
    assert!(
        structure
            .notes
            .iter()
            .any(|note| note.contains("P 1 21/c 1"))
    );
    for (symmetry, words) in [
        (symbol("P m -3 q"), "in no table of settings"),
        (symbol("P 6/m m m"), "no setting that fits the cell"),
        (
            format!("{}\n_space_group_IT_number 225", symbol("P m -3 n")),
            "contradicts",
        ),
        (
            format!(
                "{}\n_space_group_name_Hall 'P 4n 2 3 -1n'",
                symbol("P m -3 m")
            ),
            "contradicts",
        ),
    ] {
        let found = error(&a15(&symmetry));
        assert!(found.contains(words), "{found}");
    }
}

#[test]
fn symbols_that_contradict_the_operations() {
    let identity = operations(&["x,y,z"]);
    for (symmetry, words) in [
        (
            symbol("P m -3 n"),
            "it stands for 48 operations, and 1 is listed",
        ),
        (
            symbol("F 4/m -3 2/m"),
            "it stands for 192 operations, and 1 is listed",
        ),
        (
            "_space_group_name_Hall '-P 4n 2 3'".to_owned(),
            "the Hall symbol",
        ),
        (
            "_space_group_IT_number 223".to_owned(),
            "the 1 listed operation at line 9, of number 1, P 1",
        ),
    ] {
        let found = error(&a15(&format!("{symmetry}\n{identity}")));
        assert!(found.contains(words), "{found}");
    }
    // P 21/a m is no P 21/n m: the glide of the list has no component along c.
    let list = ["x,y,z", "x+1/2,-y+1/2,-z", "x+1/2,-y+1/2,z", "x,y,-z"];
    let text = |name: &str, list: &[&str]| {
        let symmetry = format!("{}\n{}", symbol(name), operations(list));
        cif(
            &symmetry,
            ["5.12", "8.78", "9.44"],
            "90",
            "Fe1 0.1 0.2 0.15\nFe2 0.3 0.6 0",
        )
    };
    let found = error(&text("P 21 n m", &list));
    assert!(found.contains("those of number 26, P m c 21"), "{found}");
    assert_eq!(atoms(&text("P 21 a m", &list), &CifOptions::default()), 6);
    // P -1 with the inversion at 1/4, 0, 0: a symbol without a choice says nothing of the origin.
    let shifted = ["x,y,z", "-x+1/2,-y,-z"];
    assert_eq!(atoms(&text("P -1", &shifted), &CifOptions::default()), 4);
    // Origin choices are named.
    let second = [
        "x,y,z",
        "-x,-y,-z",
        "-x+1/2,-y+1/2,z",
        "x+1/2,-y,-z+1/2",
        "-x,y+1/2,-z+1/2",
        "x+1/2,y+1/2,-z",
        "-x+1/2,y,z+1/2",
        "x,-y+1/2,z+1/2",
    ];
    assert!(error(&text("P n n n :1", &second)).contains("does not agree"));
    assert_eq!(
        atoms(
            &text("P n n n", &operations_of_pnnn(&second)),
            &CifOptions::default()
        ),
        16
    );
}

/// The list of `P n n n :2`: -x+1/2,-y+1/2,z and so on, from gemmi.
fn operations_of_pnnn<'a>(list: &[&'a str]) -> Vec<&'a str> {
    let mut all = list.to_vec();
    all[3] = "x,-y+1/2,-z+1/2";
    all[4] = "-x+1/2,y,-z+1/2";
    all[6] = "-x,y+1/2,z+1/2";
    all[7] = "x+1/2,-y,z+1/2";
    all
}

#[test]
fn spellings_of_files() {
    let default = CifOptions::default();
    let hm = symbol("P m -3 n");
    let plain = a15(&hm);
    let p1 = cif(&symbol("P 1"), ["4", "5", "6"], "90", "Fe1 0.1 0.2 0.3");
    let pairs = p1
        .replace("loop_\n_atom_site_label", "_atom_site_label Fe1")
        .replace("fract_x", "fract_x 0.1")
        .replace("fract_y", "fract_y 0.2")
        .replace("fract_z\nFe1 0.1 0.2 0.3", "fract_z 0.3");
    for (text, expected) in [
        (plain.replace("data_t", "data_t\n_chemical_name_systematic [Cd(NH3)2]n"), 8),
        (format!("#\\#CIF_2.0\n{plain}_x [1 'a]' {{'b':2}}]\n_y '''it's\n'''\n"), 8),
        (plain.replace(&hm, &format!("{hm}\n_symmetry_Int_Tables_number '223'")), 8),
        (plain.replace("_cell_angle_gamma 90\n", ""), 8),
        (pairs, 1),
        (p1.replace("P 1'", "P 1'\n_symmetry_equiv_pos_as_xyz x,y,z"), 1),
        (p1.replace("P 1'", "P 1'\nloop_\n_symmetry_equiv_pos_as_xyz\nx,y,z\nx,y,z"), 1),
        (p1.replace("'P 1'", "'P -1'\n_symmetry_equiv_pos_as_xyz\n;x,y,z\n-x,-y,-z\n;"), 2),
        (
            p1.replace("P 1'", "P -1'\nloop_\n_space_group_symop_operation_xyz\n?\nloop_\n_symmetry_equiv_pos_as_xyz\nx,y,z\n-x,-y,-z"),
            2,
        ),
    ] {
        assert_eq!(atoms(&text, &default), expected, "{text}");
    }
    let bytes = [
        b"data_t\n_publ_author_name 'Universit\xe4t'\n".as_slice(),
        &plain.as_bytes()[7..],
    ]
    .concat();
    let latin = text_of(Path::new("a.cif"), bytes.clone()).expect("a CIF");
    assert_eq!(atoms(&latin, &default), 8);
    assert!(text_of(Path::new("a.json"), b"{ \xe4 }".to_vec()).is_err());
    for (text, words) in [
        (plain.replace("Si1", "Si\u{fffd}"), "bytes that are not UTF-8"),
        (
            plain.replace(&hm, "_space_group_magn.number_BNS 1.3\n_space_group_symop_magn_operation.xyz x,y,z,+1"),
            "magnetic CIF",
        ),
        (plain.replace("fract_", "Cartn_"), "Cartesian coordinates"),
        (
            p1.replace("P 1'", "P 1'\n_symmetry_equiv_pos_as_xyz x,y,z\nloop_\n_space_group_symop_operation_xyz\nx,y,z\n-x,-y,-z"),
            "two lists of symmetry operations that differ",
        ),
    ] {
        let found = error(&text);
        assert!(found.contains(words), "{found}");
    }
}

#[test]
fn lengths_agree_within_their_digits() {
    let cubic = |lengths| cif(&symbol("P m -3 m"), lengths, "90", "M1 0 0 0");
    // Without a list the symbol must fit the cell, so the list is written here.
    let listed = |lengths| {
        let fourfold = operations(&["x,y,z", "-y,x,z", "-x,-y,z", "y,-x,z"]);
        cif(&fourfold, lengths, "90", "M1 0 0 0")
    };
    let structure = read_cif(
        &listed(["24.177(3)", "24.1765", "9"]),
        &CifOptions::default(),
    )
    .expect("one cell");
    let note = "a = 24.177 is taken to be b = 24.1765, with which it agrees within its digits";
    assert!(
        structure.notes.iter().any(|n| n == note),
        "{:?}",
        structure.notes
    );
    assert!(!structure.notes.iter().any(|note| note.contains("rounding")));
    let length: Rational = Rational::from_signeds(241_765, 10_000);
    for k in 0..2 {
        assert_eq!(
            structure.points.frame.gram[k][k].to_rational(),
            Some(&(&length * &length))
        );
    }
    assert_eq!(
        atoms(
            &cubic(["24.177", "24.1765", "24.1765"]),
            &CifOptions::default()
        ),
        1
    );
    assert!(error(&listed(["5.000", "5.004", "9"])).contains("does not fit the cell"));
    assert!(error(&listed(["5.000", "5.001", "9"])).contains("does not fit the cell"));
    let hexagonal = operations(&["x,y,z", "-y,x-y,z", "-x+y,-x,z"]);
    let bent = cif(&hexagonal, ["5.000", "5.004", "8.1"], "119.999", "M1 0 0 0");
    assert!(error(&bent).contains("does not fit the cell"));
}

#[test]
fn distances_disorder_and_choices() {
    let p1 = |sites: &str| cif(&symbol("P 1"), ["10", "10", "10"], "90", sites);
    let near = p1("Fe1 0.33333 0.16667 0.25\nFe2 0.33392 0.16667 0.25\nO1 0.1 0.1 0.6");
    let structure = read_cif(&near, &CifOptions::default()).expect("three atoms");
    let last = structure.notes.last().expect("a note");
    assert!(
        last.starts_with("warning: the shortest distance is 0.0059, between Fe1"),
        "{last}"
    );
    let far = read_cif(&p1("Fe1 0 0 0\nO1 0.5 0 0"), &CifOptions::default()).expect("two atoms");
    let last = far.notes.last().expect("a note");
    assert!(
        last.starts_with("the shortest distance is 5.0000, between Fe1"),
        "{last}"
    );

    let only = |only: &[&str], except: &[&str]| {
        let list = |values: &[&str]| {
            names(&values.iter().map(|&v| v.to_owned()).collect::<Vec<_>>()).expect("names")
        };
        CifOptions {
            only: list(only),
            except: list(except),
            ..CifOptions::default()
        }
    };
    let sites = p1("Fe1 0 0 0\nFe2 0.5 0 0\nO1 0.2 0.3 0.4\n'O(1,2)' 0.7 0.1 0.2");
    assert_eq!(atoms(&sites, &only(&["Fe"], &[])), 2);
    assert_eq!(atoms(&sites, &only(&["Fe1,O1"], &[])), 2);
    assert_eq!(atoms(&sites, &only(&["\"O(1,2)\"", "Fe2"], &[])), 2);
    assert_eq!(atoms(&sites, &only(&[], &["O"])), 2);
    assert_eq!(atoms(&sites, &only(&["O"], &["O1"])), 1);
    assert!(error_with(&sites, &only(&["Zn"], &[])).contains("there is no site Zn"));
    assert!(error_with(&sites, &only(&["Fe"], &["Fe"])).contains("no site is left"));

    let with_column = |tag: &str, rows: &str| {
        p1(rows).replace("fract_z\n", &format!("fract_z\n_atom_site_{tag}\n"))
    };
    let groups = with_column(
        "disorder_group",
        "C1 0.1 0.1 0.1 .\nO1A 0.3 0.31 0.3 1\nO1B 0.31 0.35 0.3 2",
    );
    assert!(error(&groups).contains("site O1B is in disorder group 2, and site O1A in group 1"));
    assert_eq!(atoms(&groups, &only(&[], &["O1B"])), 2);
    let mixture = with_column("type_symbol", "M1 0.1 0.1 0.1 Fe0.5Ni0.5");
    assert!(error(&mixture).contains("several elements at one place"));
    let empty = with_column("occupancy", "H1 0.1 0.1 0.1 0\nO1 0.2 0.3 0.4 1");
    assert!(error(&empty).contains("has the occupancy 0"));
    let all = CifOptions {
        ignore_occupancy: true,
        ..CifOptions::default()
    };
    assert_eq!(atoms(&empty, &all), 1);
}

pub const POSCAR: &str = "a15\n1.0\n4.72 0 0\n0 4.72 0\n0 0 4.72\nSi V\n2 6\nDirect\n0 0 0\n0.5 0.5 0.5\n0.25 0 0.5\n\
                      0.75 0 0.5\n0.5 0.25 0\n0.5 0.75 0\n0 0.5 0.25\n0 0.5 0.75\n";
pub const XYZ: &str = "8\nLattice=\"4.72 0 0 0 4.72 0 0 0 4.72\" Properties=species:S:1:pos:R:3 pbc=\"T T T\"\nSi 0 0 0\n\
                   Si 2.36 2.36 2.36\nV 1.18 0 2.36\nV 3.54 0 2.36\nV 2.36 1.18 0\nV 2.36 3.54 0\nV 0 2.36 1.18\nV 0 2.36 3.54\n";

pub fn pymatgen() -> String {
    let sites: Vec<String> = POSCAR
        .lines()
        .skip(8)
        .enumerate()
        .map(|(index, line)| {
            let element = if index < 2 { "Si" } else { "V" };
            let abc = line.replace(' ', ", ");
            format!("{{\"species\": [{{\"element\": \"{element}\", \"occu\": 1}}], \"abc\": [{abc}], \"properties\": {{}}, \"label\": \"{element}\"}}")
        })
        .collect();
    format!(
        "{{\"@module\": \"pymatgen.core.structure\", \"@class\": \"Structure\", \"charge\": 0, \"lattice\": {{\"matrix\": \
         [[4.72, 0.0, 0.0], [0.0, 4.72, 0.0], [0.0, 0.0, 4.72]], \"pbc\": [true, true, true], \"a\": 4.72}}, \"sites\": [{}]}}",
        sites.join(", ")
    )
}

fn open(name: &str, text: &str) -> Result<Structure, String> {
    let kind = kind(Path::new(name), text).ok_or("no crystal structure")?;
    read(kind, text, &CifOptions::default()).map_err(|error| error.to_string())
}

/// A15 in three formats is the A15 of the CIF, with the same decimals.
#[test]
fn other_formats() {
    let default = CifOptions::default();
    let plain = read_cif(&a15(&symbol("P m -3 n")), &default).expect("A15");
    let points = |structure: &Structure| {
        let mut points: Vec<String> = structure
            .points
            .points
            .iter()
            .map(|p| format!("{p:?}"))
            .collect();
        points.sort();
        points
    };
    let scaled = POSCAR.replacen("1.0", "2", 1).replace("4.72", "2.36");
    let volume = POSCAR
        .replacen("1.0", "-0.841232384", 1)
        .replace("4.72", "2");
    let cartesian = POSCAR
        .replace("Direct", "Selective dynamics\nCartesian")
        .replace("0.25", "1.18 ")
        .replace("0.75", "3.54 ")
        .replace("0.5", "2.36");
    let old = POSCAR.replace("Si V\n", "").replacen("a15", "Si V", 1);
    for (name, text) in [
        ("POSCAR", POSCAR.to_owned()),
        ("53_POSCAR", format!("{POSCAR}\n0 0 0\n")),
        ("a.vasp", scaled),
        ("CONTCAR", cartesian),
        ("POSCAR", old),
        ("POSCAR", POSCAR.replace("Direct", "Fractional")),
        ("POSCAR", POSCAR.replace("Si V", "Si_pv V/3f2a")),
        ("-", POSCAR.to_owned()),
        ("a.xyz", XYZ.to_owned()),
        ("-", XYZ.to_owned()),
        ("a.json", pymatgen()),
        ("-", pymatgen()),
    ] {
        let found = open(name, &text).unwrap_or_else(|error| panic!("{name}: {error}\n{text}"));
        assert_eq!(points(&found), points(&plain), "{name}");
        assert_eq!(found.points.frame.gram, plain.points.frame.gram, "{name}");
        let silicon = found
            .elements
            .iter()
            .filter(|element| **element == Some("Si"))
            .count();
        assert_eq!(silicon, 2, "{name}");
        assert!(
            found.labels.iter().all(|label| !label.contains('/')),
            "{name}"
        );
    }
    // A volume of 0.841232384 = 0.944³ for the cell of edge 2: the scale is 0.472.
    let shrunk = open("POSCAR", &volume).expect("a rational scale");
    let edge = Rational::from_signeds(944, 1000);
    assert_eq!(
        shrunk.points.frame.gram[0][0].to_rational(),
        Some(&(&edge * &edge))
    );
    // A volume of 100 has the edge 100^(1/3), and 100^(2/3) = 21.5443469003188372...
    let irrational = open("POSCAR", &POSCAR.replacen("1.0", "-100", 1)).expect("rounded");
    let square = irrational.points.frame.gram[0][0].approximate();
    assert!((square - 21.544_346_900_318_84).abs() < 1e-10, "{square}");
    let notes = irrational.notes.join("\n");
    assert!(notes.contains("irrational, and rounded to"), "{notes}");
    for (name, text, words) in [
        (
            "POSCAR",
            POSCAR.replacen("1.0", "0", 1),
            "line 2: found \"0\", expected a scale or a volume that is not 0",
        ),
        (
            "POSCAR",
            POSCAR.replace("Direct\n", ""),
            "line 8: found \"0 0 0\", expected Direct or Cartesian",
        ),
        (
            "POSCAR",
            POSCAR.replace("2 6", "2 7"),
            "expected the position of an atom",
        ),
        (
            "POSCAR",
            POSCAR.replace("0 4.72 0", "9.44 0 0"),
            "the volume of the cell is 0",
        ),
        (
            "POSCAR",
            POSCAR.replace("0.25 0 0.5", "0.5 0.5 0.5"),
            "is at the place of the atom at line 10",
        ),
        (
            "a.xyz",
            XYZ.replace("T T T", "T T F"),
            "periodic in all directions",
        ),
        (
            "a.xyz",
            XYZ.replace("Lattice", "Cell"),
            "a file without a cell is no crystal",
        ),
        (
            "a.xyz",
            XYZ.replacen('8', "9", 1),
            "found 9 as the number of atoms, but 8 lines of atoms follow",
        ),
        (
            "a.xyz",
            format!("{XYZ}{XYZ}"),
            "choose one with --block 1 to --block 2",
        ),
        (
            "a.json",
            pymatgen().replacen("\"occu\": 1", "\"occu\": 0.5", 1),
            "sites[0]: has the occupancy 1/2",
        ),
        (
            "a.json",
            pymatgen().replace("[true, true, true]", "[true, true, false]"),
            "periodic in all directions",
        ),
    ] {
        match open(name, &text) {
            Ok(_) => panic!("{name}: {words}"),
            Err(found) => assert!(found.contains(words), "{found}"),
        }
    }
    let frames = CifOptions {
        block: Some("2".to_owned()),
        ..CifOptions::default()
    };
    let second = read(Kind::Xyz, &format!("{XYZ}{XYZ}"), &frames).expect("a frame");
    assert_eq!(count(&second), 8);
}
