//! Reading a claim, with its claim file as a by-product: the canonical JSON of exactly the items
//! that are read. So the text that `--claim` compares is that of the claim that is checked.

use crate::cbor::Cbor;
use crate::claim::Claim;
use crate::refusal::{Checked, Place};
use num_bigint::BigInt;

/// An array or a record, of which some items have been read.
struct Open {
    /// The names of a record's members.
    names: &'static [&'static str],
    read: u64,
    length: u64,
}

pub(crate) struct Transcript<'c, 'r> {
    pub(crate) cbor: &'c mut Cbor<'r>,
    open: Vec<Open>,
    /// Of the field and of the parameters, once they are read.
    pub(crate) degree: usize,
    pub(crate) parameters: usize,
    /// The claim file, complete as soon as the claim is.
    pub(crate) json: String,
}

impl<'c, 'r> Transcript<'c, 'r> {
    pub(crate) fn new(cbor: &'c mut Cbor<'r>, kind: &str) -> Self {
        let json = format!("{{\n\"format\":\"acutile-claim\",\n\"version\":2,\n\"kind\":\"{kind}\"");
        let names = &["format", "version", "kind", "claim"];
        Transcript { cbor, open: vec![Open { names, read: 3, length: 4 }], degree: 1, parameters: 0, json }
    }

    /// For a list outside of the claim.
    pub(crate) fn of(cbor: &'c mut Cbor<'r>, claim: &Claim) -> Self {
        let (degree, parameters) = (claim.field.degree(), claim.parameters.len());
        Transcript { degree, parameters, ..Transcript::new(cbor, "") }
    }

    pub(crate) fn place(&self) -> Place {
        self.cbor.place()
    }

    pub(crate) fn is_array(&mut self) -> Checked<bool> {
        self.cbor.is_array()
    }

    /// The line feed between the items of the outer three levels.
    fn line(&self) -> &'static str {
        if self.open.len() <= 3 { "\n" } else { "" }
    }

    /// Writes an item, after a comma and its name.
    fn write(&mut self, text: &str) {
        let line = self.line();
        if let Some(Open { names, read, .. }) = self.open.last_mut() {
            self.json += if *read > 0 { "," } else { "" };
            self.json += line;
            let name = usize::try_from(*read).ok().and_then(|read| names.get(read));
            self.json += &name.map_or_else(String::new, |name| format!("\"{name}\":"));
            *read += 1;
        }
        self.json += text;
    }

    /// Closes the arrays and records of which all items have been read.
    fn close(&mut self) {
        while let Some(open) = self.open.last().filter(|open| open.read == open.length) {
            self.json += if open.length > 0 { self.line() } else { "" };
            self.json.push(if open.names.is_empty() { ']' } else { '}' });
            self.open.pop();
        }
    }

    fn open(&mut self, names: &'static [&'static str], length: u64) -> u64 {
        self.write(if names.is_empty() { "[" } else { "{" });
        self.open.push(Open { names, read: 0, length });
        self.close();
        length
    }

    pub(crate) fn record(&mut self, names: &'static [&'static str]) -> Checked {
        let length = self.cbor.array_of(names.len())?;
        self.open(names, length);
        Ok(())
    }

    /// An array of a given length, or of any; returns its length.
    pub(crate) fn array(&mut self, length: Option<usize>) -> Checked<u64> {
        let length = match length {
            Some(length) => self.cbor.array_of(length)?,
            None => self.cbor.array()?,
        };
        Ok(self.open(&[], length))
    }

    pub(crate) fn list<V>(
        &mut self,
        length: Option<usize>,
        mut read: impl FnMut(&mut Self) -> Checked<V>,
    ) -> Checked<Vec<V>> {
        (0..self.array(length)?).map(|_| read(self)).collect()
    }

    pub(crate) fn text(&mut self) -> Checked<String> {
        let text = self.cbor.text()?;
        self.write(&format!("\"{text}\""));
        self.close();
        Ok(text)
    }

    /// A number where the absolute value is less than 2^53, else a text.
    pub(crate) fn big(&mut self) -> Checked<BigInt> {
        let value = self.cbor.big()?;
        self.write(&if value.bits() <= 53 { value.to_string() } else { format!("\"{value}\"") });
        self.close();
        Ok(value)
    }
}
