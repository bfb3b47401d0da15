"""What cannot be printed of a template is found by `check`, not when the papers are made."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner

from kinegrade.cli import main
from kinegrade.exam.printing.printable import find_printing_faults
from kinegrade.language import ENGLISH as ENGLISH_LANGUAGE
from kinegrade.language.catalogue import open_catalogue
from kinegrade.problem.template.library.library import find_template_names, load_template
from tests.problem.crank import crank, crank_text

ENGLISH = "above $O$."
UP = (("draw = [1, 2]", 'draw = "1 .. 2 step 0.1"'), ('[0, "1/2", 3]', '"0.1 .. 0.9 step 0.1"'))


@pytest.mark.parametrize("name", find_template_names())
def test_every_shipped_template_can_be_printed_in_every_language(name: str) -> None:
    assert find_printing_faults(load_template(name)) == []


@pytest.mark.parametrize(
    ("old", "new", "fault"),
    [
        (
            ENGLISH,
            r"above $\frac{1}{2$.",
            "statement.en: formula $\\frac{1}{2$: braces do not match",
        ),
        (
            ENGLISH,
            r"above $\nonsense O$.",
            "statement.en: formula $\\nonsense O$: unknown command",
        ),
        (ENGLISH, "above $O_$.", "statement.en: formula $O_$: _ with nothing after it"),
        (ENGLISH, "above <b>O</b>.", "statement.en: raw HTML (<b>) cannot be printed"),
        (ENGLISH, "above \U0001f600.", "statement.en: no font prints \U0001f600 (U+1F600)"),
        ('zh = "沿 x 轴"', 'zh = "沿 $x_$ 轴"', "asks.v_x.means.zh: formula $x_$: _ with nothing"),
        ('en = "along y"', 'en = "along `y`"', "asks.v_y.means.en: code (y) cannot be printed"),
        (
            'en = "A crank"',
            'en = "A crank {{ r }}"',
            "title.en: {{ r }}: nothing is filled in here",
        ),
    ],
)
def test_a_text_that_no_paper_can_hold_is_found_before_the_papers(
    old: str, new: str, fault: str
) -> None:
    written = map(open_catalogue(ENGLISH_LANGUAGE).write, find_printing_faults(crank((old, new))))
    [found] = [one for one in written if "</b>" not in one]
    assert found.startswith(fault)


def test_check_is_what_finds_it(tmp_path: Path) -> None:
    file = tmp_path / "crank.toml"
    file.write_text(crank_text(*UP, (ENGLISH, r"above $\frac{1}{2$.")), encoding="utf-8")
    result = CliRunner().invoke(main, ["check", str(file), "--sample", "5"])
    assert result.exit_code == 1
    assert "fault: statement.en: formula" in result.stdout


def test_a_value_inside_a_formula_does_not_garble_the_paper(tmp_path: Path) -> None:
    file = tmp_path / "crank.toml"
    cut = ("$A$ is {{ h.value }} above", "$h = {{ h.value }}$ above")
    file.write_text(crank_text(*UP, cut), encoding="utf-8")
    fault = "crank.toml: statement.en: {{ h }} stands inside a formula"
    checked = CliRunner().invoke(main, ["check", str(file), "--sample", "5"])
    assert checked.stdout.count(fault) == 1
    shown = CliRunner().invoke(main, ["show", str(file), "-o", str(tmp_path / "page.pdf")])
    assert (shown.exit_code, shown.stderr.count(fault)) == (2, 1)
