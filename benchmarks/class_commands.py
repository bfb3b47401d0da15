"""The commands of a term for a class of 200, each as a process of its own, against an import of
sympy: an instructor waits for none of them longer than two seconds.

Only what typesets, solves or checks a whole class may take longer: generate, solutions, quiz,
check, gallery and feedback.
"""

from __future__ import annotations

import csv
import json
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from random import Random
from resource import RUSAGE_CHILDREN, getrusage
from tempfile import TemporaryDirectory

from benchmarks.figure_of_merit import Figure

STUDENTS, SPARE = 200, 5
PROMISE = 0.22  # two seconds, where an import of sympy takes 0.44
KEPT_SHARE = 0.8  # of the answers are right
DONE = (0, 1)  # statuses: 1 is done with something to say


@dataclass(frozen=True)
class Class:
    """Two exams of a class, answered and marked, in a folder of its own."""

    folder: Path

    def run(self, *arguments: str) -> None:
        """Run the command in the folder; AssertionError if it refuses."""
        command = Path(sys.executable).with_name("kinegrade")
        done = subprocess.run(
            [command, *arguments], cwd=self.folder, capture_output=True, check=False, text=True
        )
        assert done.returncode in DONE, f"{arguments}: {done.stderr}"


#: What is timed, in the order of a term; each writes a place of its own.
COMMANDS = (
    "roster roster.csv",
    "paper EXAM 0007 -o paper.pdf",
    "papers EXAM -o papers --send-list send.csv",
    "assign EXAM CODE 9001",
    "archive EXAM -o exam.zip",
    "grade EXAM answers.csv -o AGAIN",
    "export MARKS --to moodle -o moodle.csv",
    "export MARKS --to canvas --exam EXAM -o canvas.csv",
    "export MARKS --to xlsx -o marks.xlsx",
    "diff MARKS AGAIN",
    "report EXAM MARKS -o report.html",
    "sharing EXAM MARKS -o sharing.csv",
    "explain EXAM MARKS 0007",
    "compare-entries answers.csv second.csv",
    "merge MARKS AGAIN --prefer last -o ALL",
    "term MARKS SECOND -o term.csv",
)


def figures() -> Iterator[Figure]:
    """Processor time of each command; seconds, parts that run side by side added up."""
    with TemporaryDirectory() as name:
        class_ = make_class(Path(name), STUDENTS)
        importing = cost(lambda: subprocess.run([sys.executable, "-c", "import sympy"], check=True))
        for words in list_commands(class_.folder):
            ours = cost(lambda words=words: class_.run(*words))
            yield Figure(f"{words[0]}, {STUDENTS} students", ours, importing, PROMISE)


def list_commands(folder: Path) -> Iterator[list[str]]:
    """The words of each command for the class there."""
    code = spare_code(folder)
    for command in COMMANDS:
        yield command.replace("CODE", code).split()


def cost(work: Callable[[], object]) -> float:
    """Processor time of what `work` starts, and waits for."""
    before = getrusage(RUSAGE_CHILDREN)
    work()
    after = getrusage(RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def make_class(folder: Path, students: int) -> Class:
    """Two exams set, their answers typed, most of them right, and marked."""
    class_ = Class(folder)
    write_roster(folder / "roster.csv", students)
    setting = "generate", "demo", "roster.csv"
    class_.run(*setting, "-o", "EXAM", "--spare", str(SPARE), "--reproducible", "x")
    write_answers(folder / "EXAM", folder / "answers.csv")
    shutil.copy(folder / "answers.csv", folder / "second.csv")  # as somebody else has typed them
    class_.run("grade", "EXAM", "answers.csv", "-o", "MARKS")
    class_.run(*setting, "-o", "NEXT", "--no-papers", "--reproducible", "y")
    write_answers(folder / "NEXT", folder / "next.csv")
    class_.run("grade", "NEXT", "next.csv", "-o", "SECOND")
    return class_


def write_roster(file: Path, students: int) -> None:
    """Ids with leading zeros, in three rooms and four groups."""
    with file.open("w", encoding="utf-8", newline="") as opened:
        table = csv.writer(opened)
        table.writerow(("student", "name", "room", "seat", "group"))
        for place in range(students):
            room, group = f"R{place % 3}", f"G{place % 4}"
            table.writerow((f"{place:04}", f"Student {place}", room, place, group))


def write_answers(exam: Path, file: Path) -> None:
    """The sheet of an exam, filled in from its key."""
    random = Random(1)
    with (exam / "key.jsonl").open(encoding="utf-8") as lines:
        keys = list(map(json.loads, lines))
    with file.open("w", encoding="utf-8", newline="") as opened:
        table = csv.writer(opened)
        for place, key in enumerate(keys):
            typed = dict(list_typed(key, random))
            if not place:
                table.writerow(("student", *typed))
            table.writerow((key["student"], *typed.values()))


def list_typed(key: dict[str, object], random: Random) -> Iterator[tuple[str, str]]:
    """Each ask's column and a number with four figures, wrong by a fifth now and then."""
    for question in key["questions"]:
        for name, ask in question["asks"].items():
            slip = 1.0 if random.random() < KEPT_SHARE else 1.2
            yield f"{question['question']}.{name}", f"{ask['value'] * slip:.4g}"


def spare_code(folder: Path) -> str:
    """The code of the first spare paper."""
    with (folder / "EXAM" / "spares.jsonl").open(encoding="utf-8") as lines:
        return str(json.loads(next(lines))["paper"])
