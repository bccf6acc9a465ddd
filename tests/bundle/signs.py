"""Signs of polynomials on boxes, as verifiers/python/verify.py decides them, against Sturm sequences and many points."""

import random
from fractions import Fraction
from itertools import product

# Polynomials in one variable: coefficients from the constant term up.


def trimmed(p):
    while p and p[-1] == 0:
        p = p[:-1]
    return p


def value(p, x):
    return sum((c * x ** k for k, c in enumerate(p)), Fraction(0))


def remainder(p, q):
    p = list(p)
    while len(p) >= len(q):
        factor = Fraction(p[-1]) / q[-1]
        for k, c in enumerate(q):
            p[len(p) - len(q) + k] -= factor * c
        p = trimmed(p[:-1])
    return p


def quotient(p, q):
    p, result = list(p), [Fraction(0)] * (len(p) - len(q) + 1)
    for k in reversed(range(len(result))):
        result[k] = Fraction(p[k + len(q) - 1]) / q[-1]
        for i, c in enumerate(q):
            p[k + i] -= result[k] * c
    return result


def sequence(p):
    chain = [p, trimmed([k * c for k, c in enumerate(p)][1:])]
    while chain[-1]:
        chain.append([-c for c in remainder(chain[-2], chain[-1])])
    return chain[:-1]


def sturm(p):
    """Of the polynomial with the same roots, each of them once: so an end of an interval may be one of them."""
    return sequence(quotient(p, sequence(p)[-1]))


def roots_between(chain, low, high):
    """The number of different roots in the interval without its low end, with its high one."""
    def variations(x):
        signs = [v > 0 for v in (value(q, x) for q in chain) if v != 0]
        return sum(a != b for a, b in zip(signs, signs[1:]))
    return variations(low) - variations(high)


def samples_between_roots(p, low, high):
    """Points inside, at least one between any two roots that are next to each other, and beside the first and last one."""
    chain = sturm(p)
    points, parts = [], [(low, high)]
    while parts:
        a, b = parts.pop()
        middle = (a + b) / 2
        if value(p, middle) == 0:
            middle = next(m for m in ((a * k + b * (k + 1)) / (2 * k + 1) for k in range(2, 99)) if value(p, m) != 0)
        points.append(middle)
        inside = roots_between(chain, a, b) - (value(p, b) == 0)
        left, right = roots_between(chain, a, middle), roots_between(chain, middle, b) - (value(p, b) == 0)
        assert inside == left + right
        if inside and (left > 1 or right > 1 or left + right == 1):
            parts += [part for part, count in (((a, middle), left), ((middle, b), right)) if count and part[1] - part[0] > Fraction(1, 10 ** 6)]
    return points


def truth(p, low, high, closed):
    """Whether p is positive on the interval with these ends, and whether it is at least zero."""
    p = trimmed(p)
    if not p:
        return False, True
    ends = [value(p, end) for end, is_closed in zip((low, high), closed) if is_closed]
    is_nonnegative = all(value(p, x) > 0 for x in samples_between_roots(p, low, high))
    inside = roots_between(sturm(p), low, high) - (value(p, high) == 0)
    return is_nonnegative and inside == 0 and all(end > 0 for end in ends), is_nonnegative


def leaf_tree(chance, depth, axes):
    """A node of the verifier's tree: the number of leaves, the axis, both halves."""
    if depth == 0 or chance.random() < 0.2:
        return []
    halves = [leaf_tree(chance, depth - 1, axes) for _ in range(2)]
    return [sum(half[0] if half else 1 for half in halves), chance.randrange(axes), *halves]


def full_tree(depth):
    return [] if depth == 0 else [2 ** depth, 0, full_tree(depth - 1), full_tree(depth - 1)]


def interval(chance):
    low = Fraction(chance.randint(-6, 6), chance.choice([1, 1, 2, 3]))
    return low, low + Fraction(chance.randint(1, 6), chance.choice([1, 2, 3])), (chance.random() < 0.5, chance.random() < 0.5)


def box(verify, intervals, tree):
    sides = []
    for low, high, closed in intervals:
        scale = low.denominator * high.denominator
        sides.append(verify.Interval(int(low * scale), int((high - low) * scale), scale, closed))
    return verify.Box([f"x{k}" for k in range(len(sides))], sides, tree)


