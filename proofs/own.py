#!/usr/bin/env python3
"""The bytes of a certificate as a definition for Coq, without the program that exported it.

usage: own.py CERTIFICATE > Own.v

Defines `own`, the CBOR of the certificate. A file in JSON is transcribed by verifiers/python/verify.py, which shares no
code with `acutile`. certificates.sh compares these bytes with those of the exported theorem.
"""
import importlib.util, pathlib, sys

sys.dont_write_bytecode = True
spec = importlib.util.spec_from_file_location("verify", pathlib.Path(__file__).parents[1] / "verifiers/python/verify.py")
encodings = importlib.util.module_from_spec(spec)
spec.loader.exec_module(encodings)


def cbor(data):
    """A certificate in CBOR is an array of five items; one in JSON begins with a brace."""
    return data if data[:1] == b"\x85" else encodings.cbor(encodings.read_json(data))


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    data = cbor(pathlib.Path(sys.argv[1]).read_bytes())
    lines = ["[" + ";".join(f"x{b:02x}" for b in data[i:i + 64]) + "]" for i in range(0, len(data), 64)]
    print("From Coq Require Import List.\nFrom Coq Require Import Init.Byte.\nImport ListNotations.")
    print("Definition own : list byte := concat [\n" + ";\n".join(lines) + "].")


main()
