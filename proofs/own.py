#!/usr/bin/env python3
"""The bytes of certificates as definitions for Coq, without the program that exported them.

usage: own.py CERTIFICATE OWN.v [CERTIFICATE OWN.v]...

Each file OWN.v defines `own`, the CBOR of the certificate before it. A file in JSON is transcribed by verifiers/python/verify.py, which shares no
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


def definition(data):
    lines = ["[" + ";".join(f"x{b:02x}" for b in data[i:i + 64]) + "]" for i in range(0, len(data), 64)]
    return ("From Coq Require Import List.\nFrom Coq Require Import Init.Byte.\nImport ListNotations.\n"
            "Definition own : list byte := concat [\n" + ";\n".join(lines) + "].\n")


def main():
    files = [pathlib.Path(argument) for argument in sys.argv[1:]]
    if not files or len(files) % 2:
        sys.exit(__doc__)
    for certificate, own in zip(files[::2], files[1::2]):
        own.write_text(definition(cbor(certificate.read_bytes())))


main()