def near_the_border(chance, low, high):
    """A product of factors that are zero at rational points, often at the ends or at halves; sometimes changed by little."""
    p = [chance.choice([1, 1, 1, -1, 5])]
    for _ in range(chance.randint(1, 4)):
        root = chance.choice([low, high, (low + high) / 2, (3 * low + high) / 4, (2 * low + high) / 3, low - 1, high + Fraction(1, 5)])
        factor = chance.choice([[-root, 1], [root, -1], [root * root, -2 * root, 1], [root * root + Fraction(1, 7), -2 * root, 1]])
        p = [sum(p[i] * factor[k - i] for i in range(len(p)) if 0 <= k - i < len(factor)) for k in range(len(p) + len(factor) - 1)]
    if chance.random() < 0.3:
        p[0] += Fraction(chance.choice([-1, 1]), chance.choice([50, 10 ** 9]))
    return p


def check_one_parameter(verify, rounds, chance):
    """What is shown is true; and what is true and not zero nearby is shown by a fine tree."""
    tally = [0, 0, 0]
    for _ in range(rounds):
        low, high, closed = interval(chance)
        p = near_the_border(chance, low, high)
        scale = Fraction(1)
        for c in p:
            scale *= (Fraction(c) * scale).denominator
        for tree in (leaf_tree(chance, 3, 1), full_tree(6)):
            at = box(verify, [(low, high, closed)], tree)
            polynomial = verify.Polynomial(at, {(k,): int(c * scale) for k, c in enumerate(p)})
            shown = verify.positive_in(polynomial) == at.all, verify.nonnegative_in(polynomial) == at.all
            true = truth(p, low, high, closed)
            assert not shown[0] or true[0], (p, low, high, closed, tree)
            assert not shown[1] or true[1], (p, low, high, closed, tree)
            assert not shown[0] or shown[1], (p, low, high, closed, tree)
            tally[0] += shown[0]
            tally[1] += true[0] and not shown[0]
            tally[2] += not true[0]
        # The leaf's coefficients are the values at its ends; from these the fine tree decides what is well away from zero.
        least = min(value(p, low + (high - low) * Fraction(k, 64)) for k in range(65))
        slope = sum(k * abs(c) * max(abs(low), abs(high), 1) ** k for k, c in enumerate(p)) * (high - low) * len(p)
        assert shown[0] or least * 64 <= slope, (p, low, high)
    assert min(tally) > rounds // 50, tally
    return tally


def check_points(verify, rounds, chance):
    """In two and three parameters: nothing that is shown is false in a point, faces of the box where the polynomial vanishes included."""
    shown_count = 0
    for _ in range(rounds):
        count = chance.choice([2, 2, 3])
        intervals = [interval(chance) for _ in range(count)]
        at = box(verify, intervals, leaf_tree(chance, 2, count))
        units = [verify.Polynomial(at, {tuple(int(i == k) for i in range(count)): 1}) for k in range(count)]
        polynomial = verify.Polynomial(at, {(0,) * count: 1})
        for _ in range(chance.randint(1, 3)):
            k = chance.randrange(count)
            low, high, _ = intervals[k]
            end = chance.choice([low, low, high, low - 1])
            linear = (units[k] * end.denominator - end.numerator) * chance.choice([1, 1, -1])
            other = units[(k + 1) % count] * units[(k + 1) % count] + chance.choice([0, 0, 1, 2])
            polynomial = chance.choice([polynomial * linear, polynomial * linear + other, polynomial * other, polynomial * linear * linear + linear])
        sides = [[low + (high - low) * t for t in (0, Fraction(1, 99), Fraction(1, 3), Fraction(1, 2), Fraction(98, 99), 1)
                  if (t > 0 or ends[0]) and (t < 1 or ends[1])] for low, high, ends in intervals]
        values = [sum(c * x for c, x in ((c, power(at_point, e)) for e, c in polynomial.terms.items())) for at_point in product(*sides)]
        is_positive = verify.positive_in(polynomial) == at.all
        assert not is_positive or min(values) > 0, (polynomial.terms, intervals)
        assert verify.nonnegative_in(polynomial) != at.all or min(values) >= 0, (polynomial.terms, intervals)
        shown_count += is_positive
    assert rounds // 20 < shown_count < rounds, shown_count
    return shown_count


def power(point, exponents):
    result = Fraction(1)
    for x, e in zip(point, exponents):
        result *= x ** e
    return result


def check_signs_on_boxes(verify, rounds=300, seed=5):
    chance = random.Random(seed)
    return check_one_parameter(verify, rounds, chance), check_points(verify, rounds, chance)
