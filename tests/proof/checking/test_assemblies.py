"""The other way in which a mechanism closes is found, said and drawn."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest
from click.testing import CliRunner

from kinegrade.cli import main
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.library.starter import write_starter_text
from kinegrade.proof.assemblies import close_otherwise, find_other_assemblies
from kinegrade.proof.checking import check
from kinegrade.proof.reporting import write_findings
from tests.proof.checking.changed import SLIDER
from tests.said import all_said


def test_the_other_way_in_which_a_mechanism_closes_is_said() -> None:
    found = all_said(write_findings(check(load_template("slider-crank"), sample=40)))
    assert (
        'B is "right"; with "left" it closes as well in 100% of the draws: -o FILE shows both'
    ) in found


@pytest.mark.parametrize(
    ("taken", "other"),
    [
        ("right", "left"),
        ("left of A->O", "right of A->O"),
        ("right of A->O", "left of A->O"),
    ],
)
def test_the_other_assembly_takes_the_other_common_point(taken: str, other: str) -> None:
    template = read_template("slider-crank", SLIDER.replace(", right)", f", {taken})"))
    (assembly,) = find_other_assemblies(template)
    assert (assembly.point, assembly.taken, assembly.other) == ("B", taken, other)
    solution = solve_template(template, {"phi": "30", "r": "1/5", "k": "2"})
    closed = close_otherwise(solution, assembly)
    assert closed is not None
    here, there = (each.doubles.points["B"].x for each in (solution, closed))
    middle = solution.doubles.points["A"].x
    assert here - middle == pytest.approx(middle - there)
    assert here != there


def test_what_does_not_close_is_no_other_assembly() -> None:
    right_alone = ', right)"\nQ = "(sqrt(r*x(B)), 0)"'
    template = read_template("slider-crank", SLIDER.replace(', right)"', right_alone))
    (assembly,) = find_other_assemblies(template)
    solution = solve_template(template, {"phi": "30", "r": "1/5", "k": "2"})
    assert close_otherwise(solution, assembly) is None


def test_check_draws_both_assemblies(tmp_path: Path) -> None:
    sheet = tmp_path / "both.pdf"
    arguments = ["check", "slider-crank", "--sample", "8", "-o", str(sheet), "--lang", "en"]
    assert CliRunner().invoke(main, arguments).exit_code == 0
    printed = subprocess.run(["pdftotext", sheet, "-"], capture_output=True, text=True, check=True)
    assert "left" in printed.stdout


def test_check_draws_a_file_that_is_in_one_language(tmp_path: Path) -> None:
    text = re.sub(
        r', zh = "[^"]*"|\n?zh = (?:"[^"]*"|\'\'\'[\s\S]*?\'\'\')', "", write_starter_text()
    )
    path, sheet = tmp_path / "german.toml", tmp_path / "both.pdf"
    path.write_text(re.sub(r"\ben = ", "de = ", text), encoding="utf-8")
    arguments = ["check", str(path), "--sample", "4", "-o", str(sheet)]
    done = CliRunner().invoke(main, arguments, env={"LC_ALL": "en_GB.UTF-8"})
    assert "no text in" not in done.output
    assert sheet.exists()
