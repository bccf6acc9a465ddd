//! The open facets and edges, found by name: for each vertex a list of those whose first vertex it is.
//!
//! The lists are short where each vertex has few open facets, and no input can make names collide. Neighbours are near
//! to each other in memory if neighbouring vertices have near numbers. Each step along a list counts as work.

use crate::limits::Work;
use crate::refusal::{Checked, Stop};
use std::rc::Rc;

pub(crate) struct Table<K, V> {
    /// The list of each vertex; 0 where it is empty.
    of_vertex: Vec<u32>,
    lists: Vec<Vec<(K, V)>>,
    /// Empty lists.
    free: Vec<u32>,
    pub(crate) count: usize,
    /// The largest count so far.
    pub(crate) peak: usize,
    work: Rc<Work>,
}

pub(crate) fn index(number: u32) -> usize {
    usize::try_from(number).unwrap_or(usize::MAX)
}

impl<K: PartialEq, V> Table<K, V> {
    pub(crate) fn new(work: &Rc<Work>) -> Self {
        let (work, lists) = (work.clone(), vec![Vec::new()]);
        Table { of_vertex: Vec::new(), lists, free: Vec::new(), count: 0, peak: 0, work }
    }

    /// Calls `change` with the list of a vertex and the position of a name in it.
    pub(crate) fn with<W>(
        &mut self,
        vertex: u32,
        name: &K,
        change: impl FnOnce(&mut Vec<(K, V)>, Option<usize>) -> W,
    ) -> Checked<W> {
        let vertex = index(vertex);
        if vertex >= self.of_vertex.len() {
            self.of_vertex.resize(vertex + 1, 0);
        }
        let number = self.of_vertex.get_mut(vertex).ok_or_else(|| Stop::LARGER)?;
        if *number == 0 {
            *number = match self.free.pop() {
                Some(free) => free,
                None => {
                    self.lists.push(Vec::new());
                    u32::try_from(self.lists.len() - 1).map_err(|_| Stop::LARGER)?
                }
            };
        }
        let list = self.lists.get_mut(index(*number)).ok_or_else(|| Stop::LARGER)?;
        let before = list.len();
        let position = list.iter().position(|(found, _)| found == name);
        let steps = position.unwrap_or(before);
        self.work.add(2 + 3 * u64::try_from(steps).unwrap_or(u64::from(u32::MAX)));
        let found = change(list, position);
        self.count = self.count + list.len() - before;
        self.peak = self.peak.max(self.count);
        if list.is_empty() {
            self.free.push(std::mem::take(number));
        }
        Ok(found)
    }

    /// The first value that fulfils a condition.
    pub(crate) fn find(&self, condition: impl Fn(&&V) -> bool) -> Option<&V> {
        self.lists.iter().flatten().map(|(_, value)| value).find(condition)
    }
}
