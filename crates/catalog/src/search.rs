//! Backtracking for blank edges: which yes/no values of the edges satisfy the conditions
//! at tiles and vertices.

/// The conditions. Edges are numbered; an edge may occur twice in one condition.
#[derive(Default)]
pub struct Constraints {
    edges: usize,
    conditions: Vec<Condition>,
}

enum Condition {
    /// One side of a triangle.
    Triangle(Vec<usize>),
    /// Sides 0 and 2 of a square and not 1 and 3, or the other way round.
    Square(Vec<usize>),
    /// Two edges of a vertex, both of which change the colour, or none.
    Vertex(Vec<(usize, bool)>),
}

/// The outcome of a search.
pub enum Found {
    /// The values satisfy everything.
    Some,
    /// Nothing does.
    None,
    /// There were more steps than [`STEP_LIMIT`].
    Unknown,
}

/// No search looks at more partial choices.
pub const STEP_LIMIT: usize = 200_000;

impl Constraints {
    /// Adds a vertex: its edges, and whether the tiles on their sides are of one kind.
    pub fn vertex(&mut self, spokes: Vec<(usize, bool)>) {
        self.count(spokes.iter().map(|spoke| spoke.0));
        self.conditions.push(Condition::Vertex(spokes));
    }

    /// Adds a tile: its three or four sides in cyclic order.
    pub fn tile(&mut self, sides: Vec<usize>) {
        self.count(sides.iter().copied());
        self.conditions.push(match sides.len() {
            3 => Condition::Triangle(sides),
            _ => Condition::Square(sides),
        });
    }

    fn count(&mut self, edges: impl Iterator<Item = usize>) {
        self.edges = edges.fold(self.edges, |count, edge| count.max(edge + 1));
    }

    /// Searches all values, edges in order of their numbers.
    pub fn solve(&self) -> (Found, Vec<bool>) {
        let at = self.conditions_of_edges();
        let mut values: Vec<Option<bool>> = vec![None; self.edges];
        let mut depth = 0;
        for _ in 0..STEP_LIMIT {
            let Some(slot) = values.get_mut(depth) else {
                return (Found::Some, values.into_iter().flatten().collect());
            };
            // Blank first, then not, then back.
            *slot = match *slot {
                None => Some(true),
                Some(true) => Some(false),
                Some(false) => None,
            };
            if slot.is_none() {
                if depth == 0 {
                    return (Found::None, Vec::new());
                }
                depth -= 1;
            } else if at[depth]
                .iter()
                .all(|&c| self.conditions[c].is_possible(&values))
            {
                depth += 1;
            }
        }
        (Found::Unknown, Vec::new())
    }

    /// For each edge the conditions in which it occurs.
    fn conditions_of_edges(&self) -> Vec<Vec<usize>> {
        let mut at = vec![Vec::new(); self.edges];
        for (number, condition) in self.conditions.iter().enumerate() {
            for edge in condition.edges() {
                at[edge].push(number);
            }
        }
        at
    }
}

impl Condition {
    fn edges(&self) -> Vec<usize> {
        match self {
            Condition::Triangle(sides) | Condition::Square(sides) => sides.clone(),
            Condition::Vertex(spokes) => spokes.iter().map(|spoke| spoke.0).collect(),
        }
    }

    /// Whether the values that are known leave it possible; exact where all are known.
    fn is_possible(&self, values: &[Option<bool>]) -> bool {
        match self {
            Condition::Triangle(sides) => is_count_possible(sides.iter().map(|&e| values[e]), 1),
            Condition::Square(sides) => [true, false].into_iter().any(|first| {
                (0..4)
                    .all(|i| values[sides[i]].is_none_or(|blank| blank == (first == (i % 2 == 0))))
            }),
            Condition::Vertex(spokes) => [true, false].into_iter().any(|kind| {
                let allowed = spokes.iter().map(|&(edge, flips)| {
                    if flips == kind {
                        values[edge]
                    } else {
                        values[edge].or(Some(false))
                    }
                });
                is_count_possible(allowed.clone(), 2)
                    && spokes
                        .iter()
                        .all(|&(edge, flips)| flips == kind || values[edge] != Some(true))
            }),
        }
    }
}

/// Whether exactly `count` of the values can be true.
fn is_count_possible(values: impl Iterator<Item = Option<bool>> + Clone, count: usize) -> bool {
    let blank = values.clone().filter(|value| *value == Some(true)).count();
    let open = values.filter(Option::is_none).count();
    blank <= count && count <= blank + open
}
