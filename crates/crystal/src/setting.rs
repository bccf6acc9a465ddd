//! The 530 settings of the tables, and 34 more, by Hermann-Mauguin symbol or number.
//!
//! The list of the 530 is moyo's, with the symbols of International Tables A. A symbol is found without
//! regard to blanks. The tables have the full symbol, the short one, the older ones without `e` and `-3`,
//! and those of SHELX. `:1`, `:2`, `:H`, `:R` or the letters S, Z, H, R after it choose among settings.

use crate::extra::EXTRA;
use crate::hall;
use crate::motion::Motion;
use moyo::data::{HallSymbolEntry, hall_symbol_entry};
use std::collections::HashMap;
use std::sync::LazyLock;

/// A setting of a space group.
#[derive(Clone, Debug)]
pub struct Setting {
    /// 1 to 530 for the settings of the tables, more for others.
    pub index: i32,
    /// 1 to 230.
    pub number: u16,
    /// The Hall symbol.
    pub hall: &'static str,
    /// The full symbol.
    pub full: String,
    /// The short symbol.
    pub short: String,
    /// Origin choice, axes or cell choice: `1`, `H`, `b1`, `cab`; often empty.
    pub choice: &'static str,
}

impl Setting {
    fn of(entry: HallSymbolEntry) -> Setting {
        let plain = |symbol: &str| symbol.replace('_', "");
        Setting {
            index: entry.hall_number,
            number: u16::try_from(entry.number).unwrap_or_default(),
            hall: entry.hall_symbol,
            full: plain(entry.hm_full),
            short: plain(entry.hm_short),
            choice: entry.setting,
        }
    }

    /// A setting beyond the 530.
    fn extra(index: i32, (number, symbol, hall): (u16, &str, &'static str)) -> Setting {
        Setting {
            index,
            number,
            hall,
            full: symbol.to_owned(),
            short: symbol.to_owned(),
            choice: "",
        }
    }

    /// The group, sorted, modulo the lattice of the cell.
    ///
    /// # Errors
    /// Never for a setting of the list.
    pub fn group(&self) -> Result<Vec<Motion>, String> {
        hall::group(self.hall)
    }

    fn is_monoclinic(&self) -> bool {
        (3..=15).contains(&self.number)
    }

    /// The symbol with the choice, as a CIF writes it.
    pub fn name(&self) -> String {
        let symbol = if self.is_monoclinic() {
            &self.full
        } else {
            &self.short
        };
        match self.origin_or_axes() {
            "" => symbol.clone(),
            choice => format!("{symbol} :{choice}"),
        }
    }

    /// The part of a symbol after the colon: `1` or `2` of an origin choice like `1cab`, whose axes follow
    /// from the symbol, `H` or `R`.
    fn origin_or_axes(&self) -> &'static str {
        match self.choice.as_bytes().first() {
            Some(b'1' | b'2' | b'H' | b'R') => &self.choice[..1],
            _ => "",
        }
    }

    /// Whether it is meant by what stands after a colon.
    fn is_meant(&self, choice: &str) -> bool {
        let names = [self.choice, self.origin_or_axes()];
        names.iter().any(|name| name.eq_ignore_ascii_case(choice))
    }
}

/// The settings of the tables.
const TABULATED: i32 = 530;

/// All settings in order, those of the tables first.
pub fn settings() -> &'static [Setting] {
    static SETTINGS: LazyLock<Vec<Setting>> = LazyLock::new(|| {
        let tabulated = (1..=TABULATED)
            .filter_map(hall_symbol_entry)
            .map(Setting::of);
        let extra = (TABULATED + 1..).zip(EXTRA);
        let extra = extra.map(|(index, row)| Setting::extra(index, row));
        tabulated.chain(extra).collect()
    });
    &SETTINGS
}

/// The settings of a number that the tables have.
pub fn of_number(number: u16) -> Vec<&'static Setting> {
    let tabulated = settings().iter().filter(|s| s.index <= TABULATED);
    tabulated.filter(|s| s.number == number).collect()
}

/// A symbol that was looked up.
#[derive(Debug)]
pub struct Found {
    /// The settings it may stand for; none if it is not in the list.
    pub settings: Vec<&'static Setting>,
    /// Whether the symbol fixes the origin and the axes. Then its operations are exactly those of one of
    /// the settings, and not only up to the origin.
    pub is_fixed: bool,
}

