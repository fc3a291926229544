"""What an estimate takes of the object for want of anybody's word is said before the answer."""

from __future__ import annotations

import json

CURVE = "frequency_hz,spin_rate_deg_s\n14,100\n17,160\n20,260\n23,400\n25,470\n27,420\n"
LINEAR = ("estimate", "c.csv", "--method", "linear")


def test_what_nobody_told_of_the_object_is_warned_of(called, tmp_path):
    (tmp_path / "c.csv").write_text(CURVE)
    (tmp_path / "mass.toml").write_text('[sheet]\nmass = "11 g"\n')
    written = (*LINEAR, "--out", "o.toml")
    said = called(*written, cwd=tmp_path, check=0).stdout.splitlines()[0]
    assert said == ("warning: mass and radius were not told: the preset's 13.6 g and 40 mm are taken; "
                    "stiffness and E go with them: --mass, --radius")  # fmt: skip
    said = called(*written, "--radius", "40 mm", cwd=tmp_path, check=0).stdout.splitlines()[0]
    assert said.startswith("warning: the mass was not told: the preset's 13.6 g is taken;")
    for told in (("--mass", "13.6 g"), ("--with", "mass.toml")):
        said = called(*written, *told, cwd=tmp_path, check=0).stdout.splitlines()[0]
        assert said.startswith("warning: the radius was not told: the preset's 40 mm is taken;"), told
    # Nothing that this prints goes with the mass.
    assert json.loads(called(*LINEAR, "--json", cwd=tmp_path, check=0).stdout)["warnings"] == [
        "warning: the radius was not told: the preset's 40 mm is taken; stiffness and E go with it: --radius"
    ]
    for told in (("--scenario", "cheese"), ("--mass", "13.6 g", "--radius", "40 mm")):
        assert "not told" not in called(*written, *told, cwd=tmp_path, check=0).stdout, told


def test_a_film_tells_the_radius(called, tmp_path):
    heading, *rows = CURVE.split()
    (tmp_path / "c.csv").write_text("\n".join([f"{heading},radius_mm,radius_sd_mm", *(f"{row},40,1" for row in rows)]))
    assert "not told" not in called(*LINEAR, cwd=tmp_path, check=0).stdout


def test_many_objects_are_warned_of_alike(called, tmp_path):
    (tmp_path / "c.csv").write_text(CURVE)
    many = ("estimate-all", "c.csv", "--method", "linear")
    assert called(*many, cwd=tmp_path, check=0).stdout.startswith("warning: the radius was not told")
    assert json.loads(called(*many, "--radius", "40 mm", "--json", cwd=tmp_path, check=0).stdout)["warnings"] == []


def test_an_object_of_a_told_radius_is_said_to_be_treated_as_a_disk(called, tmp_path):
    rows = [f"{f},{520 / (1 + ((f - 25) / 5.2) ** 2):.5g}" for f in range(10, 31)]
    (tmp_path / "p.csv").write_text("\n".join(["frequency_hz,spin_rate_deg_s", *rows]))
    typed = ("estimate", "p.csv", "--method", "any-size", "--radius", "41 mm")
    done = called(*typed, "--json", cwd=tmp_path, check=0)
    assert json.loads(done.stdout)["notes"][0] == "treated as a disk of 41 mm; --outline for another shape"
