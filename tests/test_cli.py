"""The command line: help that answers at once, examples that parse, one line for each fault, never
a traceback.
"""

from __future__ import annotations

import json
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import click
import pytest

import kinegrade as api
from kinegrade.cli import main
from kinegrade.errors import MechanismError, TemplateError
from kinegrade.problem.template.library.library import find_template_names
from tests.small_class import errors, generate, kinegrade, write_class

ROOT = Path(__file__).parent.parent
HEAVY = {"numpy", "flint", "typst", "jinja2", "pikepdf", "sympy", "markdown_it"}


def parses(line: str) -> bool:
    """Whether a shell line calls a command with options that it has; nothing is run."""
    words = [word for word in shlex.split(line, comments=True) if word != "$"]
    name, *arguments = words[1:] or ["--help"]
    if name.startswith("-"):
        return name in ("--help", "-h", "--version")
    try:
        main.commands[name].make_context(name, arguments)
    except click.UsageError as error:
        raise ValueError(f"{line}: {error.message}") from error
    return True


@pytest.mark.parametrize("name", sorted(main.commands))
def test_every_command_has_help_with_an_example_that_parses(name: str) -> None:
    result = kinegrade(name, "--help")
    assert result.exit_code == 0
    (example,) = re.findall(r"Example: (kinegrade .*)", result.stdout)
    assert example.split()[1] == name
    assert parses(example)


@pytest.mark.parametrize(
    "line",
    [
        "kinegrade solve slider-crank --settings r=1",
        "kinegrade generate bank.toml",
        "kinegrade list --lang fr",
    ],
)
def test_an_example_that_does_not_parse_would_be_noticed(line: str) -> None:
    with pytest.raises(ValueError, match=line):
        parses(line)


def test_help_imports_nothing_heavy() -> None:
    code = f"""
import sys
from kinegrade.cli import main
for arguments in (["--help"], ["generate", "--help"], ["--version"]):
    try:
        main(arguments)
    except SystemExit:
        pass
print("heavy:", sorted({HEAVY!r} & set(sys.modules)))
"""
    path = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    ran = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, check=True, text=True, env=path
    )
    assert ran.stdout.splitlines()[-1] == "heavy: []"
    assert f"kinegrade, version {api.__version__}" in ran.stdout


def test_list_names_every_template_in_both_languages() -> None:
    english, chinese = kinegrade("list"), kinegrade("list", "--lang", "zh")
    rows = [line.split("\t") for line in english.stdout.splitlines()]
    assert [row[0] for row in rows] == list(find_template_names())
    assert ["slider-crank", "slider-crank", "Slider-crank mechanism"] in [row[:3] for row in rows]
    assert "曲柄滑块机构" in chinese.stdout


def test_check_proves_the_named_templates() -> None:
    result = kinegrade("check", "slider-crank", "bar-through-swivelling-sleeve", "--sample", "3")
    assert result.exit_code == 0
    assert [line for line in result.stdout.splitlines() if not line.startswith(" ")] == [
        "slider-crank: sound",
        "bar-through-swivelling-sleeve: sound",
    ]


def test_check_speaks_the_language_asked_for(tmp_path: Path) -> None:
    result = kinegrade("check", "slider-crank", "--sample", "3", "--lang", "de")
    assert result.stdout.startswith("slider-crank: in Ordnung\n")
    assert "erwartet wird" in kinegrade("check", tmp_path / "no.toml", "--lang", "de").stderr


def test_export_writes_what_grade_wrote(small_class: Path, tmp_path: Path) -> None:
    exam, marks = small_class / "EXAM", tmp_path / "MARKS"
    assert kinegrade("grade", exam, exam / "answers.csv", "-o", marks).exit_code == 0
    assert (
        kinegrade("export", marks, "--to", "moodle", "-o", tmp_path / "moodle.csv").exit_code == 0
    )
    assert (tmp_path / "moodle.csv").read_bytes() == (marks / "moodle.csv").read_bytes()
    assert (
        "already exists"
        in errors("export", marks, "--to", "moodle", "-o", tmp_path / "moodle.csv")[0]
    )


def test_complaints_end_with_status_1_and_are_told(small_class: Path, tmp_path: Path) -> None:
    answers = tmp_path / "answers.csv"
    answers.write_text("student,q1.v_B\n007,three\nstranger,1\n", encoding="utf-8")
    result = kinegrade("grade", small_class / "EXAM", answers, "-o", tmp_path / "MARKS")
    assert result.exit_code == 1
    assert result.stdout == ""
    told = [line for line in result.stderr.splitlines() if line.startswith("complaint: ")]
    assert f"MARKS: 4 students marked, {len(told)} complaints" in result.stderr
    assert any('no student "stranger" in the exam' in line for line in told), told
    assert any('"three" is not a number' in line for line in told), told


@pytest.mark.parametrize(
    "arguments",
    [
        [],
        ["unknown"],
        ["show"],
        ["list", "--lang", "fr"],
        ["generate", "bank.toml"],
        ["grade", "EXAM", "a.csv"],
        ["check", "--sample", "0"],
        ["export", "MARKS", "--to", "nowhere", "-o", "x"],
        ["solve", "slider-crank", "--sett", "r=1"],
    ],
)
def test_wrong_use_ends_with_status_2(arguments: list[str]) -> None:
    assert kinegrade(*arguments).exit_code == 2


