//! `acutile gallery`: every link of the site leads somewhere inside it, and it has what it should.

use acutile_catalog as catalog;
use acutile_core::format;
use acutile_kernel::{Limits, verify};
use acutile_publish::report::{DOCUMENTS, Site, gallery};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// The values of an attribute in a page's markup, data of scripts left out.
fn attributes(page: &str, name: &str) -> Vec<String> {
    let mut values = Vec::new();
    for part in page.split("<script").enumerate().map(|(k, part)| match k {
        0 => part,
        _ => part.split_once("</script>").map_or("", |(_, rest)| rest),
    }) {
        for (at, _) in part.match_indices(&format!(" {name}=\"")) {
            let value = &part[at + name.len() + 3..];
            values.push(value[..value.find('"').expect("a quote")].to_owned());
        }
    }
    values
}

/// A relative link from a page, as a path of the site.
fn target(from: &str, link: &str) -> String {
    let mut parts: Vec<&str> = from.split('/').collect();
    parts.pop();
    for part in link.split('/') {
        match part {
            ".." => assert!(
                parts.pop().is_some(),
                "{from}: {link} leads out of the site"
            ),
            part => parts.push(part),
        }
    }
    parts.join("/")
}

fn check_links(site: &Site) {
    let mut checked = 0;
    for (path, bytes) in site.iter().filter(|(path, _)| path.ends_with(".html")) {
        let page = std::str::from_utf8(bytes).expect("UTF-8");
        for link in [attributes(page, "href"), attributes(page, "src")].concat() {
            if link.starts_with("https://") || link == "data:," {
                continue;
            }
            assert!(
                !link.contains(':') && !link.starts_with('/'),
                "{path}: {link} is relative"
            );
            let (file, anchor) = link.split_once('#').unwrap_or((&link, ""));
            let file = match file {
                "" => path.clone(),
                file => target(path, file),
            };
            let found = site.get(&file);
            assert!(
                found.is_some(),
                "{path}: {link} leads to {file}, which is not there"
            );
            if !anchor.is_empty() {
                let there = String::from_utf8_lossy(found.expect("checked"));
                let ids = attributes(&there, "id");
                assert!(
                    ids.contains(&anchor.to_owned()),
                    "{path}: {link} has no place in {file}"
                );
            }
            checked += 1;
        }
        let ids = attributes(page, "id");
        let different: BTreeSet<&String> = ids.iter().collect();
        assert_eq!(ids.len(), different.len(), "{path}: a name is there twice");
    }
    assert!(checked > 300, "{checked} links");
}

/// A path of the repository.
fn repository(path: &str) -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join(path)
}

#[test]
fn the_site_of_the_catalogue() {
    let site = gallery().expect("the catalogue is proved");
    check_links(&site);
    for name in catalog::names() {
        let certificate = &site[&format!("certificates/{name}.json")];
        let file = std::fs::read(repository(&format!("certificates/{name}.json"))).expect(name);
        assert_eq!(*certificate, file, "{name}");
        let cbor = format::to_cbor(certificate).expect(name);
        verify(&mut &cbor[..], &Limits::DEFAULT).expect(name);
        assert!(site.contains_key(&format!("tilings/{name}.html")));
        assert!(site.contains_key(&format!("pictures/{name}.svg")));
    }
    // Families and systems of patches, too, have the certificates of the repository.
    let families = catalog::entries().iter().filter(|entry| entry.has_box());
    let names = families.map(|entry| entry.name);
    for name in names.chain(catalog::THEOREMS.iter().map(|theorem| theorem.name)) {
        let file = std::fs::read(repository(&format!("certificates/{name}.json"))).expect(name);
        assert_eq!(site[&format!("certificates/{name}.json")], file, "{name}");
    }
    let index = String::from_utf8_lossy(&site["index.html"]);
    for name in catalog::names() {
        let link = format!("href=\"tilings/{name}.html\"");
        assert_eq!(
            index.matches(&link).count(),
            2,
            "{name}: a card and a row of the table"
        );
    }
    // Misprints that the paper is known to have: README.md.
    let paper = String::from_utf8_lossy(&site["paper.html"]);
    assert!(paper.contains("87.70") && paper.contains("misprint"));
    let bytes: usize = site.values().map(Vec::len).sum();
    // All pages share one viewer, a quarter of a megabyte.
    assert!(bytes < 12_000_000, "{bytes} bytes");
}

#[test]
fn every_document_is_in_the_site() {
    for entry in std::fs::read_dir(repository("docs")).expect("docs") {
        let name = entry
            .expect("an entry")
            .file_name()
            .into_string()
            .expect("UTF-8");
        if name.ends_with(".md") {
            let path = format!("docs/{name}");
            let is_there = DOCUMENTS.iter().any(|document| document.path == path);
            assert!(
                is_there,
                "{path} is missing in DOCUMENTS of crates/publish/src/report/documents.rs"
            );
        }
    }
}
