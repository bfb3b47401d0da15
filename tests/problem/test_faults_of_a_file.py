"""A template with a fault in every section, through the door: all are listed, each with its line."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner

from kinegrade.cli import main
from tests.problem.crank import crank_text
from tests.problem.turning_crank import changed, faults
from tests.small_class import kinegrade

CHANGES = (
    ('family = "crank"', 'familie = "crank"'),
    ("pin O: ground OA", "pin O ground OA"),
    ("OA turns", "OA spins"),
    ("r < 2", "r = 2"),
    ('{ en = "Crank", zh = "曲柄" }', "{}"),
    ('unit = "m",', 'unit = "fathom",'),
    ("0 .. 90 step 30", "0 .. 90 step 0"),
    ("draw = [2], means", "means"),
    ('half = "r/2"', 'half = "r/"'),
    ('A = "polar(O, r, phi)"', 'A = "polar(O, r phi)"'),
    ('OA = "O A M"', 'OA = "O B"'),
    ("magnitude(velocity(A))", "magnitude(velocity(A)"),
    ('"v = omega r"', '"v"\nyear = 1'),
)
FAULTS = [
    'crank.toml:2: familie: unknown table or key - did you mean "family"?',
    'crank.toml:4: joints[1]: "pin O ground OA": no such joint - did you mean "pin O: ground OA", "pin A: OA AB" or "open belt: circle(A, r1) of I, circle(B, r2) of II on ground"? (all of them: kinegrade words joints)',
    'crank.toml:5: inputs[1].motion: "OA spins": no such input - did you mean "OA turns", "A of W circles O" or "AB turns relative to OA"? (all of them: kinegrade words inputs)',
    'crank.toml:6: conditions[1]: "r = 2" - expected "left < right", with one of <, <=, >, >=, ==, !=',
    'crank.toml:7: title: a table of no language - expected a text, or texts by language like { en = "..." }',
    'crank.toml:11: parameters.r.unit: unit "fathom" - expected a product or quotient like m/s^2 of 1, cm, deg, ft, h, in, km, m, min, mm, r, rad, rpm, s',
    'crank.toml:12: parameters.phi.draw: "0 .. 90 step 0" - expected a step above zero, the last value not before the first, and at most 2000 values',
    'crank.toml:13: parameters.omega.draw: missing - expected a list, or a range like "0.1 .. 0.5 step 0.05"',
    'crank.toml:16: lengths.half: "r/", character 3: found the end, expected a number, a name or a bracket',
    'crank.toml:20: points.A: "polar(O, r phi)", character 12: found "phi", expected "," or ")"',
    'crank.toml:24: bodies.OA: no point "B" - known here: M, O',
    'crank.toml:27: asks.v_A.quantity: "magnitude(velocity(A)", character 22: found the end, expected "," or ")"',
    "crank.toml:31: published[1].year: unknown key - known here: given, gives, source",
]


@pytest.mark.parametrize("line_end", ["\n", "\r\n"])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig"])
def test_check_lists_a_dozen_faults_in_the_order_of_the_file(
    tmp_path: Path, line_end: str, encoding: str
) -> None:
    file = tmp_path / "crank.toml"
    file.write_text(changed(*CHANGES), encoding=encoding, newline=line_end)
    result = kinegrade("check", file)
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr.splitlines() == [f"error: {fault}" for fault in FAULTS]


def test_faults_are_said_in_the_language_of_the_terminal(tmp_path: Path) -> None:
    template = tmp_path / "crank.toml"
    template.write_text(
        crank_text(('unit = "m/s", sign = "+y"', 'unit = "m", sign = "+y"')), encoding="utf-8"
    )
    shown = CliRunner(env={"LC_ALL": "zh_CN.UTF-8"}).invoke(main, ["check", str(template)])
    assert shown.exit_code == 2
    assert '这是速度（m/s）：不能以 "m" 计 - 请写 unit = "m/s"，或改求别的量' in shown.stderr


@pytest.mark.parametrize("name", ["Kröpfung", "曲柄", "α"])
def test_names_in_other_letters_are_refused_with_the_letters_that_serve(name: str) -> None:
    plain = (
        "letters of A to Z and a to z, digits and _, a letter first; symbol and labels print others"
    )
    assert faults(('OA = "O A M"', f'{name} = "O A M"')) == [
        f'crank.toml:24: the name "{name}" has other letters than A to Z and a to z: write it in '
        "those - expected a template in TOML - fix it"
    ]
    found = faults(
        ('OA = "O A M"', f'"{name}" = "O A M"'),
        ("pin O: ground OA", f"pin O: ground {name}"),
        ("OA turns", f"{name} turns"),
    )
    assert found == [
        f'crank.toml:4: joints[1]: "pin O: ground {name}": the name "{name}" has other letters - '
        f"expected {plain}",
        f'crank.toml:5: inputs[1].motion: "{name} turns": the name "{name}" has other letters - '
        f"expected {plain}",
        f"crank.toml:24: bodies.{name}: not usable as a name - expected {plain}",
    ]


def test_a_greek_letter_in_an_expression_is_answered_with_its_name() -> None:
    assert faults(("polar(O, r, phi)", "polar(O, r, φ)")) == [
        'crank.toml:20: points.A: "polar(O, r, φ)", character 13: found "φ", expected "phi", the '
        "letter in A to Z"
    ]
