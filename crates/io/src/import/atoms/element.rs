//! Chemical elements in the symbols and labels of crystal structures.

/// The symbols, deuterium and tritium among them.
const ELEMENTS: [&str; 120] = [
    "H", "D", "T", "He", "Li", "Be", "B", "C", "N", "O", "F", "Ne", "Na", "Mg", "Al", "Si", "P",
    "S", "Cl", "Ar", "K", "Ca", "Sc", "Ti", "V", "Cr", "Mn", "Fe", "Co", "Ni", "Cu", "Zn", "Ga",
    "Ge", "As", "Se", "Br", "Kr", "Rb", "Sr", "Y", "Zr", "Nb", "Mo", "Tc", "Ru", "Rh", "Pd", "Ag",
    "Cd", "In", "Sn", "Sb", "Te", "I", "Xe", "Cs", "Ba", "La", "Ce", "Pr", "Nd", "Pm", "Sm", "Eu",
    "Gd", "Tb", "Dy", "Ho", "Er", "Tm", "Yb", "Lu", "Hf", "Ta", "W", "Re", "Os", "Ir", "Pt", "Au",
    "Hg", "Tl", "Pb", "Bi", "Po", "At", "Rn", "Fr", "Ra", "Ac", "Th", "Pa", "U", "Np", "Pu", "Am",
    "Cm", "Bk", "Cf", "Es", "Fm", "Md", "No", "Lr", "Rf", "Db", "Sg", "Bh", "Hs", "Mt", "Ds", "Rg",
    "Cn", "Nh", "Fl", "Mc", "Lv", "Ts", "Og",
];

/// The meaning of a type symbol.
#[derive(Debug, PartialEq, Eq)]
pub enum Kind {
    /// One element, perhaps with a charge.
    Element(&'static str),
    /// A group of atoms at one place, like OH or NH4.
    Group,
    /// Several elements that share a place, like Fe0.5Ni0.5 or Al/Si.
    Mixture,
    /// Something else.
    Unknown,
}

/// The element with exactly this symbol.
fn exact(symbol: &str) -> Option<&'static str> {
    ELEMENTS.iter().find(|&&known| known == symbol).copied()
}

/// The element with this symbol in any case.
pub fn element(symbol: &str) -> Option<&'static str> {
    ELEMENTS
        .iter()
        .find(|known| known.eq_ignore_ascii_case(symbol))
        .copied()
}

/// The element at the beginning of a label like `Si1` or `O2A`: two letters if the second one
/// is small.
pub fn of_label(label: &str) -> Option<&'static str> {
    let head = |length| label.get(..length);
    head(2).and_then(exact).or_else(|| head(1).and_then(exact))
}

/// The meaning of a type symbol: an element with a charge like `Fe3+`, or something else. In
/// capitals `FE` is iron, while `NH4` is a group and not nihonium.
pub fn kind(symbol: &str) -> Kind {
    let letters = symbol.trim_end_matches(|c: char| c.is_ascii_digit() || matches!(c, '+' | '-'));
    let charge = &symbol[letters.len()..];
    let formula = parts(symbol).map_or(Kind::Unknown, |parts| of_parts(&parts));
    let has_count = !charge.is_empty() && !charge.contains(['+', '-']);
    match element(letters) {
        Some(_) if has_count && exact(letters).is_none() && formula == Kind::Group => formula,
        Some(known) => Kind::Element(known),
        None => formula,
    }
}

fn of_parts(parts: &[(&'static str, bool)]) -> Kind {
    let is_mixed = parts.iter().any(|(_, is_shared)| *is_shared);
    match parts {
        [] => Kind::Unknown,
        _ if is_mixed => Kind::Mixture,
        [(symbol, _)] => Kind::Element(symbol),
        _ => Kind::Group,
    }
}

/// The elements of a formula in order, and whether each one has a fractional count or stands beside a
/// separator. `None` if it is no formula.
fn parts(symbol: &str) -> Option<Vec<(&'static str, bool)>> {
    let mut rest = symbol;
    let mut parts = Vec::<(&'static str, bool)>::new();
    let mut is_separated = false;
    while !rest.is_empty() {
        if let Some(tail) = rest.strip_prefix(['/', ',', '(', ')', ' ', ';', '|', ':']) {
            is_separated = true;
            rest = tail;
            continue;
        }
        let length = [2, 1]
            .into_iter()
            .find(|&n| rest.get(..n).is_some_and(|head| exact(head).is_some()))?;
        let known = exact(&rest[..length])?;
        rest = &rest[length..];
        let end = rest
            .find(|c: char| !c.is_ascii_digit() && !matches!(c, '.' | '+' | '-'))
            .unwrap_or(rest.len());
        let (count, tail) = rest.split_at(end);
        rest = tail;
        parts.push((known, count.contains('.')));
    }
    if is_separated && parts.len() > 1 {
        parts.iter_mut().for_each(|part| part.1 = true);
    }
    Some(parts)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_and_labels() {
        for (text, expected) in [
            ("Fe", Kind::Element("Fe")),
            ("FE", Kind::Element("Fe")),
            ("Fe3+", Kind::Element("Fe")),
            ("O2-", Kind::Element("O")),
            ("Cl1-", Kind::Element("Cl")),
            ("D", Kind::Element("D")),
            ("OH", Kind::Group),
            ("NH4", Kind::Group),
            ("Fe0.5Ni0.5", Kind::Mixture),
            ("Al/Si", Kind::Mixture),
            ("(Fe,Ni)", Kind::Mixture),
            ("Fe3+0.5Ni2+0.5", Kind::Mixture),
            ("M", Kind::Unknown),
            ("", Kind::Unknown),
        ] {
            assert_eq!(kind(text), expected, "{text}");
        }
        assert_eq!(of_label("Si1"), Some("Si"));
        assert_eq!(of_label("CA1"), Some("C"));
        assert_eq!(of_label("V"), Some("V"));
        assert_eq!(of_label("M1"), None);
        assert_eq!(of_label("é1"), None);
    }
}
