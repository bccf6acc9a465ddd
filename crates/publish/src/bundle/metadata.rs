//! Who deposits an archive, in the formats of GitHub and Zenodo: `CITATION.cff` (1.2.0) and
//! `.zenodo.json`. Strings are written as JSON strings, which YAML reads as well.

use serde_json::{Value, json};
use std::str::FromStr;

/// The depositor's data about the archive.
#[derive(Clone, Debug, Default)]
pub struct Deposit {
    /// The title of the archive.
    pub title: Option<String>,
    /// Without an author the archive cites acutile alone.
    pub authors: Vec<Author>,
    /// An SPDX identifier for the data; programs in the archive have a licence of their own.
    pub licence: Option<String>,
    /// The DOI of the archive.
    pub doi: Option<Doi>,
    /// The DOI of the paper that the archive supplements.
    pub paper: Option<Doi>,
}

/// `Family, Given <0000-0002-1825-0097>`; the ORCID may be left out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Author {
    /// The family name.
    pub family: String,
    /// The given names.
    pub given: String,
    /// The ORCID, `0000-0002-1825-0097`.
    pub orcid: Option<String>,
}

/// `10.` with digits, a slash, and a suffix without spaces.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Doi(pub String);

impl FromStr for Doi {
    type Err = String;

    fn from_str(text: &str) -> Result<Doi, String> {
        let bare = text
            .strip_prefix("https://doi.org/")
            .unwrap_or(text)
            .trim_start_matches("doi:");
        let is_doi = bare.strip_prefix("10.").and_then(|rest| {
            let (registrant, suffix) = rest.split_once('/')?;
            let digits = registrant.chars().all(|c| c.is_ascii_digit() || c == '.');
            let plain = suffix.chars().all(|c| c.is_ascii_graphic());
            (digits && registrant.len() >= 4 && plain && !suffix.is_empty()).then_some(())
        });
        match is_doi {
            Some(()) => Ok(Doi(bare.to_owned())),
            None => Err("expected a DOI like 10.5281/zenodo.1234".to_owned()),
        }
    }
}

impl FromStr for Author {
    type Err = String;

    fn from_str(text: &str) -> Result<Author, String> {
        let expected = || "expected \"Family, Given\" or \"Family, Given <ORCID>\"".to_owned();
        let (name, orcid) = match text.split_once('<') {
            Some((name, rest)) => {
                let orcid = rest.trim().strip_suffix('>').ok_or_else(expected)?;
                (name, Some(orcid_of(orcid.trim())?))
            }
            None => (text, None),
        };
        let (family, given) = name.split_once(',').ok_or_else(expected)?;
        let (family, given) = (family.trim(), given.trim());
        let is_name = |s: &str| !s.is_empty() && !s.chars().any(char::is_control);
        if is_name(family) && is_name(given) {
            Ok(Author {
                family: family.to_owned(),
                given: given.to_owned(),
                orcid,
            })
        } else {
            Err(expected())
        }
    }
}

/// Four groups of four; the last character checks the others by ISO 7064, MOD 11-2.
fn orcid_of(text: &str) -> Result<String, String> {
    let bare = text.strip_prefix("https://orcid.org/").unwrap_or(text);
    let groups: Vec<&str> = bare.split('-').collect();
    let characters: Vec<char> = groups.concat().chars().collect();
    let has_form = groups.len() == 4 && groups.iter().all(|group| group.len() == 4);
    let [digits @ .., check] = &characters[..] else {
        return Err("expected an ORCID like 0000-0002-1825-0097".to_owned());
    };
    let digits: Option<Vec<u32>> = digits.iter().map(|c| c.to_digit(10)).collect();
    let (true, Some(digits)) = (has_form, digits) else {
        return Err(format!(
            "{bare}: expected an ORCID like 0000-0002-1825-0097"
        ));
    };
    let total = digits.iter().fold(0, |total, digit| (total + digit) * 2);
    let expected = match (12 - total % 11) % 11 {
        10 => 'X',
        digit => char::from_digit(digit, 10).unwrap_or('X'),
    };
    if *check == expected {
        Ok(bare.to_owned())
    } else {
        Err(format!(
            "{bare}: no ORCID: its last character is {check}, expected {expected}"
        ))
    }
}

/// An SPDX identifier by its characters.
///
/// # Errors
/// Another text.
pub fn licence(text: &str) -> Result<String, String> {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-.+".contains(c);
    if !text.is_empty() && text.chars().all(is_plain) {
        Ok(text.to_owned())
    } else {
        Err("expected an SPDX identifier like CC-BY-4.0".to_owned())
    }
}

