//! The numbers that a file gives to its nodes, its elements or its lines: mostly
//! consecutive, then they take no memory.

use super::error::{MeshError, Place};

/// A list of numbers, stored only where they are not consecutive.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Numbering {
    first: u64,
    length: usize,
    list: Option<Vec<u64>>,
}

/// A number that occurs twice, with the positions of both.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Repeated {
    /// The number.
    pub tag: u64,
    /// Where it is, counted from 0.
    pub positions: (u32, u32),
}

impl Numbering {
    /// `first`, `first` + 1, and so on.
    pub fn consecutive(first: u64, length: usize) -> Self {
        Numbering {
            first,
            length,
            list: None,
        }
    }

    /// How many numbers there are.
    pub fn len(&self) -> usize {
        self.length
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.length == 0
    }

    /// The number at a position below [`Numbering::len`].
    pub fn get(&self, position: usize) -> u64 {
        match &self.list {
            Some(list) => list[position],
            None => self.first.wrapping_add(position as u64),
        }
    }

    /// Whether each number is the one before and one.
    pub fn is_consecutive(&self) -> bool {
        self.list.is_none()
    }

    /// All numbers in order.
    pub fn iter(&self) -> impl Iterator<Item = u64> {
        (0..self.length).map(|position| self.get(position))
    }

    /// Appends a number.
    pub fn push(&mut self, tag: u64) {
        if self.length == 0 {
            self.first = tag;
        }
        match &mut self.list {
            Some(list) => list.push(tag),
            None if tag == self.first.wrapping_add(self.length as u64) => {}
            None => {
                let mut list: Vec<u64> = self.iter().collect();
                list.push(tag);
                self.list = Some(list);
            }
        }
        self.length += 1;
    }

    /// The positions of the numbers.
    ///
    /// # Errors
    /// Where a number occurs twice.
    pub fn index(&self) -> Result<Index, Repeated> {
        let Some(list) = &self.list else {
            return Ok(Index::Range(self.first, self.length));
        };
        let smallest = list.iter().copied().min().unwrap_or(0);
        let largest = list.iter().copied().max().unwrap_or(0);
        match usize::try_from(largest - smallest) {
            Ok(span) if span / 4 <= list.len() => dense(list, smallest, span + 1),
            _ => sorted(list),
        }
    }
}

/// Finds the position of a number.
#[derive(Clone, Debug)]
pub enum Index {
    /// Consecutive numbers: the first, and how many.
    Range(u64, usize),
    /// A table from the smallest number on, `u32::MAX` where there is none.
    Dense(u64, Vec<u32>),
    /// Pairs of number and position in order.
    Sorted(Vec<(u64, u32)>),
}

fn dense(list: &[u64], smallest: u64, span: usize) -> Result<Index, Repeated> {
    let mut table = vec![u32::MAX; span];
    for (position, &tag) in (0..).zip(list) {
        let slot = &mut table[(tag - smallest) as usize];
        if *slot != u32::MAX {
            let positions = (*slot, position);
            return Err(Repeated { tag, positions });
        }
        *slot = position;
    }
    Ok(Index::Dense(smallest, table))
}

fn sorted(list: &[u64]) -> Result<Index, Repeated> {
    let mut pairs: Vec<(u64, u32)> = list.iter().copied().zip(0..).collect();
    pairs.sort_unstable();
    match pairs.windows(2).find(|pair| pair[0].0 == pair[1].0) {
        Some(pair) => Err(Repeated {
            tag: pair[0].0,
            positions: (pair[0].1, pair[1].1),
        }),
        None => Ok(Index::Sorted(pairs)),
    }
}

impl Index {
    /// The position of a number.
    pub fn find(&self, tag: i64) -> Option<u32> {
        let tag = u64::try_from(tag).ok()?;
        match self {
            Index::Range(first, length) => tag
                .checked_sub(*first)
                .filter(|position| *position < *length as u64)
                .map(|position| position as u32),
            Index::Dense(smallest, table) => {
                let slot = usize::try_from(tag.checked_sub(*smallest)?).ok()?;
                table.get(slot).copied().filter(|&p| p != u32::MAX)
            }
            Index::Sorted(pairs) => {
                let found = pairs.binary_search_by_key(&tag, |pair| pair.0).ok()?;
                Some(pairs[found].1)
            }
        }
    }

    /// The numbers of all nodes, for a message about another number.
    pub fn in_words(&self) -> String {
        let (first, count, gaps) = match self {
            Index::Range(first, length) => (*first, *length as u64, ""),
            Index::Dense(first, table) => (*first, table.len() as u64, ", with gaps"),
            Index::Sorted(pairs) => {
                let tag = |pair: Option<&(u64, u32)>| pair.map_or(0, |pair| pair.0);
                let (first, last) = (tag(pairs.first()), tag(pairs.last()));
                (first, (last - first).saturating_add(1), ", with gaps")
            }
        };
        if count == 0 {
            return "the file has no nodes".to_owned();
        }
        let last = first.saturating_add(count - 1);
        format!("the nodes of the file are {first} to {last}{gaps}")
    }
}

/// The point with this number, for a pair of a periodic link.
pub fn periodic_node(index: &Index, tag: i64, place: Place) -> Result<u32, MeshError> {
    index.find(tag).ok_or_else(|| {
        let problem = format!(
            "found the node {tag} in a periodic link; {}",
            index.in_words()
        );
        MeshError::at(place, problem)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbering(tags: &[u64]) -> Numbering {
        let mut numbering = Numbering::default();
        tags.iter().for_each(|&tag| numbering.push(tag));
        numbering
    }

    #[test]
    fn finds_what_was_pushed_whatever_the_order() {
        let far = u64::from(u32::MAX) * 5;
        for tags in [vec![7, 8, 9], vec![3, 1, 2, 9], vec![5, far, 1]] {
            let numbering = numbering(&tags);
            let index = numbering.index().expect("no number twice");
            for (position, &tag) in (0..).zip(&tags) {
                assert_eq!(numbering.get(position as usize), tag);
                assert_eq!(index.find(tag as i64), Some(position));
            }
            assert_eq!(index.find(4), None);
            assert_eq!(index.find(-1), None);
        }
    }

    #[test]
    fn names_a_number_that_is_there_twice() {
        let far = u64::from(u32::MAX) * 5;
        for tags in [vec![3, 1, 2, 1], vec![3, 1, far, 1]] {
            let repeated = numbering(&tags).index().expect_err("1 occurs twice");
            assert_eq!((repeated.tag, repeated.positions), (1, (1, 3)));
        }
    }
}
