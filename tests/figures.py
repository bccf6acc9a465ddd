#!/usr/bin/env python3
"""Compares figures as PDF and PNG with the same figures as SVG, by other programs.

    tests/figures.py PROGRAM

Words: those of the SVG are in the PDF as often (pdftotext), and all fonts are embedded (pdffonts). Sizes and colours: the PNG and
the PDF, painted by pdftoppm with 300 dots per inch, are pictures of the same size that differ little. Needs poppler and Pillow.
"""
import re, subprocess, sys, tempfile
from collections import Counter
from html import unescape
from pathlib import Path

from PIL import Image, ImageChops

FIGURES = [("a15", "classes"), ("a15", "cell"), ("a15", "star"), ("slab", "steps"), ("square-14", "plane"), ("a15", "foam"),
           ("z", "coordination")]


def words(text):
    return Counter(re.findall(r"\S+", text))


def run(*command):
    return subprocess.run([str(part) for part in command], check=True, capture_output=True, text=True).stdout


def compare(program, folder, name, figure):
    base = folder / f"{name}-{figure}"
    for format in ("svg", "pdf", "png"):
        run(program, "draw", name, "--figure", figure, "-o", base.with_suffix("." + format))
    svg = base.with_suffix(".svg").read_text()
    expected = words(" ".join(unescape(text) for text in re.findall(r"<text[^>]*>(.*?)</text>", svg)))
    found = words(run("pdftotext", "-raw", base.with_suffix(".pdf"), "-"))
    assert found == expected, f"{base.name}: words {found - expected} and {expected - found}"
    fonts = run("pdffonts", base.with_suffix(".pdf")).splitlines()[2:]
    assert all(line.split()[-5] == "yes" for line in fonts), f"{base.name}: {fonts}"
    run("pdftoppm", "-r", "300", "-png", "-singlefile", base.with_suffix(".pdf"), f"{base}-pdf")
    png, painted = Image.open(base.with_suffix(".png")), Image.open(f"{base}-pdf.png").convert("RGB")
    assert png.mode == "RGB" and abs(png.info["dpi"][0] - 300) < 0.1, f"{base.name}: {png.mode}, {png.info}"
    assert all(abs(a - b) <= 1 for a, b in zip(png.size, painted.size)), f"{base.name}: {png.size}, {painted.size}"
    size = tuple(map(min, png.size, painted.size))
    apart = ImageChops.difference(png.crop((0, 0, *size)), painted.crop((0, 0, *size))).convert("L").histogram()
    share = sum(apart[64:]) / sum(apart)
    assert share < 0.04, f"{base.name}: {100 * share:.1f} % of the dots differ"
    inked = sum(png.convert("L").histogram()[:250])
    assert inked > 1000, f"{base.name}: nothing is painted"


def main():
    with tempfile.TemporaryDirectory() as folder:
        for name, figure in FIGURES:
            compare(Path(sys.argv[1]).resolve(), Path(folder), name, figure)
    print(f"{len(FIGURES)} figures agree")


if __name__ == "__main__":
    main()
