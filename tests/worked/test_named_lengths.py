"""Named lengths in worked solutions: why they are what they are, and only where they are used."""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.problem.template.library.library import load_template
from kinegrade.worked.case import write_row
from kinegrade.worked.formulas.symbols import name_quantity
from tests.problem.turning_crank import CRANK, faults
from tests.worked.chapters import read_chapter, solve_small
from tests.worked.draws import kept
from tests.worked.telling import lines

_REASON = ('[lengths]\nhalf = "r/2"\n', '[lengths]\nhalf = "r/2"\n\n[reasons]\n')


@pytest.mark.parametrize(
    ("name", "said"),
    [
        (
            "rolling-wheel-pin-slotted-rocker",
            "The tangents from $D$ to the wheel, the ground and $DB$, are equal, and $DO$ bisects",
        ),
        ("differential-epicyclic-train", "The pitch radii of gears of one module are as"),
    ],
)
def test_the_author_says_why_before_the_formula(name: str, said: str) -> None:
    told = list(lines(kept(name)))
    (place,) = [number for number, line in enumerate(told) if line.startswith(said)]
    assert told[place].endswith(":")
    assert told[place + 1].lstrip().startswith(("DB &=", r"r_{S} &="))


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("hoist-with-gears", []),  # the rope's length in the figure follows from nothing
        ("two-stage-belt-drive", []),
        ("belt-driven-bicycle", []),
        ("geneva-drive", ["r"]),
        ("differential-epicyclic-train", ["r_{S}", "r_{R}", "r_{P}"]),
    ],
)
def test_a_length_is_worked_out_where_it_is_used(name: str, told: list[str]) -> None:
    lefts = [line.partition("&=")[0].strip() for line in lines(kept(name)) if "&=" in line]
    named = [write_row(name_quantity(each).row) for each in load_template(name).scheme.lengths]
    assert named
    assert [each for each in named if each in lefts] == told


def test_a_reason_of_no_length_is_refused() -> None:
    old, new = _REASON
    assert faults((old, f'{new}hlaf = "as it is halved"\n')) == [
        'crank.toml:19: reasons.hlaf: no length "hlaf" - did you mean "half"? (known here: half)'
    ]


def test_a_reason_is_translated_beside(tmp_path: Path) -> None:
    old, new = _REASON
    text = CRANK.replace(old, f'{new}half = {{ en = "as it is halved", zh = "取半" }}\n')
    file = tmp_path / "crank.toml"
    file.write_text(text, encoding="utf-8")
    (tmp_path / "crank.de.toml").write_text('[reasons]\nhalf = "sie ist halbiert"\n', "utf-8")
    (reason,) = load_template(str(file)).words.reasons.values()
    assert [reason.in_language(one) for one in ("en", "zh", "de")] == [
        "as it is halved",
        "取半",
        "sie ist halbiert",
    ]


@pytest.mark.parametrize(
    ("name", "length"),
    [
        ("roller-rolling-on-rotating-bar", "OB"),
        ("rod-ground-incline-fixed-centrode", "OB"),
        ("tangent-cam-with-roller", "OC"),
    ],
)
def test_a_length_that_a_triangle_gives_is_told_with_its_reason(name: str, length: str) -> None:
    # these stood in coordinates, or as a distance, out of the air
    told = list(lines(kept(name), boxes=False))
    place = next(place for place, line in enumerate(told) if line.startswith(f"    {length} &= "))
    assert told[place - 1] == f"{load_template(name).words.reasons[length].in_language('en')}:"


def test_no_size_is_taken_of_what_is_positive() -> None:
    """The crank's length was |a| over the root of 2, and then worked out from coordinates."""
    page = "\n".join(lines(kept("geneva-drive")))
    assert r"r &= \frac{a}{\sqrt{2}}" in page
    assert r"$r \cdot \omega_{OP}" in page
    assert r"y_{B} &= a\sin\varphi" in "\n".join(lines(kept("watt-linkage")))


PARALLELOGRAM = """
joints = ["pin O: ground OB", "pin Q: ground QA", "pin A: QA AC", "pin B: OB BC", "pin C: AC BC"]
inputs = [{ motion = "QA turns", velocity = "2" }, { motion = "OB turns", velocity = "1" }]
[points]
O = "(0, 0)"
Q = "(9, 0)"
B = "(0, 3)"
A = "(9, 4)"
D = "polar(A, l, pi/3)"
C = "B + D - A"
[bodies]
OB = "O B"
QA = "Q A D"
BC = "B C"
AC = "A C"
"""


def test_the_side_of_a_parallelogram_is_as_long_as_the_one_across() -> None:
    solution = solve_small(PARALLELOGRAM, omega="omega(BC) in rad/s")
    page = read_chapter("# Velocities", solution)
    assert r"(l \cdot \omega" in page
    assert "BC = " not in page
