//! Determinants, cofactors and quadratic forms of small matrices over any
//! ring; nothing is divided.

use super::RingElement;

/// The determinant of a D x D matrix, by expansion along the first row.
#[inline]
pub fn determinant<S: RingElement, const D: usize>(matrix: &[[S; D]; D]) -> S {
    if D == 3 {
        let row: [S; D] = std::array::from_fn(|j| cofactor(matrix, 0, j));
        return dot(&matrix[0], &row);
    }
    let rows: Vec<&[S]> = matrix.iter().map(|row| row.as_slice()).collect();
    let columns: Vec<usize> = (0..D).collect();
    minor(&rows, &columns)
}

/// A matrix to be filled. Loops over it are unrolled where closures that make the
/// entries would be called.
#[inline(always)]
pub fn zeros<S: RingElement, const N: usize, const D: usize>(like: &S) -> [[S; D]; N] {
    let zero = like.integer(0);
    std::array::from_fn(|_| std::array::from_fn(|_| zero.clone()))
}

/// The matrix of cofactors C, C_ij = (-1)^(i+j) times the minor without row i and
/// column j. Its transpose is the adjugate: M C^T = det M.
#[inline(always)]
pub fn cofactors<S: RingElement, const D: usize>(matrix: &[[S; D]; D]) -> [[S; D]; D] {
    let mut cofactors = zeros(&matrix[0][0]);
    for i in 0..D {
        for j in 0..D {
            cofactors[i][j] = cofactor(matrix, i, j);
        }
    }
    cofactors
}

#[inline(always)]
fn cofactor<S: RingElement, const D: usize>(matrix: &[[S; D]; D], i: usize, j: usize) -> S {
    // Cyclic order of the other rows and columns makes the sign come out right in
    // dimension 3 without a negation.
    if D == 3 {
        let [a, b, c, d] = [(i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3];
        return determinant2(&matrix[a][c], &matrix[a][d], &matrix[b][c], &matrix[b][d]);
    }
    if D == 2 {
        let other = matrix[1 - i][1 - j].clone();
        return if i == j {
            other
        } else {
            other.integer(0).minus(&other)
        };
    }
    let rows: Vec<&[S]> = (0..D)
        .filter(|&k| k != i)
        .map(|k| matrix[k].as_slice())
        .collect();
    let columns: Vec<usize> = (0..D).filter(|&k| k != j).collect();
    if rows.is_empty() {
        return matrix[0][0].integer(1);
    }
    let value = minor(&rows, &columns);
    if (i + j).is_multiple_of(2) {
        value
    } else {
        value.integer(0).minus(&value)
    }
}

/// a d - b c
#[inline(always)]
fn determinant2<S: RingElement>(a: &S, b: &S, c: &S, d: &S) -> S {
    a.times(d).minus(&b.times(c))
}

/// The determinant of the rows restricted to some columns, as many as rows.
fn minor<S: RingElement>(rows: &[&[S]], columns: &[usize]) -> S {
    match columns {
        [j] => rows[0][*j].clone(),
        [j, k] => determinant2(&rows[0][*j], &rows[0][*k], &rows[1][*j], &rows[1][*k]),
        _ => expand(rows, columns),
    }
}

fn expand<S: RingElement>(rows: &[&[S]], columns: &[usize]) -> S {
    let mut sum = rows[0][columns[0]].integer(0);
    for (position, &column) in columns.iter().enumerate() {
        let others: Vec<usize> = columns.iter().copied().filter(|&c| c != column).collect();
        let term = rows[0][column].times(&minor(&rows[1..], &others));
        sum = if position % 2 == 0 {
            sum.plus(&term)
        } else {
            sum.minus(&term)
        };
    }
    sum
}

/// The sum of x_k y_k.
#[inline(always)]
pub fn dot<S: RingElement, const D: usize>(x: &[S; D], y: &[S; D]) -> S {
    let mut sum = x[0].times(&y[0]);
    for k in 1..D {
        sum = sum.plus(&x[k].times(&y[k]));
    }
    sum
}

/// x × y
#[inline(always)]
pub fn cross<S: RingElement>(x: &[S; 3], y: &[S; 3]) -> [S; 3] {
    std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        determinant2(&x[i], &x[j], &y[i], &y[j])
    })
}

/// The sum of x_k.
#[inline(always)]
pub fn sum<S: RingElement, const D: usize>(x: &[S; D]) -> S {
    let mut sum = x[0].clone();
    for k in 1..D {
        sum = sum.plus(&x[k]);
    }
    sum
}

/// M x
#[inline(always)]
pub fn apply<S: RingElement, const D: usize>(matrix: &[[S; D]; D], x: &[S; D]) -> [S; D] {
    let [mut image] = zeros(&x[0]);
    for i in 0..D {
        image[i] = dot(&matrix[i], x);
    }
    image
}

/// x^T M x: the squared length of a vector, for a Gram matrix M.
#[inline(always)]
pub fn square<S: RingElement, const D: usize>(gram: &[[S; D]; D], x: &[S; D]) -> S {
    dot(x, &apply(gram, x))
}

/// x - y
#[inline(always)]
pub fn subtract<S: RingElement, const D: usize>(x: &[S; D], y: &[S; D]) -> [S; D] {
    let [mut difference] = zeros(&x[0]);
    for k in 0..D {
        difference[k] = x[k].minus(&y[k]);
    }
    difference
}