impl Deposit {
    /// The title, or one made of the names of the tilings.
    pub fn title(&self, slugs: &[&str]) -> String {
        let made = || format!("Tilings proved in exact arithmetic: {}", slugs.join(", "));
        self.title.clone().unwrap_or_else(made)
    }

    /// `CITATION.cff`, of type dataset; `None` without an author.
    pub fn citation(&self, slugs: &[&str]) -> Option<String> {
        if self.authors.is_empty() {
            return None;
        }
        let message = match &self.paper {
            Some(paper) => format!(
                "Please cite this data set together with the paper https://doi.org/{}, and acutile, which proved it.",
                paper.0
            ),
            None => "Please cite this data set, and acutile, which proved it.".to_owned(),
        };
        let mut text = format!(
            "cff-version: 1.2.0\nmessage: {}\ntype: dataset\ntitle: {}\nauthors:\n",
            json!(message),
            json!(self.title(slugs))
        );
        for author in &self.authors {
            text += &format!(
                "  - family-names: {}\n    given-names: {}\n",
                json!(author.family),
                json!(author.given)
            );
            if let Some(orcid) = &author.orcid {
                text += &format!("    orcid: \"https://orcid.org/{orcid}\"\n");
            }
        }
        if let Some(licence) = &self.licence {
            text += &format!("license: {}\n", json!(licence));
        }
        if let Some(doi) = &self.doi {
            text += &format!("doi: {}\n", json!(doi.0));
        }
        text += &format!(
            "references:\n  - type: software\n    title: \"acutile: proofs in exact arithmetic that tilings by \
             tetrahedra are valid and acute\"\n    version: {}\n    license: MIT\n    authors:\n      - name: the acutile \
             authors\n",
            json!(env!("CARGO_PKG_VERSION"))
        );
        Some(text)
    }

    /// `.zenodo.json`; `None` without an author.
    pub fn zenodo(&self, slugs: &[&str]) -> Option<String> {
        if self.authors.is_empty() {
            return None;
        }
        let creators = self.authors.iter().map(|author| {
            let mut creator = json!({ "name": format!("{}, {}", author.family, author.given) });
            if let Some(orcid) = &author.orcid {
                creator["orcid"] = json!(orcid);
            }
            creator
        });
        let mut record = json!({
            "title": self.title(slugs),
            "upload_type": "dataset",
            "description": "<p>Certificates of tilings that small programs in the archive check in exact arithmetic. README.md says how.</p>",
            "creators": creators.collect::<Vec<Value>>(),
            "access_right": "open",
        });
        if let Some(licence) = &self.licence {
            record["license"] = json!(licence.to_lowercase());
        }
        if let Some(paper) = &self.paper {
            record["related_identifiers"] =
                json!([{ "identifier": paper.0, "relation": "isSupplementTo", "scheme": "doi" }]);
        }
        if let Some(doi) = &self.doi {
            record["doi"] = json!(doi.0);
        }
        serde_json::to_string_pretty(&record)
            .ok()
            .map(|text| text + "\n")
    }
}

#[cfg(test)]
mod tests {
    use super::{Author, Doi, licence};

    /// The examples of orcid.org's page on the structure of identifiers.
    #[test]
    fn orcids_have_a_check_character() {
        let author = |orcid: &str| format!("Carberry, Josiah <{orcid}>").parse::<Author>();
        for good in [
            "0000-0002-1825-0097",
            "0000-0001-5109-3700",
            "0000-0002-1694-233X",
        ] {
            assert_eq!(author(good).expect(good).orcid.as_deref(), Some(good));
        }
        for bad in [
            "0000-0002-1825-0098",
            "0000-0002-1694-2339",
            "0000-0002",
            "",
        ] {
            assert!(author(bad).is_err(), "{bad}");
        }
        for bad in [
            "Josiah Carberry",
            ", Josiah",
            "Carberry,",
            "A, B <0000-0002-1825-0097",
        ] {
            assert!(bad.parse::<Author>().is_err(), "{bad}");
        }
    }

    #[test]
    fn dois_and_licences() {
        assert!("10.5281/zenodo.1".parse::<Doi>().is_ok());
        assert_eq!(
            "https://doi.org/10.1016/j.comgeo.2003.11.003".parse::<Doi>(),
            Ok(Doi("10.1016/j.comgeo.2003.11.003".into()))
        );
        for bad in ["", "10.5281", "10.5281/", "11.5281/a", "10.5281/a b"] {
            assert!(bad.parse::<Doi>().is_err(), "{bad}");
        }
        assert!(licence("CC-BY-4.0").is_ok());
        assert!(licence("free: yes").is_err());
    }
}