CONTENTS: dict[str, bytes | None] = {
    "missing": None,
    "empty": b"",
    "blank": b"\n \n",
    "binary": bytes(range(256)) * 20,
    "zeros": bytes(5000),
    "latin": "na\xefve;caf\xe9\n1;2\n".encode("latin-1"),
    "utf-16": "who,what\n1,Ann\n".encode("utf-16"),
    "zip": b"PK\x03\x04" + bytes(500),
    "pdf": b"%PDF-1.7\n%\xe2\xe3\xcf\xd3\n",
    "long line": b"a" * 300_000,
    "brackets": b"a = " + b"[" * 5000,
    "json": b'{"format": 1}',
    "quotes": b'"' * 999,
    "commas": b"," * 999 + b"\n" * 99,
}


@pytest.mark.parametrize("kind", [*CONTENTS, "folder"])
def test_a_file_of_any_kind_is_refused_without_a_traceback(
    small_class: Path, tmp_path: Path, kind: str
) -> None:
    exam, bank, roster = (small_class / name for name in ("EXAM", "bank.toml", "roster.csv"))
    bad, out = tmp_path / "odd.toml", tmp_path / "OUT"
    content = CONTENTS.get(kind)
    if kind == "folder":
        bad.mkdir()
    elif content is not None:
        bad.write_bytes(content)
    for arguments in (
        ("show", bad),
        ("solve", bad),
        ("check", bad),
        ("show", str(bad).removesuffix(".toml")),
        ("generate", bad, roster, "-o", out),
        ("generate", bank, bad, "-o", out),
        ("grade", bad, exam / "answers.csv", "-o", out),
        ("grade", exam, bad, "-o", out),
        ("export", bad, "--to", "moodle", "-o", out),
    ):
        assert errors(*arguments)
    assert not out.exists()


@pytest.mark.parametrize("damage", ["exam.json", "key.jsonl"])
@pytest.mark.parametrize("kind", [*CONTENTS, "folder"])
def test_a_damaged_exam_is_refused_without_a_traceback(
    small_class: Path, tmp_path: Path, damage: str, kind: str
) -> None:
    exam, content = tmp_path / "EXAM", CONTENTS.get(kind)
    exam.mkdir()
    for name in {"exam.json", "key.jsonl"} - {damage}:
        (exam / name).write_bytes((small_class / "EXAM" / name).read_bytes())
    if kind == "folder":
        (exam / damage).mkdir()
    elif content is not None:
        (exam / damage).write_bytes(content)
    assert errors("grade", exam, small_class / "EXAM" / "answers.csv", "-o", tmp_path / "MARKS")
    assert not (tmp_path / "MARKS").exists()


def test_an_output_has_room_or_is_refused(small_class: Path, tmp_path: Path) -> None:
    exam = small_class / "EXAM"
    (tmp_path / "file").write_text("mine")
    assert (
        "is not a folder" in errors("grade", exam, exam / "answers.csv", "-o", tmp_path / "file")[0]
    )
    assert (
        "is the root of the file system"
        in errors("grade", exam, exam / "answers.csv", "-o", "/")[0]
    )
    assert (
        "cannot be written"
        in errors("grade", exam, exam / "answers.csv", "-o", tmp_path / "file" / "below")[0]
    )
    assert (
        kinegrade("grade", exam, exam / "answers.csv", "-o", tmp_path / "new" / "MARKS").exit_code
        == 0
    )


def test_the_interface_of_python_solves_as_the_command_does() -> None:
    solution = api.template("slider-crank").solve(r="1/5", phi=40)
    record = json.loads(
        kinegrade("solve", "slider-crank", "--set", "r=1/5", "--set", "phi=40", "--json").stdout
    )
    assert {
        name: (answer.value, answer.exact, answer.unit) for name, answer in solution.answers.items()
    } == {
        name: (answer["value"], answer["exact"], answer["unit"])
        for name, answer in record["answers"].items()
    }
    assert api.template("slider-crank").solve(r=0.25)["v_B"].exact == "sqrt(3)/6"
    assert api.template("slider-crank").solve(phi=60)["v_B"].decimal(20) == "1.154700538379251529"


def test_the_interface_of_python_refuses_as_the_command_does() -> None:
    with pytest.raises(TemplateError, match='no template "slider": did you mean "slider-crank"'):
        api.template("slider")
    with pytest.raises(TemplateError, match='no parameter "rr": did you mean "r"'):
        api.template("slider-crank").solve(rr=1)
    with pytest.raises(MechanismError, match="does not reach"):
        api.template("slider-crank").solve(k="1/9")


def test_a_template_beside_its_bank_serves_every_command(tmp_path: Path) -> None:
    own = write_class(tmp_path) / "crank.toml"
    assert kinegrade("show", own).exit_code == 0
    assert "distinct instances: at least 500 are needed" in kinegrade("check", own).stdout
    assert "v_x" in kinegrade("solve", own, "--set", "h=1/2").stdout
    assert generate(tmp_path).exit_code == 0
