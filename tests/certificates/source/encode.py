"""The two encodings of a certificate, from the rules of docs/format.md alone."""
import json
import re

NUMBERS = 1 << 53


def text(value, depth=1):
    """Canonical JSON. Members of the outer three levels stand on lines of their own."""
    if isinstance(value, int):
        return str(value) if abs(value) < NUMBERS else f'"{value}"'
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if value == []:
        return "[]"
    line = "\n" if depth <= 3 else ""
    if isinstance(value, dict):
        parts = [json.dumps(key) + ":" + text(item, depth + 1) for key, item in value.items()]
        brackets = "{}"
    else:
        parts = [text(item, depth + 1) for item in value]
        brackets = "[]"
    return brackets[0] + ",".join(line + part for part in parts) + line + brackets[1]


def to_json(value):
    return (text(value) + "\n").encode()


class Raw(bytes):
    """A CBOR item that is encoded already."""


def head(major, n):
    """The head of an item: its major type and an argument in the shortest form."""
    if n < 24:
        return bytes([major << 5 | n])
    for info, size in ((24, 1), (25, 2), (26, 4), (27, 8)):
        if n < 256 ** size:
            return bytes([major << 5 | info]) + n.to_bytes(size, "big")
    raise OverflowError


def integer(x):
    """Major type 0 or 1 for 64 bits, tag 2 or 3 with the shortest byte string beyond."""
    major, n = (0, x) if x >= 0 else (1, -1 - x)
    if n < 1 << 64:
        return head(major, n)
    digits = n.to_bytes((n.bit_length() + 7) // 8, "big")
    return head(6, 2 + major) + head(2, len(digits)) + digits


def to_cbor(x):
    """Deterministic CBOR. An object becomes the array of its values; a text of digits, the integer."""
    if isinstance(x, Raw):
        return bytes(x)
    if isinstance(x, dict):
        x = list(x.values())
    if isinstance(x, list):
        return head(4, len(x)) + b"".join(map(to_cbor, x))
    if isinstance(x, int) and not isinstance(x, bool):
        return integer(x)
    if isinstance(x, str):
        if re.fullmatch("-?[1-9][0-9]*", x):
            return integer(int(x))
        return head(3, len(x.encode())) + x.encode()
    raise ValueError(f"no item of a certificate: {x!r}")
