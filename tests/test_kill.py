"""SIGKILL at any moment leaves the old output or the new one, never half; the next run works and
clears up.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.small_class import STUDENTS, contents, generate, key_lines, kinegrade, write_class

pytestmark = pytest.mark.skipif(os.name != "posix", reason="signals and atomic renaming of POSIX")
REPLACED = "the output itself"
Moment = Callable[[Path], bool]  # of the folder that holds the output: whether it is time


def killed(arguments: list[str], folder: Path, moment: Moment, delay: float) -> bool:
    """Runs the command and kills it `delay` seconds after the moment has come; whether it still ran
    then.
    """
    process = subprocess.Popen(
        [sys.executable, "-m", "kinegrade", *arguments],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
    )
    while process.poll() is None and not moment(folder):
        time.sleep(0.0002)
    time.sleep(delay)
    process.kill()
    return process.wait() < 0


def being_made(name: str) -> Moment:
    """The moment at which a file of that name stands in the hidden folder."""
    return lambda folder: any((partial / name).exists() for partial in folder.glob(".*.partial-*"))


def being_written(folder: Path) -> bool:
    """The moment at which a hidden file stands beside the output."""
    return any(folder.glob(".*.partial-*"))


def replaced(output: Path) -> Moment:
    """The moment at which another folder stands in the output's place, the old one about to be
    removed.
    """
    number = output.stat().st_ino
    return lambda folder: output.stat().st_ino != number


def leftovers(folder: Path) -> list[str]:
    return [entry.name for entry in folder.iterdir() if entry.name.startswith(".")]


@pytest.mark.sampled(4, by="name", first=1)
@pytest.mark.parametrize(
    ("name", "delay"),
    [
        ("papers/007.pdf", 0.0),
        ("key.pdf", 0.0),
        ("INSTRUCTOR-ONLY.txt", 0.05),
        (REPLACED, 0.0),
    ],
)
def test_a_killed_generate_leaves_the_old_exam_or_the_new(
    small_class: Path, other_exam: Path, tmp_path: Path, name: str, delay: float
) -> None:
    old, new = contents(small_class / "EXAM"), contents(other_exam)
    shutil.copytree(small_class / "EXAM", tmp_path / "EXAM")
    arguments = [
        "generate",
        str(small_class / "bank.toml"),
        str(small_class / "roster.csv"),
        "-o",
        str(tmp_path / "EXAM"),
        "--reproducible",
        "autumn",
        "--allow-odd-ids",
        "--force",
        "--new-numbers",
    ]
    moment = replaced(tmp_path / "EXAM") if name == REPLACED else being_made(name)
    assert killed(arguments, tmp_path, moment, delay) or delay or name == REPLACED
    assert contents(tmp_path / "EXAM") in ((new,) if name == REPLACED else (old, new))
    if name == "key.pdf":
        assert leftovers(tmp_path)
        assert (
            generate(
                write_class(tmp_path),
                "EXAM",
                "--reproducible",
                "autumn",
                "--force",
                "--new-numbers",
            ).exit_code
            == 0
        )
        assert contents(tmp_path / "EXAM") == new
        assert not leftovers(tmp_path)


@pytest.mark.sampled(3, by="name")
@pytest.mark.parametrize("name", ["papers/late.pdf", "INSTRUCTOR-ONLY.txt", REPLACED])
def test_a_killed_addition_leaves_the_old_exam_or_the_new(
    small_class: Path, tmp_path: Path, name: str
) -> None:
    exam, late = tmp_path / "EXAM", tmp_path / "late.csv"
    shutil.copytree(small_class / "EXAM", exam)
    late.write_text("student,name\nlate,Late\n", encoding="utf-8")
    files = str(small_class / "bank.toml"), str(small_class / "roster.csv")
    arguments = ["generate", *files, "-o", str(exam), "--add", str(late), "--allow-odd-ids"]
    old = contents(exam)
    moment = replaced(exam) if name == REPLACED else being_made(name)
    assert killed(arguments, tmp_path, moment, 0.0) or name == REPLACED
    after = contents(exam)
    assert after == old or "papers/late.pdf" in after
    if after == old:
        assert kinegrade(*arguments).exit_code == 0
    students = [line["student"] for line in key_lines(exam)]
    assert students == [*STUDENTS, "late"]
    assert not leftovers(tmp_path) or name == REPLACED


@pytest.fixture(scope="module")
def other_exam(small_class: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The exam of the same class with another seed."""
    folder = write_class(tmp_path_factory.mktemp("other"))
    if generate(folder, "EXAM", "--reproducible", "autumn").exit_code:
        raise RuntimeError("the exam cannot be generated")
    return folder / "EXAM"


@pytest.fixture(scope="module")
def twice_marked(small_class: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with OLD marks, of nobody's answers, and the NEW ones of answers.csv."""
    exam, folder = small_class / "EXAM", tmp_path_factory.mktemp("marked")
    answers = folder / "answers.csv"
    answers.write_text("student,q1.v_B\n" + "007,1\n" * 3000, encoding="utf-8")
    assert kinegrade("grade", exam, exam / "answers.csv", "-o", folder / "OLD").exit_code == 0
    assert kinegrade("grade", exam, answers, "-o", folder / "NEW").exit_code == 1
    return folder


@pytest.mark.sampled(5, by="delay", first=1)
@pytest.mark.parametrize(
    ("name", "delay"),
    [
        (".", 0.0),
        ("marks.csv", 0.0),
        ("moodle.csv", 0.0),
        ("moodle.csv", 0.01),
        (REPLACED, 0.0),
    ],
)
def test_a_killed_grade_leaves_the_old_marks_or_the_new(
    small_class: Path, twice_marked: Path, tmp_path: Path, name: str, delay: float
) -> None:
    marks = Path(shutil.copytree(twice_marked / "OLD", tmp_path / "MARKS"))
    old, new = contents(marks), contents(twice_marked / "NEW")
    answers = twice_marked / "answers.csv"
    again = ("grade", small_class / "EXAM", answers, "-o", marks, "--force")
    moment = replaced(marks) if name == REPLACED else being_made(name)
    # Or it was faster than the eye, and is done
    killed(list(map(str, again)), tmp_path, moment, delay)
    assert contents(marks) in ((new,) if name == REPLACED else (old, new))
    assert kinegrade(*again).exit_code == 1
    assert contents(marks) == new
    assert not leftovers(tmp_path)


@pytest.mark.sampled(2, by="system")
@pytest.mark.parametrize("system", ["moodle-xml", "qti21"])
def test_a_killed_quiz_leaves_the_old_file_and_the_next_one_clears_up(
    small_class: Path, tmp_path: Path, system: str
) -> None:
    output = tmp_path / "quiz.zip"
    output.write_text("old", encoding="utf-8")
    again = ["quiz", str(small_class / "EXAM"), "--to", system, "-o", str(output), "--force"]
    left = killed(again, tmp_path, being_written, 0.0)
    if left:
        assert output.read_text(encoding="utf-8") == "old"
        assert leftovers(tmp_path)
    assert kinegrade(*again).exit_code in (0, 1)
    assert output.stat().st_size > 2000
    assert not leftovers(tmp_path)
