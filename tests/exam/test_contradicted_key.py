"""A folder whose key and templates contradict each other: no command derives from it what its key
does not say.
"""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from kinegrade.errors import ExamError
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.setting.kept_exam import KeptExam
from tests.small_class import asks_of, key_lines, kinegrade

EARLIER = Path(__file__).parent.parent / "data" / "exam-of-0.1"
BANK = """title = "Quiz"
course = "Mechanics"
credit = { follow-through = "1/2" }

[[questions]]
template = "slider-crank"
asks = { omega_AB = 3, a_B = 2 }
"""
REMEDY = (
    " - expected both to agree - restore the exam folder as it was generated, or use the "
    "version of kinegrade that made it"
)
Damage = Callable[[Path], None]
Command = Callable[[Path, Path], tuple[str | Path, ...]]


@pytest.fixture(scope="module")
def generated(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("class")
    (folder / "bank.toml").write_text(BANK, encoding="utf-8")
    (folder / "roster.csv").write_text("student,name\n007,Ann\n012,Bob\n", encoding="utf-8")
    files = folder / "bank.toml", folder / "roster.csv"
    options = ("--reproducible", "spring", "--solutions")
    result = kinegrade("generate", *files, "-o", folder / "EXAM", *options)
    assert result.exit_code == 0, result.stderr
    return folder / "EXAM"


@pytest.fixture
def exam(generated: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(generated, tmp_path / "EXAM"))


def edit_template(exam: Path) -> None:
    """Somebody asks for twice the acceleration in the folder's copy."""
    copy = exam / "templates" / "slider-crank.toml"
    text = copy.read_text(encoding="utf-8")
    assert '"x(acceleration(B))"' in text
    edited = text.replace('"x(acceleration(B))"', '"2*x(acceleration(B))"')
    copy.write_text(edited, encoding="utf-8")


def edit_key(exam: Path) -> None:
    """Somebody writes another acceleration into the key, consistently."""
    lines = key_lines(exam)
    for line in lines:
        line["questions"][0]["asks"]["a_B"] |= {"exact": "7", "decimal": "7", "value": 7.0}
    text = "".join(json.dumps(line) + "\n" for line in lines)
    (exam / "key.jsonl").write_text(text, encoding="utf-8")


def quiz(exam: Path, place: Path) -> tuple[str | Path, ...]:
    return ("quiz", exam, "--to", "qti21", "--solutions", "-o", place / "quiz.zip")


def pool(exam: Path, place: Path) -> tuple[str | Path, ...]:
    return (*quiz(exam, place), "--variants", "1")


def grade(exam: Path, place: Path) -> tuple[str | Path, ...]:
    """Both answers are wrong, and the second may follow from the first."""
    answers = place / "answers.csv"
    right = asks_of(exam)["007", "q1.omega_AB"]["value"]
    answers.write_text(f"student,q1.omega_AB,q1.a_B\n007,{1.5 * right:.5g},99\n", encoding="utf-8")
    return ("grade", exam, answers, "-o", place / "MARKS")


def feedback(exam: Path, place: Path) -> tuple[str | Path, ...]:
    marks = place / "BEFORE"
    answers = ("grade", exam, exam / "answers.csv", "-o", marks)
    assert kinegrade(*answers).exit_code < 2
    return ("feedback", exam, marks, "--format", "md", "--solutions", "-o", place / "FEEDBACK")


COMMANDS = [quiz, pool, grade, feedback]


@pytest.mark.parametrize("command", COMMANDS)
def test_a_folder_as_it_was_generated_is_taken(
    exam: Path, tmp_path: Path, command: Command
) -> None:
    result = kinegrade(*command(exam, tmp_path))
    assert result.exit_code < 2, result.stderr


@pytest.mark.parametrize("command", COMMANDS)
@pytest.mark.parametrize("damage", [edit_template, edit_key])
def test_a_key_that_does_not_follow_from_the_folder_is_refused(
    exam: Path, tmp_path: Path, damage: Damage, command: Command
) -> None:
    damage(exam)
    words = command(exam, tmp_path)
    result = kinegrade(*words)
    assert result.exit_code == 2
    (line,) = result.stderr.splitlines()[-1:]
    assert re.search(r'EXAM/key\.jsonl: student "007", q1: a_B is \S+ by the key', line), line
    assert line.endswith(REMEDY)
    assert not Path(words[words.index("-o") + 1]).exists()


def test_a_question_that_the_bank_does_not_have_is_refused(exam: Path) -> None:
    lines = key_lines(exam)
    lines[0]["questions"][0]["question"] = "q9"
    (exam / "key.jsonl").write_text(json.dumps(lines[0]) + "\n", encoding="utf-8")
    with pytest.raises(ExamError) as caught:
        KeptExam(open_exam(exam)).require_no_contradiction()
    where = f'{exam / "key.jsonl"}: student "007", q9'
    assert str(caught.value) == f"{where}: is no question of the bank{REMEDY}"


def test_a_bank_that_was_edited_is_refused(exam: Path, tmp_path: Path) -> None:
    bank = exam / "bank.toml"
    text = bank.read_text(encoding="utf-8")
    bank.write_text(text.replace("a_B = 2", "a_B = 3"), encoding="utf-8")
    result = kinegrade(*quiz(exam, tmp_path))
    assert result.exit_code == 2
    assert f"q1: a_B: points is 2 by the key, 3 by the bank{REMEDY}" in result.stderr


def test_an_earlier_folder_makes_a_quiz_with_solutions(tmp_path: Path) -> None:
    exam = Path(shutil.copytree(EARLIER, tmp_path / "EXAM"))
    result = kinegrade(*quiz(exam, tmp_path))
    assert result.exit_code < 2, result.stderr
    damaged = exam / "templates" / "slider-crank.toml"
    text = damaged.read_text(encoding="utf-8")
    damaged.write_text(text.replace('"x(acceleration(B))"', '"2*x(acceleration(B))"'), "utf-8")
    again = kinegrade(*quiz(exam, tmp_path), "--force")
    assert (again.exit_code, again.stderr.count(REMEDY)) == (2, again.stderr.count("\n"))


def told_of_the_key(exam: Path, place: Path) -> list[str]:
    """What marking an empty sheet says of the key."""
    done = kinegrade("grade", exam, exam / "answers.csv", "-o", place)
    assert done.exit_code in (0, 1), done.stderr
    return [line for line in done.stderr.splitlines() if "key.jsonl" in line]


def test_marking_by_a_key_that_somebody_changed_says_so(exam: Path, tmp_path: Path) -> None:
    edit_key(exam)
    assert told_of_the_key(exam, tmp_path / "MARKS") == [
        f"{exam}/key.jsonl: was changed since kinegrade wrote it: marks go by what it says now"
        " - kinegrade verify EXAM --all names the lines that no longer follow"
    ]


def test_a_key_that_was_only_touched_or_copied_is_as_it_was_written(
    exam: Path, tmp_path: Path
) -> None:
    copied = Path(shutil.copytree(exam, tmp_path / "COPY", copy_function=shutil.copyfile))
    (exam / "key.jsonl").touch()
    assert told_of_the_key(exam, tmp_path / "M1") == []
    assert told_of_the_key(copied, tmp_path / "M2") == []


@pytest.mark.parametrize("damage", [b"", b"PK\x03\x04", b"nothing"])
def test_without_the_arrays_nobody_can_tell(exam: Path, tmp_path: Path, damage: bytes) -> None:
    edit_key(exam)
    (exam / "key.npz").write_bytes(damage)
    assert told_of_the_key(exam, tmp_path / "MARKS") == []
