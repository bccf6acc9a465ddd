/-
@NAME@: an exact tiling, written by acutile @VERSION@ for Lean 4. It needs no library.
`lean FILE.lean` defines it and proves `tiling_checked`. Nothing is rounded.

Numbers are elements of Z[a] over common denominators, as lists of coefficients of 1, a, a^2, ...
Points have coordinates in a basis whose inner products are `gram` over `gramDenominator`.
A corner (v, [s1, ...]) is vertex v, counted from 0, moved by the integers s1, ... along the basis.
Each simplex stands for its translates by the first @RANK@ basis vectors. Domain: @DOMAIN@.
-/
namespace Acutile

abbrev Element := List Int

/-- The monic polynomial of a without its leading coefficient: a^n = -(c_0 + c_1 a + ...). -/
def polynomial : Element := @POLYNOMIAL@
/-- a lies between low / 2^bits and high / 2^bits, and no other root of the polynomial does. -/
def low : Int := @LOW@
def high : Int := @HIGH@
def bits : Nat := @BITS@

def gramDenominator : Int := @GRAMDENOMINATOR@
def gram : List (List Element) := @GRAM@
def denominator : Int := @DENOMINATOR@
def vertices : Array (List Element) := #@VERTICES@
def simplices : List (List (Nat × List Int)) := @SIMPLICES@
/-- The sum of the absolute determinants of all simplices times the @D@th power of the denominator. -/
def total : Element := @TOTAL@
/-- The congruence class of each simplex. -/
def kinds : List Nat := @KINDS@
/-- For each class the squared edges, times gramDenominator and the square of the denominator, and the numbers of
acute, right and obtuse dihedral angles. -/
def classes : Array (List Element × List Nat) := #@CLASSES@

def zero : Element := polynomial.map (fun _ => 0)
def ofInt (n : Int) : Element := n :: zero.drop 1
def add (x y : Element) : Element := List.zipWith (fun s t => s + t) x y
def scale (n : Int) (x : Element) : Element := x.map (fun t => n * t)
def sub (x y : Element) : Element := add x (scale (-1) y)
/-- a times x. -/
def shift (x : Element) : Element := sub ((0 : Int) :: x.dropLast) (scale (x.getLastD 0) polynomial)
def mul (x y : Element) : Element := x.foldr (fun c sum => add (shift sum) (scale c y)) zero
def sum (xs : List Element) : Element := xs.foldl add zero
def dot (x y : List Element) : Element := sum (List.zipWith mul x y)

/-- Bounds of c_0 + c_1 a + ..., times a power of 2^k, for a between l / 2^k and h / 2^k; and that power. -/
def enclose (c : List Int) (l h : Int) (k : Nat) : Int × Int × Int :=
  c.foldr (fun x (lower, upper, power) =>
    let a := lower * l; let b := lower * h; let d := upper * l; let e := upper * h
    let next := power * 2 ^ k
    (min (min a b) (min d e) + x * next, max (max a b) (max d e) + x * next, next)) (0, 0, 1)

/-- The sign of the polynomial at m / 2^k, as an integer with that sign. -/
def polynomialAt (m : Int) (k : Nat) : Int := (enclose (polynomial ++ [1]) m m k).1

/-- The sign of x: the interval of a is halved until it suffices. None if that does not end in `fuel` steps. -/
def signFrom (x : Element) : Nat → Int → Int → Nat → Option Int
  | 0, _, _, _ => none
  | fuel + 1, l, h, k =>
    let (lower, upper, _) := enclose x l h k
    if 0 < lower then some 1
    else if upper < 0 then some (-1)
    else
      let middle := l + h
      if polynomialAt middle (k + 1) * polynomialAt l k ≤ 0
      then signFrom x fuel (2 * l) middle (k + 1)
      else signFrom x fuel middle (2 * h) (k + 1)

def sign (x : Element) : Option Int :=
  if x.all (fun c => c == 0) then some 0 else signFrom x 1000 low high bits

def point (corner : Nat × List Int) : List Element :=
  List.zipWith add (vertices.getD corner.1 []) (corner.2.map (fun s => ofInt (s * denominator)))

def subtract (x y : List Element) : List Element := List.zipWith sub x y
def inner (x y : List Element) : Element := dot x (gram.map (fun row => dot row y))

def edges (simplex : List (Nat × List Int)) : List (List Element) :=
  match simplex.map point with
  | [] => []
  | first :: rest => rest.map (fun p => subtract p first)

/-- The determinant of a square matrix with n rows, by its first row. -/
def determinant : Nat → List (List Element) → Element
  | 0, _ => ofInt 1
  | _, [] => ofInt 1
  | n + 1, row :: rows =>
    let term := fun (k : Nat) (x : Element) =>
      let minor := rows.map (fun other => other.take k ++ other.drop (k + 1))
      scale (if k % 2 == 0 then 1 else -1) (mul x (determinant n minor))
    sum ((List.range row.length).map (fun k => term k (row.getD k zero)))

def squaredEdges (simplex : List (Nat × List Int)) : List Element :=
  let points := simplex.map point
  let pairs := (List.range points.length).map (fun i => (points.getD i [], points.drop (i + 1)))
  (pairs.map (fun (p, rest) => rest.map (fun q => inner (subtract q p) (subtract q p)))).foldr (fun x y => x ++ y) []

/-- Whether two lists have the same entries in another order. -/
def isPermutation : List Element → List Element → Bool
  | [], ys => ys.isEmpty
  | x :: xs, ys => ys.contains x && isPermutation xs (ys.erase x)

/-- The signs of the products of the facets' normals: negative for an acute angle. -/
def angleSigns (simplex : List (Nat × List Int)) : List (Option Int) :=
  let e := edges simplex
  let n := e.length
  let m := e.map (fun x => e.map (fun y => inner x y))
  let minor := fun (i j : Nat) =>
    (m.take i ++ m.drop (i + 1)).map (fun row => row.take j ++ row.drop (j + 1))
  let cofactor := fun (i j : Nat) =>
    scale (if (i + j) % 2 == 0 then 1 else -1) (determinant (n - 1) (minor i j))
  let indices := List.range n
  let border := indices.map (fun j => scale (-1) (sum (indices.map (fun i => cofactor i j))))
  let pairs := (indices.map (fun i => (List.range i).map (fun j => cofactor i j))).foldr (fun x y => x ++ y) []
  (border ++ pairs).map sign

def countSigns (signs : List (Option Int)) : List Nat :=
  [(-1 : Int), 0, 1].map (fun s => (signs.filter (fun t => t == some s)).length)

def determinants : List Element := simplices.map (fun simplex => determinant @D@ (edges simplex))

def absolute (x : Element) : Element := if sign x == some (-1) then scale (-1) x else x

def simplexIsAsListed (entry : (List (Nat × List Int)) × Nat) : Bool :=
  let (listed, signs) := classes.getD entry.2 ([], [])
  isPermutation (squaredEdges entry.1) listed && countSigns (angleSigns entry.1) == signs

def checked : Bool :=
  (List.range @D@).all (fun k =>
    sign (determinant (k + 1) ((gram.take (k + 1)).map (fun row => row.take (k + 1)))) == some 1)
  && !simplices.isEmpty
  && determinants.all (fun x => sign x == some 1 || sign x == some (-1))
  && sum (determinants.map absolute) == total
  && kinds.length == simplices.length
  && (simplices.zip kinds).all simplexIsAsListed

/-- The metric is positive, no simplex is flat, the volumes add up, and the simplices of each class have its
squared edges and signs of angles. The compiled program decides it. -/
theorem tiling_checked : checked = true := by native_decide

end Acutile
