"""What was added in one place alone - a language, a system, an engine, a file format - is refused
by its name.
"""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, cast

import click
import pytest
from click.testing import CliRunner, Result

import kinegrade
from kinegrade.cli import main
from kinegrade.cli.exams import generate
from kinegrade.cli.export import export
from kinegrade.cli.marks import feedback
from kinegrade.cli.problems.choosing import show
from kinegrade.cli.quiz import quiz
from kinegrade.errors import TemplateError, TypesetError
from kinegrade.exam.printing.printing import PressOrder
from kinegrade.language import Language
from kinegrade.language.known import known_languages
from kinegrade.press import protocol
from kinegrade.press.word.press import PandocPress
from kinegrade.problem.template.translated import Translated

PACKAGE = Path(kinegrade.__file__).parent
FRENCH = (
    'exam.json:1: language: "fr" - expected one of de, en, zh, which this version of kinegrade knows - '
    "restore the exam folder as it was generated"
)


def run(*arguments: object) -> Result:
    return CliRunner().invoke(main, list(map(str, arguments)))


def choices(command: click.Command, name: str) -> click.Choice[str]:
    """The choices of an option of a command."""
    found = next(parameter for parameter in command.params if parameter.name == name)
    return cast("click.Choice[str]", found.type)


def offered(monkeypatch: pytest.MonkeyPatch, command: click.Command, name: str, new: str) -> None:
    """Offer one choice more, which nothing behind the command line knows."""
    option = choices(command, name)
    monkeypatch.setattr(option, "choices", (*option.choices, new))


@pytest.fixture
def marked(small_class: Path, tmp_path: Path) -> Path:
    """A folder with the class's EXAM and its MARKS."""
    folder = tmp_path / "class"
    shutil.copytree(small_class / "EXAM", folder / "EXAM")
    result = run("grade", folder / "EXAM", folder / "EXAM" / "answers.csv", "-o", folder / "MARKS")
    assert (folder / "MARKS").is_dir(), result.output
    return folder


def with_language(marked: Path, language: str | None) -> Path:
    """The class, with papers that are in another language, or in none that is said."""
    file = marked / "EXAM" / "exam.json"
    head = json.loads(file.read_text(encoding="utf-8"))
    del head["language"]
    if language is not None:
        head["language"] = language
    file.write_text(json.dumps(head), encoding="utf-8")
    return marked


def commands(folder: Path, output: Path) -> list[tuple[object, ...]]:
    """Every command that speaks the language of the papers."""
    exam, marks = folder / "EXAM", folder / "MARKS"
    return [
        ("report", exam, marks, "-o", output),
        ("feedback", exam, marks, "-o", output, "--format", "md"),
        ("quiz", exam, "--to", "moodle-xml", "-o", output),
    ]


def test_an_exam_in_an_unknown_language_is_not_taken_for_an_english_one(
    marked: Path, tmp_path: Path
) -> None:
    output = tmp_path / "out"
    for command in commands(with_language(marked, "fr"), output):
        result = run(*command)
        assert (result.exit_code, FRENCH in result.output) == (2, True), result.output
        assert not output.exists()


def test_an_exam_that_says_no_language_is_refused_as_well(marked: Path, tmp_path: Path) -> None:
    folder = with_language(marked, None)
    result = run("quiz", folder / "EXAM", "--to", "qti12", "-o", tmp_path / "out")
    assert result.exit_code == 2
    assert "exam.json: language: missing - expected one of de, en, zh" in result.output


def test_no_text_of_another_language_stands_in_for_a_missing_one() -> None:
    crank = Translated((("en", "a crank"), ("zh", "曲柄")))
    with pytest.raises(TemplateError, match="fr"):
        crank.in_language(Language("fr"))


def test_every_language_is_offered_and_no_other() -> None:
    names = "|".join(known_languages())
    for command in (generate, show, quiz, feedback, export):
        assert f"--lang [{names}]" in run(command.name, "--help").stdout
        result = run(command.name, "--lang", "zn")
        assert result.exit_code == 2
        assert 'unknown: "zn" - expected a language with a catalogue' in result.stderr


def test_feedback_in_a_form_that_only_the_command_line_knows_is_not_written(
    marked: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    offered(monkeypatch, feedback, "form", "epub")
    output = tmp_path / "out"
    named = (marked / "EXAM", marked / "MARKS", "-o", output)
    result = run("feedback", *named, "--format", "epub")
    assert (result.exit_code, 'form: unknown: "epub" - ' in result.stderr) == (2, True)
    assert not output.exists()


def test_a_typesetter_that_only_the_banks_know_prints_nothing(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(protocol, "ENGINES", (*protocol.ENGINES, "luatex"))
    order = PressOrder(cast("protocol.Engine", "luatex"), "a4")
    with pytest.raises(AssertionError, match="luatex"):
        order.press()


def test_a_kind_of_file_that_no_press_writes_is_refused() -> None:
    with pytest.raises(TypesetError, match="odt: not a kind of file that papers are written in"):
        PandocPress().also(cast("Any", None), "odt")


def joint(text: str) -> str:
    new = "class Chain:\n    body: str\n    of: str\n\n\nJoint = Chain | "
    return text.replace("Joint = ", new)


def driver(text: str) -> str:
    new = "class Spin:\n    body: str\n\n\nDriver = Spin | "
    return text.replace("Driver = ", new)


ADDED: dict[str, Callable[[str], str]] = {
    "mechanics/joints/__init__.py": joint,
    "mechanics/drivers/__init__.py": driver,
}
# All joints and drivers, and what has them
KNOWN = ("mechanics/joints", "mechanics/drivers", "mechanics/mechanism.py")
REPORTED = (
    ("problem/assembling/parts.py", "Chain"),
    ("mechanics/frames.py", "Chain"),
    ("mechanics/configuration.py", "Chain"),
    ("figure/joints/table.py", "Chain"),
    ("mechanics/frames.py", "Spin"),
    ("figure/joints/drivers.py", "Spin"),
)


def test_the_type_checker_names_every_place_that_does_not_know_what_was_added(
    tmp_path: Path,
) -> None:
    copy = tmp_path / "kinegrade"
    shutil.copytree(PACKAGE, copy, ignore=shutil.ignore_patterns("__pycache__"))
    for name, changed in ADDED.items():
        text = (copy / name).read_text(encoding="utf-8")
        assert changed(text) != text
        (copy / name).write_text(changed(text), encoding="utf-8")
    for name in ("pyproject.toml", "tests/replaced_values.py"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        shutil.copy(PACKAGE.parent / name, tmp_path / name)
    files = [f"kinegrade/{name}" for name in (*KNOWN, *dict(REPORTED))]
    # What these files import of the rest of the package does not matter to them
    arguments = [sys.executable, "-m", "mypy", "--follow-imports=skip", *files]
    result = subprocess.run(arguments, cwd=tmp_path, capture_output=True, text=True, check=False)
    lines = result.stdout.splitlines()
    for name, thing in REPORTED:
        expected = f"kinegrade/{name}:"
        assert [line for line in lines if line.startswith(expected) and thing in line], name