/// The settings that a Hermann-Mauguin symbol may stand for.
pub fn of_symbol(symbol: &str) -> Found {
    let (symbol, choice) = split_choice(symbol);
    let key = key(&symbol);
    let mut found = keyed(&key);
    let mut choice = choice;
    if found.is_empty() && choice.is_none() {
        // R -3 m H, F d -3 m Z, F d -3 m S
        let (head, last) = key.split_at(key.len().saturating_sub(1));
        let of_letter = match last {
            "h" => Some("H"),
            "r" => Some("R"),
            "s" => Some("1"),
            "z" => Some("2"),
            _ => None,
        };
        if of_letter.is_some() && keyed(head).iter().any(|s| Some(s.choice) == of_letter) {
            found = keyed(head);
            choice = of_letter.map(ToOwned::to_owned);
        }
    }
    let mut is_fixed = false;
    if let Some(choice) = choice {
        let chosen: Vec<&Setting> = found
            .iter()
            .copied()
            .filter(|s| s.is_meant(&choice))
            .collect();
        is_fixed = !chosen.is_empty();
        if is_fixed {
            found = chosen;
        }
    }
    Found {
        settings: found,
        is_fixed,
    }
}

/// `F d -3 m :2` is a symbol and a choice; so is `F d -3 m (origin choice 2)`.
fn split_choice(text: &str) -> (String, Option<String>) {
    if let Some((symbol, choice)) = text.split_once(':') {
        return (symbol.to_owned(), Some(choice.trim().to_owned()));
    }
    let lower = text.to_ascii_lowercase();
    match lower.find("origin") {
        Some(at) => {
            let choice = lower[at..].chars().find(char::is_ascii_digit);
            let symbol = lower[..at].trim_end_matches(['(', '[', ',', ' ']);
            (symbol.to_owned(), choice.map(String::from))
        }
        None => (text.to_owned(), None),
    }
}

/// Lower case without blanks, underscores and parentheses.
fn key(symbol: &str) -> String {
    symbol
        .chars()
        .filter(|c| !c.is_whitespace() && !matches!(c, '_' | '(' | ')' | '~' | '$' | '{' | '}'))
        .map(|c| c.to_ascii_lowercase())
        .collect()
}

fn keyed(key: &str) -> Vec<&'static Setting> {
    let places = keys().get(key);
    places
        .into_iter()
        .flatten()
        .map(|&index| &settings()[index])
        .collect()
}

/// The settings of each spelling. Older spellings count only where no setting has them today.
fn keys() -> &'static HashMap<String, Vec<usize>> {
    static KEYS: LazyLock<HashMap<String, Vec<usize>>> = LazyLock::new(|| {
        let mut keys: HashMap<String, Vec<usize>> = HashMap::new();
        add(&mut keys, |setting| {
            let mut spellings = vec![key(&setting.full)];
            if setting.is_monoclinic() {
                spellings.push(without_ones(&setting.full));
            } else {
                spellings.push(key(&setting.short));
            }
            spellings
        });
        let today = keys.clone();
        add(&mut keys, |setting| {
            let mut spellings = older(&key(&setting.short), setting.index);
            spellings.extend(older(&key(&setting.full), setting.index));
            spellings.retain(|spelling| !today.contains_key(spelling));
            spellings
        });
        keys
    });
    &KEYS
}

fn add(keys: &mut HashMap<String, Vec<usize>>, spellings: impl Fn(&Setting) -> Vec<String>) {
    for (index, setting) in settings().iter().enumerate() {
        for spelling in spellings(setting) {
            let list = keys.entry(spelling).or_default();
            if !list.contains(&index) {
                list.push(index);
            }
        }
    }
}

/// `P 1 21/c 1` is usually written `P 21/c`.
fn without_ones(full: &str) -> String {
    full.split(' ')
        .filter(|word| *word != "1")
        .collect::<String>()
        .to_ascii_lowercase()
}

/// The glide that older spellings have for `e`, for the settings 316 to 333, those of the groups 67 and
/// 68: `C m m a` and `C m m b` are both `C m m e` today. (They are the symbols of gemmi's table for the
/// settings with the same operations.) In the other groups with `e` no two settings have one symbol.
const GLIDES: [&str; 18] = [
    "a", "b", "b", "c", "c", "a", "a", "a", "b", "b", "b", "b", "c", "c", "c", "c", "a", "a",
];
const FIRST_GLIDE: i32 = 316;

/// Spellings from before 1992: the name of one glide for `e`, and `3` for `-3`.
fn older(key: &str, index: i32) -> Vec<String> {
    let mut spellings = Vec::new();
    if key.contains('e') {
        let known = usize::try_from(index - FIRST_GLIDE).ok();
        let glides = match known.and_then(|place| GLIDES.get(place)) {
            Some(glide) => std::slice::from_ref(glide),
            None => &["a", "b", "c"][..],
        };
        for glide in glides {
            spellings.push(key.replace('e', glide));
        }
    }
    if key.contains("-3") && key.len() > 3 {
        spellings.push(key.replace("-3", "3"));
    }
    spellings
}
