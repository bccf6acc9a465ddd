//! The open facets and edges, found by name: for each vertex a list of those whose first vertex
//! it is.
//!
//! The lists are short where each vertex has few open facets, and no input can make names
//! collide. Neighbours are near to each other in memory if neighbouring vertices have near
//! numbers. Each step along a list counts as work.

// Every index below comes from this module. A wrong one aborts, and verifies nothing.
#![allow(clippy::indexing_slicing)]

use crate::limits::Work;
use std::rc::Rc;

pub(crate) trait Name: Copy + Eq {
    /// The first vertex.
    fn vertex(&self) -> u32;
}

/// A list ends with the index 0. The entry 0 is a dummy.
pub(crate) struct Table<K, V> {
    /// The first entry of each vertex.
    heads: Vec<u32>,
    entries: Vec<Entry<K, V>>,
    /// The first free entry.
    free: u32,
    count: usize,
    peak: usize,
    work: Rc<Work>,
}

struct Entry<K, V> {
    named: Option<(K, V)>,
    next: u32,
}

fn index(number: u32) -> usize {
    usize::try_from(number).unwrap_or(usize::MAX)
}

impl<K: Name, V> Table<K, V> {
    pub(crate) fn new(work: &Rc<Work>) -> Self {
        Table {
            heads: Vec::new(),
            entries: vec![Entry {
                named: None,
                next: 0,
            }],
            free: 0,
            count: 0,
            peak: 0,
            work: work.clone(),
        }
    }

    pub(crate) fn len(&self) -> usize {
        self.count
    }

    /// The largest number of entries at one time.
    pub(crate) fn peak(&self) -> usize {
        self.peak
    }

    /// The first value that fulfils a condition.
    pub(crate) fn any(&self, condition: impl Fn(&&V) -> bool) -> Option<&V> {
        let values = self.entries.iter().filter_map(|entry| entry.named.as_ref());
        values.map(|(_, value)| value).find(condition)
    }

    /// The entry of a name, and the one before it in its list; 0 where there is none.
    #[inline(always)]
    fn find(&self, name: &K) -> (u32, u32) {
        let head = self.heads.get(index(name.vertex()));
        let (mut before, mut entry) = (0, head.copied().unwrap_or(0));
        let mut steps = 1;
        while entry != 0 && !self.has_name(entry, name) {
            before = entry;
            entry = self.entries[index(entry)].next;
            steps += 1;
        }
        self.work.add(2 * steps);
        (entry, before)
    }

    #[inline(always)]
    fn has_name(&self, entry: u32, name: &K) -> bool {
        matches!(&self.entries[index(entry)].named, Some((found, _)) if found == name)
    }

    /// Takes the value of a name out; where there is none, puts one in.
    #[inline(always)]
    pub(crate) fn toggle(&mut self, name: K, value: impl FnOnce() -> V) -> Option<V> {
        let (entry, before) = self.find(&name);
        if entry == 0 {
            self.insert(name, value());
            return None;
        }
        self.unlink(entry, before)
    }

    /// Applies `change` to the value of a name, which is made where there is none.
    #[inline(always)]
    pub(crate) fn update<W>(
        &mut self,
        name: K,
        new: impl FnOnce() -> V,
        change: impl FnOnce(&mut V) -> W,
    ) -> Option<W> {
        let (mut entry, _) = self.find(&name);
        if entry == 0 {
            entry = self.insert(name, new());
        }
        let named = self.entries[index(entry)].named.as_mut();
        named.map(|(_, value)| change(value))
    }

    /// Takes the value of a name out if it fulfils a condition.
    #[inline(always)]
    pub(crate) fn take_if(&mut self, name: &K, condition: impl FnOnce(&V) -> bool) -> Option<V> {
        let (entry, before) = self.find(name);
        let (_, value) = self.entries[index(entry)].named.as_ref()?;
        if condition(value) {
            self.unlink(entry, before)
        } else {
            None
        }
    }

    #[inline(always)]
    fn insert(&mut self, name: K, value: V) -> u32 {
        let vertex = index(name.vertex());
        if vertex >= self.heads.len() {
            self.heads.resize(vertex + 1, 0);
        }
        let new = Entry {
            named: Some((name, value)),
            next: self.heads[vertex],
        };
        let entry = if self.free == 0 {
            self.entries.push(new);
            u32::try_from(self.entries.len() - 1).unwrap_or(0)
        } else {
            let slot = self.free;
            self.free = self.entries[index(slot)].next;
            self.entries[index(slot)] = new;
            slot
        };
        self.heads[vertex] = entry;
        self.count += 1;
        self.peak = self.peak.max(self.count);
        entry
    }

    #[inline(always)]
    fn unlink(&mut self, entry: u32, before: u32) -> Option<V> {
        let free = self.free;
        let slot = &mut self.entries[index(entry)];
        let (name, value) = slot.named.take()?;
        let next = std::mem::replace(&mut slot.next, free);
        if before == 0 {
            self.heads[index(name.vertex())] = next;
        } else {
            self.entries[index(before)].next = next;
        }
        self.free = entry;
        self.count -= 1;
        Some(value)
    }
}
