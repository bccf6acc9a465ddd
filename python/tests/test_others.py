"""Verification, Delaunay triangulations, quality, classification, tables, reports."""

import pathlib

import numpy as np
import pytest

import acutile

CERTIFICATES = pathlib.Path(__file__).parents[2] / "certificates"


def test_a_changed_certificate_is_refused():
    certificate = bytearray(acutile.certify("a15").certificate)
    certificate[-1] ^= 1
    with pytest.raises(acutile.Failed):
        acutile.verify(bytes(certificate))


def test_a_wrong_certificate_in_json_is_named_by_line_and_column():
    text = (CERTIFICATES / "a15.json").read_text()
    wrong = text.replace('"dimension":3', '"dimension":4', 1)
    # The item 4 stands after the 12 characters of "dimension": in its line.
    line = wrong[: wrong.index('"dimension":4')].count("\n") + 1
    with pytest.raises(acutile.Failed, match=rf"\[dimension\] line {line}, column 13 "):
        acutile.verify(wrong.encode())


def test_a_claim_is_compared(tmp_path):
    path = tmp_path / "a15.cbor"
    path.write_bytes(acutile.certify("a15").certificate)
    claim = acutile.verify(path).claim
    assert acutile.verify(path, claim=claim).verdict == "verified"
    with pytest.raises(acutile.Failed, match="another claim"):
        acutile.verify(path, claim=claim.replace("acute", "nonobtuse"))


def test_delaunay_of_the_body_centred_lattice():
    triangulation = acutile.delaunay([[0, 0, 0], [1, 1, 1]], 2 * np.eye(3))
    assert triangulation.vertices.shape == (2, 3)
    assert triangulation.corners.shape == (12, 4) and triangulation.shifts.shape == (12, 4, 3)
    assert acutile.certify(triangulation, require=["delaunay"]).verdict == "proved"


def test_cospherical_points_need_a_cut():
    with pytest.raises(acutile.Failed, match="triangulate"):
        acutile.delaunay([[0, 0, 0]], np.eye(3))
    assert len(acutile.delaunay([[0, 0, 0]], np.eye(3), triangulate=True).corners) == 6


def test_angles_of_a_regular_tetrahedron():
    points = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]
    quality = acutile.quality(np.array(points), [[0, 1, 2, 3]])
    angle = np.degrees(np.arccos(1 / 3))
    assert quality.lower.shape == (1, 6)
    assert np.all(quality.lower <= angle + 1e-12) and np.all(quality.upper >= angle - 1e-12)
    assert np.all(quality.upper - quality.lower < 2e-6)
    # A right angle is exact.
    corner = acutile.quality([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 2, 3]])
    assert corner.largest[0] == 90.0


def test_the_structure_of_a15():
    found = acutile.classify("a15")
    assert found.tcp and found.vertex_types == {"Z12": 2, "Z14": 6}
    assert "a15" in found.isomorphic_to


def test_a_row_of_the_table():
    assert "a15" in acutile.table(["a15"], format="csv").lower()
    with pytest.raises(acutile.Failed, match="expected text, markdown"):
        acutile.table(["a15"], format="docx")


def test_a_page():
    page = acutile.report(acutile.certify("a15"), names=["A15"])
    assert page.lower().startswith("<!doctype html>") and "A15" in page


def test_first_mistakes_get_the_next_step():
    proved = acutile.certify("bcc", require="nonobtuse,delaunay")
    assert acutile.verify(proved).sha256 == proved.sha256
    assert "bcc" in acutile.table("bcc", format="csv").lower()
    for call, words in [
        (lambda: acutile.certify("a51"), "did you mean a15"),
        (lambda: acutile.table("foo"), r"names\(\) lists them"),
        (lambda: acutile.report("a15"), "found str, expected results of certify"),
        (lambda: acutile.verify(b"hello"), "found no certificate"),
    ]:
        with pytest.raises(acutile.Failed, match=words):
            call()


def test_the_catalogue():
    assert "a15" in acutile.names()
