//! Names of the constructions of the catalogue for readers, in TeX and in plain text.

use super::subject::Subject;
use super::tex::escape;

/// Names in TeX, and their plain text where that is another.
const NAMES: [(&str, &str, &str); 57] = [
    ("z", "Z over the triangle tiling", ""),
    ("a15", "A15 over the square tiling", ""),
    ("sigma", "$\\sigma$ ($3^2.4.3.4$)", "sigma (3^2.4.3.4)"),
    ("h", "H ($3^3.4^2$)", "H (3^3.4^2)"),
    (
        "square-triangle-3464",
        "Structure over $3.4.6.4$ with hexagons cut",
        "Structure over 3.4.6.4 with hexagons cut",
    ),
    (
        "square-triangle-inflated-3",
        "Structure over the inflated triangle tiling",
        "",
    ),
    (
        "square-triangle-inflated-4",
        "Structure over the inflated square tiling",
        "",
    ),
    (
        "square-triangle-inflated-32434",
        "Structure over $3^2.4.3.4$ inflated",
        "Structure over 3^2.4.3.4 inflated",
    ),
    ("z-c15-3", "Z and C15 over the triangle tiling", ""),
    ("z-c15-4", "Z and C15 over the square tiling", ""),
    (
        "z-c15-33344",
        "Z and C15 over $3^3.4^2$",
        "Z and C15 over 3^3.4^2",
    ),
    (
        "z-c15-32434",
        "Z and C15 over $3^2.4.3.4$",
        "Z and C15 over 3^2.4.3.4",
    ),
    ("icosahedral", "Icosahedra in layers", ""),
    ("c15", "C15", ""),
    ("a15-bcc", "A15 from the body-centred lattice", ""),
    ("c14", "C14", ""),
    ("c36", "C36", ""),
    ("mu", "$\\mu$", "mu"),
    ("c14-best", "C14, optimized", ""),
    ("z-best", "Z, optimized", ""),
    ("slab", "The slab", ""),
    ("slab-best", "The slab, optimized", ""),
    ("slab-stack", "The slab repeated", ""),
    ("bcc", "The body-centred cubic lattice (Sommerville II)", ""),
    ("sommerville-1", "Sommerville I", ""),
    ("sommerville-2", "Sommerville II", ""),
    ("sommerville-3", "Sommerville III", ""),
    ("sommerville-4", "Sommerville IV", ""),
    ("goldberg-1", "Goldberg's first family", ""),
    ("goldberg-2", "Goldberg's second family", ""),
    ("goldberg-3", "Goldberg's third family", ""),
    ("cube-5", "Cubes in five tetrahedra", ""),
    ("cube-6", "Cubes in six tetrahedra", ""),
    ("regular", "The regular tetrahedron", ""),
    ("cube-corner", "The corner of a cube", ""),
    (
        "two-corners",
        "Two acute tetrahedra that are not Delaunay",
        "",
    ),
    ("equilateral", "Equilateral triangles", ""),
    (
        "triangle-tiling",
        "Triangles with the sides $4$, $5$, $6$",
        "Triangles with the sides 4, 5, 6",
    ),
    ("square-8", "The square in eight triangles", ""),
    ("square-10", "The square in ten triangles", ""),
    ("square-14", "The square in fourteen triangles", ""),
    (
        "dodecahedron-470",
        "The regular dodecahedron in $470$ tetrahedra",
        "The regular dodecahedron in 470 tetrahedra",
    ),
    (
        "tetrahedron-543",
        "The regular tetrahedron in $543$ tetrahedra",
        "The regular tetrahedron in 543 tetrahedra",
    ),
    (
        "prism-533",
        "The triangular prism in $533$ tetrahedra",
        "The triangular prism in 533 tetrahedra",
    ),
    (
        "pentagonal-prism-515",
        "The pentagonal prism in $515$ tetrahedra",
        "The pentagonal prism in 515 tetrahedra",
    ),
    (
        "cube-2715",
        "The cube in $2715$ tetrahedra",
        "The cube in 2715 tetrahedra",
    ),
    (
        "octahedron-4344",
        "The regular octahedron in $4344$ tetrahedra",
        "The regular octahedron in 4344 tetrahedra",
    ),
    ("square-prism", "The infinite square prism", ""),
    (
        "cube-space",
        "Space with three families of mirror planes",
        "",
    ),
    ("goldberg-1-all", "Goldberg's first family, all ratios", ""),
    (
        "goldberg-1-nonobtuse",
        "Goldberg's first family, nonobtuse",
        "",
    ),
    ("goldberg-2-all", "Goldberg's second family, all ratios", ""),
    ("triangle-tiling-all", "Copies of any acute triangle", ""),
    ("z-all", "Z stretched", ""),
    ("a15-all", "A15 stretched", ""),
    (
        "square-triangle-all",
        "All tilings by squares and triangles",
        "",
    ),
    ("kagome-all", "All stacks of kagome layers", ""),
];

/// The name in TeX: that of people, or in typewriter letters that of the input.
pub fn human(name: &str) -> String {
    match NAMES.iter().find(|(known, _, _)| *known == name) {
        Some((_, tex, _)) => (*tex).to_owned(),
        None => format!("\\texttt{{{}}}", escape(name)),
    }
}

/// The name without commands.
pub fn plain(name: &str) -> String {
    match NAMES.iter().find(|(known, _, _)| *known == name) {
        Some((_, tex, "")) => (*tex).to_owned(),
        Some((_, _, plain)) => (*plain).to_owned(),
        None => name.to_owned(),
    }
}

/// The heading of a section.
pub fn heading(subject: &Subject) -> String {
    let plain = plain(&subject.name);
    format!(
        "\\texorpdfstring{{{}}}{{{}}}",
        human_name(subject),
        escape(&plain)
    )
}

/// The name for readers.
pub fn human_name(subject: &Subject) -> String {
    human(&subject.name)
}

/// The first sentence of a section.
pub fn introduction(subject: &Subject, citation: &str) -> String {
    let description = subject.description.trim();
    let what = if description.is_empty() {
        String::new()
    } else {
        format!("{}{citation}. ", escape(&capitalised(description)))
    };
    format!("\\noindent {what}")
}

fn capitalised(text: &str) -> String {
    let mut characters = text.chars();
    let first = characters.next().map(char::to_uppercase);
    first.into_iter().flatten().chain(characters).collect()
}
