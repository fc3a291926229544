"""The identify and estimate commands, as a user types them."""

from __future__ import annotations

import json
import math
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

COMMAND = str(Path(sys.executable).with_name("plategait"))
CURVE = "\n".join(["frequency_hz,spin_rate_deg_s,failure", "13,52,", "14.5,66,", "16,88,", "17.5,160,", "20,350,",
                   "22,470,", "25,520,", "26.5,,slipped"])  # fmt: skip
UNITS = "time_s,phi1_N,phi2_deg,displacement_deg,force_N,angle_mm,position_mm,deflection_kg\n0,1,1,1,1,1,1,1\n"


def plategait(*arguments: str, cwd: Path, check: int | None = None) -> subprocess.CompletedProcess[str]:
    done = subprocess.run([COMMAND, *arguments], cwd=cwd, capture_output=True, text=True, timeout=120, check=False)
    assert "Traceback" not in done.stderr
    if check is not None:
        assert done.returncode == check, done.stderr + done.stdout
    return done


@pytest.mark.parametrize(
    ("kind", "field", "value", "within"),
    [
        # The examples are made from Table 4.1 with a bench's noise: what one of them gives back is a few percent off.
        ("bending", "sheet.bending_stiffness", 2.72e-3, 0.08),
        ("compression", "sheet.axial_stiffness", 0.79, 0.03),
        ("friction", "friction.static", 0.75, 0.005),
        ("modes", "sheet.bending_stiffness", 2.55e-3, 0.01),
    ],
)
def test_an_example_becomes_a_fragment_that_simulates(called, tmp_path, kind, field, value, within):
    called("identify", "example", kind, "r.csv", cwd=tmp_path, check=0)
    done = called("identify", kind, "r.csv", "--out", "f.toml", "--plot", "p.png", cwd=tmp_path, check=0)
    assert done.stderr == ""
    assert (tmp_path / "p.png").stat().st_size > 10_000
    data = tomllib.loads((tmp_path / "f.toml").read_text())
    section, _, name = field.partition(".")
    written = data[section][name]
    assert (float(str(written).split()[0])) == pytest.approx(value, rel=within)
    assert field in data["uncertainty"]["sd"]
    done = called("simulate", "cheese", "--with", "f.toml", "--draws", "4", "--duration", "0.2 s", "--json",
                     cwd=tmp_path, check=0)  # fmt: skip
    drawn = json.loads(done.stdout)["draws"]
    assert drawn["runs"] == 4
    assert drawn["low"] <= drawn["spin_rate_deg_s"] <= drawn["high"]


@pytest.mark.parametrize("kind", ["bending", "compression", "friction", "modes"])
@pytest.mark.parametrize("text", ["", "a,b\n1,2\n", UNITS], ids=["empty", "other columns", "other units"])
def test_what_is_no_recording_is_one_line(called, tmp_path, kind, text):
    (tmp_path / "r.csv").write_text(text)
    done = called("identify", kind, "r.csv", "--out", "f.toml", cwd=tmp_path, check=2)
    assert len(done.stderr.splitlines()) == 1
    assert not (tmp_path / "f.toml").exists()


def test_estimate_gives_numbers_a_fragment_and_a_picture(called, tmp_path):
    (tmp_path / "c.csv").write_text(CURVE)
    known = ("--noise", "5%", "--beta", "0.53", "--model-error", "0", "--fixed", "bending_damping", "--fixed",
             "plate_height", "--duration", "1 s")  # fmt: skip
    files = ("--out", "e.toml", "--plot", "e.png")
    done = called("estimate", "c.csv", *known, "--json", *files, cwd=tmp_path, check=0)
    numbers = json.loads(done.stdout)
    angle = numbers["parameters"]["friction_angle"]
    assert angle["verdict"] == "determined"
    assert angle["low"] < angle["median"] < angle["high"]
    assert (tmp_path / "e.png").stat().st_size > 10_000
    assert 0.3 < tomllib.loads((tmp_path / "e.toml").read_text())["friction"]["static"] < math.tan(math.radians(57))
    plategait("simulate", "cheese", "--with", "e.toml", "--duration", "0.2 s", cwd=tmp_path, check=0)


