//! A theorem about many tilings at once that the kernel has confirmed: a family, or a system of patches.

use acutile_core::family::{AnyFamily, ProvedFamily, Tree};
use acutile_core::format::print;
use acutile_core::patches::{System, Theorem as ProvedSystem};
use acutile_core::proved::{hexadecimal, in_words};
use acutile_kernel::Verified;

/// A confirmed certificate of the kind `family` or `patches`, with a name.
#[derive(Debug)]
pub struct Theorem {
    /// A name of the catalogue, or what its file is called. Not part of what is proved.
    pub name: String,
    /// A description in a line, or nothing. It is no part of the proof.
    pub description: String,
    /// The letters of the tiles of a system of patches, in words of its family; perhaps none.
    pub letters: &'static str,
    claim: String,
    sha256: String,
    json: String,
    pub(super) content: Content,
}

/// The subject of a certificate.
#[derive(Debug)]
pub(super) enum Content {
    /// With the tree of its leaves.
    Family(Box<AnyFamily>, Tree),
    Patches(Box<System>),
}

impl Theorem {
    /// A confirmed family.
    pub fn of_family(
        name: String,
        description: String,
        proved: &ProvedFamily,
        family: AnyFamily,
    ) -> Theorem {
        let content = Content::Family(Box::new(family), proved.tree().clone());
        let certificate = proved.certificate();
        Theorem::new(name, description, certificate, proved.verified(), content)
    }

    /// A confirmed system of patches.
    pub fn of_system(
        name: String,
        description: String,
        proved: &ProvedSystem,
        system: System,
    ) -> Theorem {
        let content = Content::Patches(Box::new(system));
        let certificate = proved.certificate();
        Theorem::new(name, description, certificate, proved.verified(), content)
    }

    fn new(
        name: String,
        description: String,
        certificate: &[u8],
        verified: &Verified,
        content: Content,
    ) -> Theorem {
        // The kernel has read the bytes.
        let json = print::to_json(certificate).unwrap_or_default();
        Theorem {
            name,
            description,
            letters: "",
            claim: in_words(verified),
            sha256: hexadecimal(&verified.sha256),
            json: String::from_utf8(json).unwrap_or_default(),
            content,
        }
    }

    /// The same theorem with letters for its tiles.
    pub fn with_letters(self, letters: &'static str) -> Theorem {
        Theorem { letters, ..self }
    }

    /// The claim in words: the tilings and their further statements, with semicolons between.
    pub fn claim(&self) -> &str {
        &self.claim
    }

    /// The certificate in JSON.
    pub fn json(&self) -> &str {
        &self.json
    }

    /// The SHA-256 of the certificate, in hexadecimal digits.
    pub fn sha256(&self) -> &str {
        &self.sha256
    }
}
