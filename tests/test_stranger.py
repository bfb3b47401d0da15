"""A template or an exam folder from a stranger is data: whatever stands in it, a command says one
line and ends.
"""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import Result

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
    assert result.stderr.count("only {{ name }}, {{ name.value }}, {{ name.size }}, ") >= 1
    assert [
        line for line in result.stderr.splitlines() if "crank.toml:10: statement.en: {" not in line
    ] == []


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
    assert [
        line for line in result.stderr.splitlines() if "crank.toml:10: statement.en: {" not in line
    ] == []
    assert not (tmp_path / "quiz").exists()


def test_a_text_that_depends_on_values_stands_on_the_paper_and_in_the_quiz(tmp_path: Path) -> None:
    wordings = (
        '[text]\nplace = [{ if = "h > 0", en = "up", zh = "高" }, { en = "low down", zh = "低" }]\n'
    )
    write_class(tmp_path)
    text = crank_text(
        ("[parameters]", f"{wordings}\n[parameters]"),
        ("above $O$", "above $O$, {{ place }}"),
        ("{{ h.value }}。", "{{ h.value }}，{{ place }}。"),
        ('sign = "+x", points', 'sign = "+x", vanishes = true, points'),
    )
    (tmp_path / "crank.toml").write_text(text, encoding="utf-8")
    assert generate(tmp_path).exit_code == 0
    result = kinegrade("quiz", tmp_path / "EXAM", "--to", "moodle-xml", "-o", tmp_path / "quiz.xml")
    assert result.exit_code < 2, result.stderr  # marks of a Cloze question are whole: a complaint
    assert "low down" in (tmp_path / "quiz.xml").read_text(encoding="utf-8")


ENDLESS = "1e9999999999"
DAMAGED_NUMBERS = [
    ('"decimal": "', f'"decimal": "{ENDLESS}", "was": "'),
    ('"relative": 0.01', f'"relative": {ENDLESS}'),
    ('"relative": 0.01', f'"relative": "{ENDLESS}"'),
    ('"unit": "m/s"', '"unit": []'),
    ('"asks": {', '"asks": 7, "was": {'),
]


@pytest.fixture(scope="module")
def marks(exam: Path) -> Path:
    answers = exam.parent / "typed.csv"
    sheet = (exam / "answers.csv").read_text(encoding="utf-8-sig").splitlines()
    answers.write_text(
        "\n".join([sheet[0], *(f"{line[: line.index(',,')]},5,5,5,5,5,5" for line in sheet[1:])]),
        encoding="utf-8",
    )
    assert kinegrade("grade", exam, answers, "-o", exam.parent / "MARKS").exit_code < 2
    return exam.parent / "MARKS"


def errors(result: Result) -> list[str]:
    """What was refused; a new exam's seed is printed before."""
    return [line for line in result.stderr.splitlines() if not line.startswith("seed: ")]


def commands(exam: Path, marks: Path, place: Path) -> list[tuple[str | Path, ...]]:
    """What reads an exam folder after the exam, each with its output in a place."""
    return [
        ("grade", exam, exam.parent.parent / "none.csv", "-o", place / "AGAIN"),
        ("report", exam, marks, "-o", place / "report.html"),
        ("feedback", exam, marks, "-o", place / "FEEDBACK", "--format", "html"),
        ("quiz", exam, "--to", "moodle-xml", "-o", place / "quiz.xml"),
    ]


@pytest.mark.parametrize(("old", "new"), DAMAGED_NUMBERS)
def test_a_damaged_key_line_is_one_line_and_no_endless_work(
    old: str, new: str, exam: Path, marks: Path, tmp_path: Path
) -> None:
    folder = Path(shutil.copytree(exam, tmp_path / "EXAM"))
    key = (folder / "key.jsonl").read_text(encoding="utf-8")
    assert old in key
    (folder / "key.jsonl").write_text(key.replace(old, new), encoding="utf-8")
    for command in commands(folder, marks, tmp_path)[1:]:
        result = kinegrade(*command)
        assert result.exit_code in (0, 2), command
        assert [line for line in result.stderr.splitlines() if len(line) >= 600] == []
    quiz = kinegrade(*commands(folder, marks, tmp_path)[-1])
    assert quiz.exit_code == 2
    assert "key.jsonl" in quiz.stderr


def test_an_exact_answer_that_is_no_text_is_one_line_of_the_feedback(
    exam: Path, marks: Path, tmp_path: Path
) -> None:
    folder = Path(shutil.copytree(exam, tmp_path / "EXAM"))
    key = (folder / "key.jsonl").read_text(encoding="utf-8")
    (folder / "key.jsonl").write_text(key.replace('"exact": "', '"exact": 7, "was": "'), "utf-8")
    result = kinegrade("feedback", folder, marks, "-o", tmp_path / "FEEDBACK", "--format", "html")
    assert (result.exit_code, len(result.stderr.splitlines())) == (2, 1)
    assert "key.jsonl" in result.stderr
    assert not (tmp_path / "quiz.xml").exists()


