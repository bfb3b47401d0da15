"""A template or an exam folder from a stranger is data: whatever stands in it, a command says one line and ends."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.problem.crank import crank_text
from tests.small_class import generate, kinegrade, write_class

PROGRAMS = [
    "{{ 7*7 }}",
    "{% for i in range(9999) %}{% for j in range(9999) %}{% endfor %}{% endfor %}",
    "{{ 'x'*3000000000 }}",
    "{{ r.__class__.__mro__ }}",
]


@pytest.fixture(scope="module")
def exam(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = write_class(tmp_path_factory.mktemp("class"))
    assert generate(folder).exit_code == 0
    return folder / "EXAM"


@pytest.mark.parametrize("program", PROGRAMS)
@pytest.mark.parametrize("command", ["solve", "show", "gallery"])
def test_a_program_in_a_statement_is_never_run(program: str, command: str, tmp_path: Path) -> None:
    template = tmp_path / "crank.toml"
    template.write_text(crank_text(("The crank", f"The crank {program}")), encoding="utf-8")
    result = kinegrade(command, template, "-o", tmp_path / "page.pdf")
    assert (result.exit_code, result.stdout) == (2, "")
    assert not (tmp_path / "page.pdf").exists()
    assert result.stderr.count("only {{ name }} and {{ name.value }} are filled in") >= 1
    assert all("crank.toml: statement.en: {" in line for line in result.stderr.splitlines())


@pytest.mark.parametrize("program", PROGRAMS)
def test_a_program_in_a_template_of_an_exam_folder_is_never_run(
    program: str, exam: Path, tmp_path: Path
) -> None:
    folder = Path(shutil.copytree(exam, tmp_path / "EXAM"))
    (folder / "templates" / "crank.toml").write_text(
        crank_text(("The crank", f"The crank {program}")), encoding="utf-8"
    )
    result = kinegrade("quiz", folder, "--to", "moodle-xml", "-o", tmp_path / "quiz")
    assert (result.exit_code, result.stdout) == (2, "")
    assert all("crank.toml: statement.en: {" in line for line in result.stderr.splitlines())
    assert not (tmp_path / "quiz").exists()


def test_a_text_that_depends_on_values_stands_on_the_paper_and_in_the_quiz(tmp_path: Path) -> None:
    wordings = (
        '[text]\nplace = [{ if = "h > 0", en = "up", zh = "高" }, { en = "low down", zh = "低" }]\n'
    )
    write_class(tmp_path)
    text = crank_text(
        ("[parameters]", f"{wordings}\n[parameters]"),
        ("above $O$", "above $O$, {{ place }}"),
        ('sign = "+x", points', 'sign = "+x", vanishes = true, points'),
    )
    (tmp_path / "crank.toml").write_text(text, encoding="utf-8")
    assert generate(tmp_path).exit_code == 0
    result = kinegrade("quiz", tmp_path / "EXAM", "--to", "moodle-xml", "-o", tmp_path / "quiz.xml")
    assert result.exit_code < 2, result.stderr  # marks of a Cloze question are whole: a complaint
    assert "low down" in (tmp_path / "quiz.xml").read_text(encoding="utf-8")
