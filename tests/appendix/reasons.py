"""The reason that an appendix gives for a sign: a comparison of squares, or an enclosure."""
import re
from fractions import Fraction as F

from exact import must
from formulas import interval, number

SQUARES = re.compile(r"(\d+)\^2=(\d+)([<>])(\d+)=(\d+)\\cdot(\d+)\^2")
BETWEEN = re.compile(r"(\d+)/(\d+)([<>])\\acutiledecimal\{([\d.]+)\}([<>])\\sqrt\{(\d+)\}")


def justified(k, text):
    """A cell `value`, `value\\quad(reason)` or `\\in[a, b]`, as the value or None, and the reason or None."""
    if text.startswith("\\in"):
        return None, text
    value, *reason = text.split("\\quad")
    return number(k, value), reason[0][1:-1] if reason else None


def check_justified(k, text, expected, what):
    """The value is as expected, and its sign is seen or the reason shows it."""
    value, reason = justified(k, text)
    must(value is None or value == expected, f"{what}: found {text}, expected {expected.c}")
    if reason is not None:
        check_reason(k, reason, expected)
    else:
        must(seen(k, expected), f"{what}: a sign without a reason: {text}")


def terms(k, value):
    """p and q of p + q √d."""
    c = value.c + [F(0)] * 2
    q = c[1] / k.radical.c[1]
    return c[0] - q * k.radical.c[0], q


def seen(k, value):
    if len(value.c) == 1:
        return True
    if k.radical is None:
        return False
    p, q = terms(k, value)
    return p * q >= 0


def check_reason(k, text, value):
    """p² and d q², or p/q with a decimal between it and √d, or an enclosure."""
    if text.startswith("\\in"):
        low, high = interval(k, text[3:])
        must(high - low < F(1, 10 ** 5) and low * high > 0, "an enclosure that decides nothing")
        must((value - low).sign() >= 0 >= (value - high).sign(), "an enclosure without the number")
        must((value - low - F(102, 10 ** 8)).sign() <= 0 <= (value - high + F(102, 10 ** 8)).sign(), "an enclosure that is wide")
        return
    p, q = terms(k, value)
    must(p * q < 0, "no reason is needed")
    match = SQUARES.fullmatch(text)
    if match:
        a, aa, relation, right, d, b = match.groups()
        a, aa, right, d, b = map(int, (a, aa, right, d, b))
        must(a * a == aa and d * b * b == right and d == k.radicand, f"wrong squares: {text}")
        must((aa < right) == (relation == "<"), f"wrong comparison: {text}")
        must(F(a, b) == abs(p / q), f"of another number: {text}")
    else:
        match = BETWEEN.fullmatch(text)
        must(match, f"no reason: {text}")
        a, b, relation, middle, again, d = match.groups()
        ratio, middle = F(int(a), int(b)), F(middle)
        must(int(d) == k.radicand and ratio == abs(p / q) and relation == again, f"of another number: {text}")
        above = ratio > middle and middle * middle > int(d)
        below = ratio < middle and middle * middle < int(d)
        must(above if relation == ">" else below, f"wrong comparison: {text}")
    sign = (1 if p > 0 else -1) if relation == ">" else (1 if q > 0 else -1)
    must(sign == value.sign(), "the sign that the reason gives")
