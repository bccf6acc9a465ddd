//! TetGen's `.node` and `.ele` files (TetGen manual, section "File formats").
//!
//! Programs that write them do not agree on the order of a tetrahedron's corners. A mesh whose
//! volumes all come out negative is turned.

use super::Mesh;
use super::error::MeshError;
use super::numbering::Index;
use super::source::Source;

/// The nodes: a head `count 3 attributes markers`, then `number x y z …` for each. Gives a
/// mesh without tetrahedra, and finds its points by number.
pub fn read_nodes(bytes: &[u8]) -> Result<(Mesh, Index), MeshError> {
    let mut source = Source::with_comments(bytes, b'#');
    let count = source.int("the number of nodes")?;
    let dimension = source.int("the dimension")?;
    if dimension != 3 {
        return Err(source.error(format!("found dimension {dimension}, expected 3")));
    }
    let attributes = source.int("the number of attributes")?;
    let markers = source.int("the number of boundary markers")?;
    let further = further(&source, attributes, markers)?;
    let count = source.count(count, 2 * (4 + further), "nodes")?;
    let mut mesh = Mesh::default();
    mesh.points.reserve(count);
    for _ in 0..count {
        let tag = source.int("a node number")?;
        let point = [
            source.double("the coordinate x")?,
            source.double("the coordinate y")?,
            source.double("the coordinate z")?,
        ];
        for _ in 0..further {
            source.word("an attribute or a marker")?;
        }
        mesh.add_node(tag, point, source.place())?;
    }
    expect_end(&mut source, "nodes")?;
    if further > 0 {
        let note = format!("{attributes} attributes and {markers} markers of each node");
        mesh.unread.push(note);
    }
    let index = mesh.node_index()?;
    Ok((mesh, index))
}

/// The elements: a head `count 4 attributes`, then `number node node node node …` for each.
pub fn read_elements(bytes: &[u8], mut mesh: Mesh, index: &Index) -> Result<Mesh, MeshError> {
    let mut source = Source::with_comments(bytes, b'#');
    let count = source.int("the number of tetrahedra")?;
    let corners = source.int("4, the nodes of a tetrahedron")?;
    if corners != 4 {
        return Err(source.error(format!(
            "found {corners} nodes in a tetrahedron, expected 4 (TetGen's option -o2 gives 10)"
        )));
    }
    let attributes = source.int("the number of attributes")?;
    let attributes = further(&source, attributes, 0)?;
    let count = source.count(count, 2 * (5 + attributes), "tetrahedra")?;
    mesh.tetrahedra.reserve(count);
    for _ in 0..count {
        let tag = source.int("an element number")?;
        let mut nodes = [0; 4];
        for node in &mut nodes {
            *node = source.int("a node number")?;
        }
        let place = source.place();
        for k in 0..attributes {
            let attribute = source.double("an attribute")?;
            if k == 0 && attribute == attribute.trunc() && attribute.abs() < 1e15 {
                mesh.labels.push(attribute as i64);
            }
        }
        mesh.add_tetrahedron(index, tag, nodes, place)?;
    }
    expect_end(&mut source, "tetrahedra")?;
    let labelled = mesh.labels.len() == count;
    if !labelled {
        mesh.labels.clear();
    }
    if attributes > usize::from(labelled) {
        mesh.unread.push("attributes of tetrahedra".to_owned());
    }
    let mut mesh = mesh.checked()?;
    if are_all_negative(&mesh) {
        mesh.turn();
    }
    Ok(mesh)
}

fn further(source: &Source, attributes: i64, markers: i64) -> Result<usize, MeshError> {
    match (usize::try_from(attributes), usize::try_from(markers)) {
        (Ok(a), Ok(b)) if a <= source.remaining() && b <= source.remaining() => Ok(a + b),
        _ => Err(source.error(format!(
            "found {attributes} attributes and {markers} markers, expected few"
        ))),
    }
}

fn expect_end(source: &mut Source, what: &str) -> Result<(), MeshError> {
    match source.try_word() {
        None => Ok(()),
        Some(word) => {
            Err(source.unexpected(word, &format!("the end after the last of the {what}")))
        }
    }
}

/// Whether no tetrahedron comes out positive; in doubles, for the checker decides what the
/// orientation is after all.
fn are_all_negative(mesh: &Mesh) -> bool {
    mesh.tetrahedra.iter().all(|corners| {
        let [a, b, c, d] = corners.map(|corner| mesh.points[corner as usize]);
        let edge = |p: [f64; 3]| -> [f64; 3] { std::array::from_fn(|k| p[k] - a[k]) };
        let (b, c, d) = (edge(b), edge(c), edge(d));
        let cross = |k: usize| c[(k + 1) % 3] * d[(k + 2) % 3] - c[(k + 2) % 3] * d[(k + 1) % 3];
        b[0] * cross(0) + b[1] * cross(1) + b[2] * cross(2) < 0.0
    })
}
