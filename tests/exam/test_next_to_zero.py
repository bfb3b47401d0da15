"""What is allowed next to zero is a share of the largest term that goes into an answer: where none
cancels, sense and size are marked however fast the mechanism runs.
"""

from __future__ import annotations

import json
import shutil
from fractions import Fraction
from pathlib import Path

import pytest

from tests.small_class import asks_of, key_lines, kinegrade, table

GEARS = """language = "en"
source = "worked out by hand"
family = "gears"
joints = [
  "pin A: ground one",
  "pin B: ground two",
  "circle(A, r) of one meshes with circle(B, 3*r) of two on ground",
]
inputs = [{ motion = "one turns", velocity = "omega", acceleration = "alpha" }]
title = "Two gears"
statement = '''
Gear 1, with the pitch radius {{ r }}, turns about $A$ {{ one.turning }}. It drives gear 2, which turns about $B$ and has three times its radius.
'''
[parameters]
r = { unit = "m", draw = "0.1 .. 0.4 step 0.01", means = "pitch radius of gear 1" }
omega = { unit = "rad/s", draw = "900 .. 1200 step 10", means = "angular velocity of gear 1" }
alpha = { unit = "rad/s^2", draw = "2 .. 8 step 0.5", means = "angular acceleration of gear 1" }
[points]
A = "(0, 0)"
B = "(4*r, 0)"
[bodies]
one = "A"
two = "B"
[asks]
alpha_2 = { quantity = "alpha(two)", unit = "rad/s^2", sign = "ccw", points = 1, means = "angular acceleration of gear 2" }
"""  # fmt: skip
BANK = """title = "Quiz"
course = "Mechanics"
[[questions]]
template = "gears.toml"
"""


@pytest.fixture(scope="module")
def fast(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Gears at 9,000 to 11,000 r/min: a millionth of the square is as large as the answer."""
    folder = tmp_path_factory.mktemp("fast")
    (folder / "gears.toml").write_text(GEARS, encoding="utf-8")
    (folder / "bank.toml").write_text(BANK, encoding="utf-8")
    (folder / "roster.csv").write_text("student,name\n1,Ann\n2,Bob\n", encoding="utf-8")
    files = folder / "bank.toml", folder / "roster.csv"
    result = kinegrade("generate", *files, "-o", folder / "EXAM", "--no-papers")
    assert result.exit_code == 0, result.stderr
    return folder


@pytest.mark.parametrize(
    ("factor", "verdict"),
    [
        ("1", "right"),
        ("1.0099", "right"),
        ("1.0101", "wrong"),
        ("-1", "mistake"),
        ("0", "wrong"),
        ("0.1", "mistake"),
    ],
)
def test_an_angular_acceleration_of_a_fast_gear_is_marked(
    fast: Path, tmp_path: Path, factor: str, verdict: str
) -> None:
    answers = tmp_path / "answers.csv"
    rows = "".join(
        f"{student},{float(Fraction(ask['decimal']) * Fraction(factor)):.12g}\n"
        for (student, _), ask in asks_of(fast / "EXAM").items()
    )
    answers.write_text(f"student,q1.alpha_2\n{rows}", encoding="utf-8")
    assert kinegrade("grade", fast / "EXAM", answers, "-o", tmp_path / "MARKS").exit_code < 2
    assert {row["verdict"] for row in table(tmp_path / "MARKS" / "marks.csv")} == {verdict}


@pytest.mark.parametrize(("part", "taken"), [(1, True), (0.5, False)])
def test_a_key_of_an_earlier_version_keeps_the_share_of_the_square(
    fast: Path, tmp_path: Path, part: float, taken: bool
) -> None:
    """They allow 1 % of omega squared, which is rounded to two figures."""
    exam = Path(shutil.copytree(fast / "EXAM", tmp_path / "EXAM"))
    first, *others = key_lines(exam)
    (question,) = first["questions"]
    square = float(question["drawn"]["omega"]) ** 2
    amount = part * float(f"{square:.2g}") / 100
    question["asks"]["alpha_2"]["tolerance"]["absolute"] = amount
    lines = "".join(json.dumps(line) + "\n" for line in (first, *others))
    (exam / "key.jsonl").write_text(lines, encoding="utf-8")
    result = kinegrade("paper", exam, first["student"])
    assert (result.exit_code == 0) is taken
    assert taken or "alpha_2: tolerance is" in result.stderr
