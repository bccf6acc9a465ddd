//! Which sites are taken: labels and elements of `--only` and `--except`.

use super::options::CifOptions;
use crate::import::ImportError;
use crate::import::words::short;

/// The names in values of an option: separated by commas, or in double quotes where a name
/// has a comma itself.
///
/// # Errors
/// A quote without an end.
pub fn names(values: &[String]) -> Result<Vec<String>, String> {
    let mut names = Vec::new();
    for value in values {
        let mut rest = value.as_str();
        while !rest.trim_start().is_empty() {
            let (name, tail) = first_name(rest.trim_start())?;
            names.push(name.to_owned());
            rest = tail;
        }
    }
    Ok(names)
}

fn first_name(text: &str) -> Result<(&str, &str), String> {
    let Some(quoted) = text.strip_prefix('"') else {
        let (name, tail) = text.split_once(',').unwrap_or((text, ""));
        return Ok((name.trim_end(), tail));
    };
    let (name, tail) = quoted
        .split_once('"')
        .ok_or_else(|| format!("{text}: the quote has no end"))?;
    let tail = tail.trim_start();
    match tail.strip_prefix(',') {
        Some(tail) => Ok((name, tail)),
        None if tail.is_empty() => Ok((name, tail)),
        None => Err(format!("{text}: expected a comma after the quote")),
    }
}

/// Whether each site is taken, from its label and its element.
///
/// A name is that of all sites with this label; if there is none, that of an element.
///
/// # Errors
/// A name of no site, or no site is left.
pub fn chosen(
    sites: &[(String, Option<&'static str>)],
    options: &CifOptions,
) -> Result<Vec<bool>, ImportError> {
    let mut chosen = vec![options.only.is_empty(); sites.len()];
    for (option, names, value) in [
        ("--only", &options.only, true),
        ("--except", &options.except, false),
    ] {
        for name in names {
            let found = sites_of(sites, name);
            if found.is_empty() {
                let problem = format!("there is no site {name}; the sites are {}", listed(sites));
                return Err(ImportError::entry(option, problem));
            }
            found.into_iter().for_each(|site| chosen[site] = value);
        }
    }
    if chosen.iter().all(|chosen| !chosen) {
        let problem = format!("no site is left of {}", listed(sites));
        return Err(ImportError::entry("--only and --except", problem));
    }
    Ok(chosen)
}

fn sites_of(sites: &[(String, Option<&'static str>)], name: &str) -> Vec<usize> {
    let with_label = |site: &usize| sites[*site].0 == name;
    let labelled: Vec<usize> = (0..sites.len()).filter(with_label).collect();
    if labelled.is_empty() {
        let of_element = |site: &usize| sites[*site].1 == Some(name);
        (0..sites.len()).filter(of_element).collect()
    } else {
        labelled
    }
}

/// The first labels, for a message.
fn listed(sites: &[(String, Option<&'static str>)]) -> String {
    let shown: Vec<String> = sites
        .iter()
        .take(20)
        .map(|(label, _)| short(label))
        .collect();
    let more = if sites.len() > shown.len() {
        ", …"
    } else {
        ""
    };
    format!("{}{more}", shown.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_with_commas_and_quotes() {
        let read =
            |values: &[&str]| names(&values.iter().map(|&v| v.to_owned()).collect::<Vec<_>>());
        assert_eq!(
            read(&["A,B", "C"]),
            Ok(vec!["A".into(), "B".into(), "C".into()])
        );
        assert_eq!(
            read(&["\"O(1,2)\", Si1"]),
            Ok(vec!["O(1,2)".into(), "Si1".into()])
        );
        assert!(read(&["\"A"]).is_err() && read(&["\"A\"B"]).is_err());
    }
}
