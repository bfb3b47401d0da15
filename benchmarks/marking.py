"""Marking a class of 20,000 x 10 asks, against the plain loop that people write for it.

The loop reads the same key and the same sheet, compares by `float` and `math.isclose`, and writes a
line for each answer and each student. Ours is all of `grade`: it reads and checks the folder, marks
by exact rules, knows mistakes, units and formulas, gives every reason, and writes all its files.
The command does more: it follows wrong answers through, and reads and checks what it has written.
Processor time, in one process; memory is that of the command.
"""

from __future__ import annotations

import csv
import json
import math
import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from resource import RUSAGE_CHILDREN, getrusage
from tempfile import TemporaryDirectory
from time import process_time

from benchmarks.figure_of_merit import Figure
from benchmarks.large_class import COLUMNS, write_class
from benchmarks.memory import peak_of_tree
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.grading.grade import grade

STUDENTS = 20_000
# Of the answers: commas, units, roots, blanks, words
FEW_ODD_SHARE, ODD_SHARE = 0.01, 0.1
PLAIN_PROMISE, FEW_PROMISE, MIXED_PROMISE = 3.4, 2.5, 1.3
PLAIN_SOUGHT = 8  # what reads and writes alone takes nearly all of the time that this allows
GRADE = "grade EXAM answers.csv -o MARKS"
#: What is promised of whole commands; `grade` has exports and checks of what it has written.
COMMANDS = {
    GRADE: 1,
    "report EXAM MARKS -o report.html": 1 / 6,
    "sharing EXAM MARKS -o sharing.csv": 0.4,
}
SMALL, SMALL_GROWTH_PROMISE = (300, 3000), 1.1  # students; the most that ten times as many may take
RUNS = 3  # the best counts: the first pays for imports and caches
_NOT_COMPILED = "PYTHONDONTWRITEBYTECODE"
WITH_COMPLAINTS = 1  # the command's exit status where answers could not be read
GROWTH_PROMISE = 1.5  # the most that twice the class may take of memory


def figures() -> Iterator[Figure]:
    """Seconds for an answer, of plain numbers and of what people really type; memory of twice the
    class.
    """
    with TemporaryDirectory() as name:
        parts = "plain", "few", "mixed", "double"
        plain, few, mixed, double = (Path(name) / part for part in parts)
        write_class(plain, STUDENTS, 0.0)
        write_class(few, STUDENTS, FEW_ODD_SHARE)
        write_class(mixed, STUDENTS, ODD_SHARE)
        write_class(double, 2 * STUDENTS, ODD_SHARE)
        yield replace(speed(plain, "plain numbers", PLAIN_PROMISE), sought=PLAIN_SOUGHT)
        yield speed(few, "1 % not plain", FEW_PROMISE)
        yield speed(mixed, "10 % not plain", MIXED_PROMISE)
        for words, promise in COMMANDS.items():
            yield command_speed(plain, words, promise)
        yield small_class_figure(Path(name))
        single, twice = memory(mixed), memory(double)
        yield Figure(
            f"marking {2 * STUDENTS} students: memory against {STUDENTS}",
            twice,
            GROWTH_PROMISE * single,
            1,
            "MB",
        )


def small_class_figure(folder: Path) -> Figure:
    """What marking takes of memory for a class, and for one of a tenth of its size."""
    for students in SMALL:
        write_class(folder / str(students), students, ODD_SHARE)
    few, many = (memory(folder / str(students)) for students in SMALL)
    name = f"marking {SMALL[1]} students: memory against {SMALL[0]}"
    return Figure(name, many, few, 1 / SMALL_GROWTH_PROMISE, "MB")


def speed(folder: Path, kind: str, promise: float) -> Figure:
    """Seconds for an answer by `grade`, beside the loop's."""
    name = f"marking an answer, {STUDENTS} students, {kind}"
    return beside_loop(name, folder, lambda: ours(folder, STUDENTS), promise)


def command_speed(folder: Path, words: str, promise: float) -> Figure:
    """The same of a whole command."""
    name = f"{words.split(maxsplit=1)[0]} for an answer, {STUDENTS} students, the whole command"
    return beside_loop(name, folder, lambda: by_command(folder, words), promise)


def beside_loop(name: str, folder: Path, work: Callable[[], float], promise: float) -> Figure:
    """Seconds for an answer by some work and by the loop, the best of several: in turn, so that
    both meet the same neighbours.
    """
    runs = [(work(), loop(folder)) for _ in range(RUNS)]
    mine, peer = (min(times) for times in zip(*runs, strict=True))
    return Figure(name, mine, peer, promise)


def ours(folder: Path, students: int) -> float:
    """Seconds for an answer by `grade`."""
    return seconds_per_answer(
        lambda: grade(
            open_exam(folder / "EXAM"), folder / "answers.csv", folder / "MARKS", force=True
        ),
        students,
    )


def loop(folder: Path) -> float:
    """Seconds for an answer by the plain loop."""
    return seconds_per_answer(lambda: plain_loop(folder), STUDENTS)


def seconds_per_answer(work: Callable[[], object], students: int) -> float:
    """Processor seconds of one run for each answer."""
    start = process_time()
    work()
    return (process_time() - start) / (students * len(COLUMNS))


def plain_loop(folder: Path) -> None:
    """Marks a class as a script of a page does."""
    keys = read_keys(folder / "EXAM" / "key.jsonl")
    with (
        (folder / "answers.csv").open(encoding="utf-8", newline="") as sheet,
        (folder / "marks.csv").open("w", encoding="utf-8", newline="") as marks,
        (folder / "grades.csv").open("w", encoding="utf-8", newline="") as grades,
    ):
        each_answer, each_student = csv.writer(marks), csv.writer(grades)
        for row in csv.DictReader(sheet):
            total = 0
            for column, (value, relative, points) in keys[row["student"]].items():
                try:
                    right = math.isclose(float(row[column]), value, rel_tol=relative)
                except ValueError:
                    right = False
                got = points if right else 0
                total += got
                verdict = "right" if right else "wrong"
                each_answer.writerow([row["student"], column, row[column], verdict, got, points])
            each_student.writerow([row["student"], row["name"], total])


def read_keys(path: Path) -> dict[str, dict[str, tuple[float, float, int]]]:
    """Value, relative tolerance and points by student and column."""
    with path.open(encoding="utf-8") as lines:
        papers = map(json.loads, lines)
        return {
            paper["student"]: {
                f"{question['question']}.{ask}": (
                    key["value"],
                    key["tolerance"]["relative"],
                    key["points"],
                )
                for question in paper["questions"]
                for ask, key in question["asks"].items()
            }
            for paper in papers
        }


def by_command(folder: Path, words: str) -> float:
    """Seconds for an answer by a command, start and all. Raises what `memory` raises."""
    before = getrusage(RUSAGE_CHILDREN)
    memory(folder, words)
    after = getrusage(RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return seconds / (STUDENTS * len(COLUMNS))


def memory(folder: Path, words: str = GRADE) -> float:
    """The peak of a command in megabytes. Raises RuntimeError with what it said if it refused."""
    told = folder / "told.txt"
    with told.open("wb") as stream:
        command = [sys.executable, "-m", "kinegrade", *words.split(), "--force"]
        # Modules are kept compiled, as those of an installed program are
        kept = {name: text for name, text in os.environ.items() if name != _NOT_COMPILED}
        process = subprocess.Popen(command, stderr=stream, cwd=folder, env=kept)
        peak = peak_of_tree(process)
    if process.returncode not in (0, WITH_COMPLAINTS):
        raise RuntimeError(told.read_text(encoding="utf-8"))
    return peak