@pytest.mark.parametrize("column", ["read_as", "points", "out_of"])
def test_an_endless_number_in_marks_is_one_line(
    column: str, exam: Path, marks: Path, tmp_path: Path
) -> None:
    folder = Path(shutil.copytree(marks, tmp_path / "MARKS"))
    lines = (folder / "marks.csv").read_text(encoding="utf-8-sig").splitlines()
    place = lines[0].split(",").index(column)
    cells = lines[1].split(",")
    cells[place] = ENDLESS
    (folder / "marks.csv").write_text(
        "\n".join([lines[0], ",".join(cells), *lines[2:]]), encoding="utf-8"
    )
    for command in commands(exam, folder, tmp_path)[1:3]:
        result = kinegrade(*command)
        assert result.exit_code == 2
        (line,) = errors(result)
        assert "marks.csv:2: " in line
        assert f'"{ENDLESS}"' in line


def test_a_name_of_another_type_is_one_line(exam: Path, marks: Path, tmp_path: Path) -> None:
    folder = Path(shutil.copytree(exam, tmp_path / "EXAM"))
    head = json.loads((folder / "exam.json").read_text(encoding="utf-8"))
    head["students"][0]["name"] = {"first": "Ann"}
    (folder / "exam.json").write_text(json.dumps(head), encoding="utf-8")
    for command in commands(folder, marks, tmp_path)[1:]:
        result = kinegrade(*command)
        assert result.exit_code == 2, command
        (line,) = errors(result)
        assert "exam.json" in line


LEFT = pytest.mark.left(beside="test_deep_keys_are_one_line_in_every_file_that_people_write")


@pytest.mark.parametrize(
    "deep",
    [
        pytest.param("a." * 20_000 + "a = 1\n", id="20,000 keys", marks=LEFT),
        pytest.param("a." * 100 + "a = 1\n", id="100 keys"),
        pytest.param(f"x = {'[' * 5000}{']' * 5000}\n", id="5,000 lists"),
    ],
)
def test_deep_keys_are_one_line_in_every_file_that_people_write(
    deep: str, exam: Path, tmp_path: Path
) -> None:
    write_class(tmp_path)
    for name in ("crank.toml", "bank.toml", "policy.toml"):
        text = (tmp_path / name).read_text(encoding="utf-8") if name != "policy.toml" else ""
        (tmp_path / f"deep-{name}").write_text(deep + text, encoding="utf-8")
    for command in (
        ("show", tmp_path / "deep-crank.toml"),
        ("generate", tmp_path / "deep-bank.toml", tmp_path / "roster.csv", "-o", tmp_path / "E"),
        (
            *("grade", exam, exam / "answers.csv", "-o", tmp_path / "M"),
            *("--policy", tmp_path / "deep-policy.toml"),
        ),
    ):
        result = kinegrade(*command)
        assert result.exit_code == 2
        (line,) = errors(result)
        assert "write it more simply" in line


POWER = "((9**16)**16)**16"


@pytest.mark.parametrize(
    "change",
    [
        ("draw = [1, 2], means", f'draw = ["{POWER}"], means'),
        ('velocity = "omega"', f'velocity = "omega*{POWER}"'),
        ('P = "(0, h)"', f'P = "(0, h/{POWER})"'),
    ],
)
def test_a_number_of_15_000_digits_is_no_traceback(change: tuple[str, str], tmp_path: Path) -> None:
    template = tmp_path / "crank.toml"
    template.write_text(crank_text(change), encoding="utf-8")
    for command in (("check", template, "--sample", "3"), ("show", template)):
        assert kinegrade(*command).exit_code in (0, 1, 2)
    result = kinegrade("solve", template, "-o", tmp_path / "page.pdf")
    assert result.exit_code in (0, 2)
    assert [
        line for line in result.stderr.splitlines() if not line.startswith("error: crank")
    ] == []


def test_a_name_that_is_too_long_is_one_line(exam: Path, marks: Path, tmp_path: Path) -> None:
    output = tmp_path / ("n" * 300)
    for command in (
        ("solve", "slider-crank", "-o", output),
        ("new", "n" * 300),
        (
            *("generate", exam.parent / "bank.toml", exam.parent / "roster.csv", "-o", output),
            "--allow-odd-ids",
        ),
        ("grade", exam, exam / "answers.csv", "-o", output),
        ("report", exam, marks, "-o", output),
        ("feedback", exam, marks, "-o", output, "--format", "md"),
        ("export", marks, "--to", "generic", "-o", output),
    ):
        result = kinegrade(*command)
        assert result.exit_code == 2, command
        (line,) = errors(result)
        assert "cannot be written" in line


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no /dev/full here")
@pytest.mark.parametrize("command", [("list",), ("show", "slider-crank")])
def test_a_full_disk_behind_standard_output_is_one_line(command: tuple[str, ...]) -> None:
    with open("/dev/full", "w") as full:
        result = subprocess.run(
            [sys.executable, "-m", "kinegrade", *command],
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            check=False,
        )
    assert result.returncode == 2
    assert result.stderr == (
        "error: standard output: cannot be written (No space left on device) - expected a place "
        "with room - send it elsewhere\n"
    )
