//! The conditions on a box: conditions on the signs of polynomials.
//!
//! A condition is a disjunction of alternatives, and an alternative is a conjunction of signs. Most
//! conditions have one alternative with one sign. Equal signs and equal conditions are kept once.

use acutile_exact::geometry::{RingElement, Sign};
use acutile_exact::polynomial::{Coefficient, Cuboid, Polynomial, bernstein};
use std::collections::{BTreeMap, BTreeSet};

/// A sign that a polynomial has to have at every point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Wanted {
    /// Greater than zero.
    Positive,
    /// At least zero.
    NonNegative,
    /// Zero.
    Zero,
}

impl Wanted {
    /// Whether a value with this sign is as wanted.
    pub fn allows(self, sign: Sign) -> bool {
        match self {
            Wanted::Positive => sign == Sign::Greater,
            Wanted::NonNegative => sign != Sign::Less,
            Wanted::Zero => sign == Sign::Equal,
        }
    }
}

/// A polynomial and its sign.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Atom<C = acutile_exact::number::Number> {
    /// A polynomial in the parameters.
    pub polynomial: Polynomial<C>,
    /// Its sign at every point.
    pub wanted: Wanted,
}

impl<C: Coefficient> Atom<C> {
    /// p > 0
    pub fn positive(polynomial: Polynomial<C>) -> Self {
        Atom::new(polynomial, Wanted::Positive)
    }

    /// p >= 0
    pub fn nonnegative(polynomial: Polynomial<C>) -> Self {
        Atom::new(polynomial, Wanted::NonNegative)
    }

    /// p = 0 identically.
    pub fn zero(polynomial: Polynomial<C>) -> Self {
        Atom::new(polynomial, Wanted::Zero)
    }

    /// p > 0, or p >= 0.
    pub fn strict_if(is_strict: bool, polynomial: Polynomial<C>) -> Self {
        if is_strict {
            Atom::positive(polynomial)
        } else {
            Atom::nonnegative(polynomial)
        }
    }

    fn new(polynomial: Polynomial<C>, wanted: Wanted) -> Self {
        Atom {
            polynomial: polynomial.reduced(),
            wanted,
        }
    }

    /// Whether the sign is proved on the whole box; `None` beyond a limit.
    pub fn is_proved_on(&self, cuboid: &Cuboid) -> Option<bool> {
        match self.wanted {
            Wanted::Positive => bernstein::is_positive(&self.polynomial, cuboid),
            Wanted::NonNegative => bernstein::is_nonnegative(&self.polynomial, cuboid),
            Wanted::Zero => Some(self.polynomial.is_zero()),
        }
    }

    /// Whether the sign is as wanted at each corner that belongs to the box; `None` beyond a limit.
    pub fn holds_at_corners(&self, cuboid: &Cuboid) -> Option<Vec<bool>> {
        let signs = bernstein::corner_signs(&self.polynomial, cuboid)?;
        let allowed = signs.into_iter().map(|sign| self.wanted.allows(sign));
        Some(allowed.collect())
    }

    /// The cost of a look at the box.
    pub fn cost(&self, cuboid: &Cuboid) -> u64 {
        match self.wanted {
            Wanted::Zero => 1,
            _ => bernstein::steps(&self.polynomial, cuboid.sides.len()).saturating_mul(C::COST),
        }
    }

    /// Whether the sign is as wanted at a point.
    pub fn holds_at(&self, point: &[acutile_exact::number::Number]) -> bool {
        let polynomial = self.polynomial.map(C::to_number);
        self.wanted.allows(polynomial.sign_at(point))
    }
}

/// A disjunction of conjunctions.
pub type Alternatives<C> = Vec<Vec<Atom<C>>>;

/// Both of two disjunctions; `None` for more than [`MOST_ALTERNATIVES`].
pub fn both<C: Clone>(a: &Alternatives<C>, b: &Alternatives<C>) -> Option<Alternatives<C>> {
    let pairs = a
        .iter()
        .flat_map(|a| b.iter().map(move |b| [a.clone(), b.clone()].concat()));
    (a.len() * b.len() <= MOST_ALTERNATIVES).then(|| pairs.collect())
}

/// The most alternatives of a condition that is made by [`both`].
pub const MOST_ALTERNATIVES: usize = 64;

/// Conditions, each a disjunction of conjunctions of numbered atoms.
#[derive(Clone, Debug)]
pub struct Conditions<C = acutile_exact::number::Number> {
    /// The atoms, without repetition.
    pub atoms: Vec<Atom<C>>,
    numbers: BTreeMap<Atom<C>, usize>,
    all: BTreeSet<Vec<Vec<usize>>>,
}

impl<C: Coefficient> Default for Conditions<C> {
    fn default() -> Self {
        Conditions {
            atoms: Vec::new(),
            numbers: BTreeMap::new(),
            all: BTreeSet::new(),
        }
    }
}

impl<C: Coefficient> Conditions<C> {
    /// Adds a sign that has to hold.
    pub fn add(&mut self, atom: Atom<C>) {
        self.add_alternatives(vec![vec![atom]]);
    }

    /// Adds a disjunction.
    pub fn add_alternatives(&mut self, alternatives: Alternatives<C>) {
        let mut condition: Vec<Vec<usize>> = Vec::with_capacity(alternatives.len());
        for atoms in alternatives {
            let mut numbers: Vec<usize> = atoms.into_iter().map(|atom| self.number(atom)).collect();
            numbers.sort_unstable();
            numbers.dedup();
            condition.push(numbers);
        }
        condition.sort_unstable();
        condition.dedup();
        self.all.insert(condition);
    }

    fn number(&mut self, atom: Atom<C>) -> usize {
        if let Some(number) = self.numbers.get(&atom) {
            return *number;
        }
        let number = self.atoms.len();
        self.numbers.insert(atom.clone(), number);
        self.atoms.push(atom);
        number
    }

    /// Each condition by the numbers of its atoms.
    pub fn all(&self) -> impl ExactSizeIterator<Item = &Vec<Vec<usize>>> {
        self.all.iter()
    }

    /// Whether a condition holds, if `atom` says which atoms do.
    pub fn holds(condition: &[Vec<usize>], mut atom: impl FnMut(usize) -> bool) -> bool {
        condition
            .iter()
            .any(|atoms| atoms.iter().all(|number| atom(*number)))
    }

    /// Whether all conditions hold, if `atom` says which atoms do.
    pub fn hold(&self, mut atom: impl FnMut(usize) -> bool) -> bool {
        self.all
            .iter()
            .all(|condition| Self::holds(condition, &mut atom))
    }

    /// A condition that holds nowhere.
    pub fn add_impossible(&mut self) {
        let zero = Polynomial::<C>::zero();
        self.add(Atom::zero(zero.integer(1)));
    }
}