def test_a_spreadsheet_s_curve_gives_what_the_plain_one_gives(called, tmp_path):
    points = [(f, 300 / (1 + ((f - 21) / 3) ** 2)) for f in range(14, 29)]
    plain = ["frequency_hz,spin_rate_deg_s,failure", *(f"{f},{r:.6f}," for f, r in points), "30,,slipped"]
    (tmp_path / "plain.csv").write_text("\n".join(plain))
    excel = ["Hz;rpm;Failed?;note", *(f"{f};{r / 6:.8f};no;hm".replace(".", ",") for f, r in points), "30;;yes;"]
    (tmp_path / "excel.csv").write_bytes("\r\n".join(excel).encode("utf-16"))
    fits = [
        json.loads(called("fit", name, "--json", cwd=tmp_path, check=0).stdout) for name in ("plain.csv", "excel.csv")
    ]
    # Eight digits are written.
    assert fits[1]["f0_hz"] == pytest.approx(fits[0]["f0_hz"], rel=1e-6)
    assert fits[1]["peak_deg_s"] == pytest.approx(fits[0]["peak_deg_s"], rel=1e-6)
    assert [bool(fit["notes"]) for fit in fits] == [False, True]
    (tmp_path / "slip.csv").write_text("\n".join(plain).replace("\n16,", "\n160,"))
    # The source's method has no answer to such a curve.
    for command, status in ((["fit"], 0), (["estimate", "--method", "linear"], 1)):
        assert "is 16 Hz meant?" in called(*command, "slip.csv", cwd=tmp_path, check=status).stdout


def test_the_linear_method_and_its_refusal(called, tmp_path):
    lines = [f"{f},{520 / (1 + ((f - 25) / 5.2) ** 2):.2f}" for f in range(14, 29)]
    (tmp_path / "c.csv").write_text("\n".join(["frequency_hz,spin_rate_deg_s", *lines]))
    done = called("estimate", "c.csv", "--method", "linear", "--json", cwd=tmp_path, check=0)
    numbers = json.loads(done.stdout)["parameters"]
    # (5.6) and (5.7) at f0 = 25 Hz and b/f0 = 0.208, which the exact Lorentzian gives back to its printed digits.
    assert numbers["natural_frequency"]["median"] == pytest.approx(5.30 * 25 - 121.62, abs=0.05)
    assert numbers["friction_angle"]["median"] == pytest.approx(545.02 * 0.208 - 74.71, abs=0.3)
    narrow = [f"{f},{520 / (1 + ((f - 25) / 3.0) ** 2):.2f}" for f in range(14, 29)]
    (tmp_path / "n.csv").write_text("\n".join(["frequency_hz,spin_rate_deg_s", *narrow]))
    done = called("estimate", "n.csv", "--method", "linear", cwd=tmp_path, check=1)
    assert "24 to 57 deg" in done.stdout
    rising = [f"{f},{10 * f}" for f in range(14, 24)]
    (tmp_path / "r.csv").write_text("\n".join(["frequency_hz,spin_rate_deg_s", *rising]))
    done = called("estimate", "r.csv", "--method", "linear", cwd=tmp_path, check=2)
    assert "--method posterior" in done.stderr


@pytest.mark.parametrize(
    ("arguments", "named"),
    [
        (("c.csv", "--noise", "0"), "--noise"), (("c.csv", "--beta", "2"), "--beta"),
        (("c.csv", "--free", "colour"), "--free"), (("c.csv", "--angle", "3 deg", "--angle", "12 deg"), "--angle"),
        (("none.csv",), "none.csv"), (("one.csv",), "at least 3"), (("c.csv", "--method", "magic"), "--method"),
        (("c.csv", "--confidence", "2"), "confidence"), (("c.csv", "--out", "e.txt"), "--out"),
        (("inf.csv",), "line 3"), (("c.csv", "--with", "none.toml"), "none.toml"),
    ],
)  # fmt: skip
def test_bad_estimates_are_one_line(called, tmp_path, arguments, named):
    (tmp_path / "c.csv").write_text(CURVE)
    (tmp_path / "one.csv").write_text("frequency_hz,spin_rate_deg_s\n13,52\n")
    (tmp_path / "inf.csv").write_text("frequency_hz,spin_rate_deg_s\n13,52\n14,inf\n15,60\n")
    done = called("estimate", *arguments, cwd=tmp_path, check=2)
    assert named in done.stderr
    assert len(done.stderr.splitlines()) == 1
