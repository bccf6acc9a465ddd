//! Bytes that are written: words in text, or numbers in binary.

use super::Mesh;
use super::source::Encoding;

/// The label of each cell, or its entity; if there are any and all have 32 bits.
pub fn labels(mesh: &Mesh) -> Option<&[i64]> {
    let labels = mesh.materials();
    let fit = labels.iter().all(|&label| i32::try_from(label).is_ok());
    (fit && !labels.is_empty()).then_some(labels)
}

/// Arrays of one integer for each cell, as meshio names them.
pub fn cell_arrays(mesh: &Mesh) -> Vec<(&'static str, &[i64])> {
    let arrays = [
        ("gmsh:physical", &mesh.labels[..]),
        ("gmsh:geometrical", &mesh.entities[..]),
    ];
    let is_written = |(_, values): &(&str, &[i64])| {
        !values.is_empty() && values.iter().all(|&value| i32::try_from(value).is_ok())
    };
    arrays.into_iter().filter(is_written).collect()
}

/// Writes numbers in text or in binary.
pub struct Sink {
    /// The bytes that have been written.
    pub bytes: Vec<u8>,
    encoding: Encoding,
}

impl Sink {
    /// Nothing written yet.
    pub fn new(encoding: Encoding) -> Self {
        Sink {
            bytes: Vec::new(),
            encoding,
        }
    }

    /// Text, in a binary file, too.
    pub fn text(&mut self, text: impl std::fmt::Display) {
        self.bytes.extend_from_slice(text.to_string().as_bytes());
    }

    /// Ends a line, in text.
    pub fn end(&mut self) {
        if self.encoding == Encoding::Text {
            match self.bytes.last_mut() {
                Some(last) if *last == b' ' => *last = b'\n',
                _ => self.bytes.push(b'\n'),
            }
        }
    }

    fn put<const N: usize>(&mut self, mut little: [u8; N]) {
        if self.encoding == Encoding::Big {
            little.reverse();
        }
        self.bytes.extend_from_slice(&little);
    }

    /// An integer of 32 bits; larger ones do not occur.
    pub fn int(&mut self, value: i64) {
        match self.encoding {
            Encoding::Text => self.decimal(value),
            _ => self.put((value as i32).to_le_bytes()),
        }
    }

    /// An integer of 64 bits.
    pub fn long(&mut self, value: i64) {
        match self.encoding {
            Encoding::Text => self.decimal(value),
            _ => self.put(value.to_le_bytes()),
        }
    }

    /// A double; in text the shortest decimal that is nearest to it.
    pub fn double(&mut self, value: f64) {
        match self.encoding {
            Encoding::Text => {
                self.text(Shortest(value));
                self.bytes.push(b' ');
            }
            _ => self.put(value.to_le_bytes()),
        }
    }

    fn decimal(&mut self, value: i64) {
        let mut digits = [0u8; 20];
        let mut at = digits.len();
        let mut rest = value.unsigned_abs();
        loop {
            at -= 1;
            digits[at] = b'0' + (rest % 10) as u8;
            rest /= 10;
            if rest == 0 {
                break;
            }
        }
        if value < 0 {
            self.bytes.push(b'-');
        }
        self.bytes.extend_from_slice(&digits[at..]);
        self.bytes.push(b' ');
    }

    /// Coordinates of a point.
    pub fn point(&mut self, point: &[f64; 3]) {
        point.iter().for_each(|&x| self.double(x));
    }
}

/// The shortest decimal that is read as this double.
pub struct Shortest(pub f64);

impl std::fmt::Display for Shortest {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self.0.abs() {
            0.0 | 1e-5..1e16 => write!(f, "{}", self.0),
            _ => write!(f, "{:e}", self.0),
        }
    }
}

/// The label of each cell, or `default` for all of them.
pub fn labels_or(mesh: &Mesh, default: i64) -> impl Iterator<Item = i64> {
    let labels = labels(mesh);
    (0..mesh.cell_count()).map(move |index| labels.map_or(default, |labels| labels[index]))
}
