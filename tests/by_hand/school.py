"""A class of students who know nothing of the program: its exam is made, typed and marked.

Everything goes through the command line and files: a bank and a roster are written, the exam's key
is read, a sheet of answers is typed, and the marks are read back as plain CSV.
"""

from __future__ import annotations

import csv
import json
import os
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from itertools import count
from pathlib import Path
from typing import Any

from tests.by_hand.pad import EXACT, Answers, Givens

ROOT = Path(__file__).parents[2]
COMPLAINTS = 1  # the exit status of a command that did its work and complains
NAMES_BETWEEN = " "  # in the column of mistakes
# The rules of exams, as banks state them: how many figures students carry, and what is right
FOUR_FIGURES = 'carry = 4\ntolerance = { relative = "1 %" }'
THREE_FIGURES = 'carry = 3\ntolerance = "honest"'


@dataclass(frozen=True)
class Question:
    """A question of one paper: its column's beginning, what is given, in which `units`, and what is
    right, to within `rooms`.
    """

    number: str
    template: str
    givens: Givens
    units: Mapping[str, str]
    right: Answers
    rooms: Answers
    points: Mapping[str, float]


@dataclass(frozen=True)
class Paper:
    """The paper of one student, its place in the class and its questions in order."""

    place: int
    student: str
    questions: tuple[Question, ...]

    @property
    def points(self) -> float:
        """The points of all its questions."""
        return sum(sum(question.points.values()) for question in self.questions)

    def question(self, number: str) -> Question:
        """The question of that number."""
        return next(question for question in self.questions if question.number == number)


@dataclass(frozen=True)
class Mark:
    """What became of one typed answer; `names` are the mistakes that it was recognised as."""

    paper: Paper
    question: Question
    ask: str
    typed: str
    points: float
    names: frozenset[str]

    @property
    def lost(self) -> float:
        """The points that it has not."""
        return self.question.points[self.ask] - self.points

    def __str__(self) -> str:
        right = self.question.right[self.ask]
        return (
            f"{self.question.template} {self.ask} of {self.paper.student}: {self.typed} typed,"
            f" {right:.6g} is right, {self.points:g} of {self.question.points[self.ask]:g} points,"
            f" named {sorted(self.names)}; given {dict(self.question.givens)}"
        )


Typed = Callable[[Paper, Question], Answers]  # what a student types for a question


@dataclass(frozen=True)
class Exam:
    """An exam that was made, with all its papers."""

    folder: Path
    papers: tuple[Paper, ...]
    runs: Iterator[int]

    def mark(
        self,
        typed: Typed,
        figures: int = EXACT,
        policy: str = "",
        *,
        complaints: bool = False,
    ) -> list[Mark]:
        """The marks of a class that types such answers with so many figures, by such a policy, or
        by the exam's own rules; none where nobody types anything. What is complained of is raised,
        unless that may be.
        """
        sheet = {
            (paper.student, f"{question.number}.{ask}"): write(value, figures)
            for paper in self.papers
            for question in paper.questions
            for ask, value in typed(paper, question).items()
            if ask in question.points
        }
        if not sheet:
            return []
        place = self.folder.parent / f"{self.folder.name}-{next(self.runs)}"
        place.mkdir()
        asked = self.papers[0].questions
        columns = [f"{question.number}.{ask}" for question in asked for ask in question.points]
        students = [paper.student for paper in self.papers]
        answers = _write_sheet(place / "answers.csv", students, columns, sheet)
        marking = ["grade", self.folder, answers, "-o", place / "MARKS"]
        if policy:
            rules = place / "policy.toml"
            rules.write_text(policy, encoding="utf-8")
            marking += ["--policy", rules]
        kinegrade(*marking, complaints=complaints)
        return list(self._read_marks(place / "MARKS" / "marks.csv", sheet))

    def _read_marks(self, file: Path, sheet: Mapping[tuple[str, str], str]) -> Iterator[Mark]:
        asked = {
            (paper.student, question.number): (paper, question)
            for paper in self.papers
            for question in paper.questions
        }
        with file.open(encoding="utf-8-sig", newline="") as lines:
            for row in csv.DictReader(lines):
                typed = sheet.get((row["student"], f"{row['question']}.{row['ask']}"))
                if typed is None:
                    continue
                paper, question = asked[row["student"], row["question"]]
                names = frozenset(filter(None, row["mistakes"].split(NAMES_BETWEEN)))
                yield Mark(paper, question, row["ask"], typed, float(row["points"]), names)


def make_exam(folder: Path, templates: Sequence[str], students: int, rule: str, words: str) -> Exam:
    """An exam of so many students, a question of each template with all its points."""
    folder.mkdir()
    questions = ", ".join(f'{{ template = "{name}" }}' for name in templates)
    bank = f'title = "By hand"\ncourse = "Mechanics"\ndate = "2026"\n{rule}\n'
    (folder / "bank.toml").write_text(f"{bank}questions = [{questions}]\n", encoding="utf-8")
    roster = "".join(f"s{place:03},Student {place}\n" for place in range(students))
    (folder / "roster.csv").write_text(f"student,name\n{roster}", encoding="utf-8")
    files = folder / "bank.toml", folder / "roster.csv"
    exam = folder / "EXAM"
    # some may have the same numbers
    made = "generate", *files, "-o", exam, "--reproducible", words, "--no-papers"
    kinegrade(*made, complaints=True)
    lines = (exam / "key.jsonl").read_text(encoding="utf-8").splitlines()
    return Exam(
        exam,
        tuple(_read_paper(place, json.loads(line)) for place, line in enumerate(lines)),
        count(),
    )


def write(value: float, figures: int) -> str:
    """A number as it is typed, with so many significant figures and never in powers of ten.

    >>> write(-1234.5, 3), write(0.08664, 3), write(2.0, 17)
    ('-1230', '0.0866', '2')
    """
    return f"{Decimal(f'{value:.{figures}g}'):f}"


def kinegrade(*arguments: str | Path, complaints: bool = False) -> None:
    """Run the command line as a user does; what it refuses is raised with what it said, and so is
    what it complains of, unless that may be.
    """
    command = list(map(str, arguments))
    status, said = run(command)
    if status not in ({0, COMPLAINTS} if complaints else {0}):
        raise RuntimeError(f"{' '.join(command)}: {said}")


def run(command: Sequence[str]) -> tuple[int, str]:
    """The status of a command in a process of its own, and what it says of faults; `make test` runs
    it in the process of the tests (`tests/one_process.py`).
    """
    path = os.pathsep.join(filter(None, (str(ROOT), os.environ.get("PYTHONPATH"))))
    done = subprocess.run(
        [sys.executable, "-m", "kinegrade", *command],
        capture_output=True,
        check=False,
        env={**os.environ, "PYTHONPATH": path},
    )
    return done.returncode, done.stderr.decode()


def _read_paper(place: int, line: Mapping[str, object]) -> Paper:
    """The paper of a line of the key."""
    questions: list[Mapping[str, object]] = line["questions"]  # type: ignore[assignment]
    return Paper(place, str(line["student"]), tuple(map(_read_question, questions)))


def _read_question(entry: Mapping[str, Any]) -> Question:
    parameters, asks = entry["parameters"], entry["asks"]
    return Question(
        entry["question"],
        entry["template"],
        {name: given["value"] for name, given in parameters.items()},
        {name: given["unit"] for name, given in parameters.items()},
        {name: ask["value"] for name, ask in asks.items()},
        {name: _read_room(ask) for name, ask in asks.items()},
        {name: ask["points"] for name, ask in asks.items()},
    )


def _read_room(ask: Mapping[str, Any]) -> float:
    stated = ask["tolerance"]
    return max(stated["relative"] * abs(ask["value"]), stated["absolute"])


def _write_sheet(
    file: Path,
    students: Sequence[str],
    columns: Sequence[str],
    sheet: Mapping[tuple[str, str], str],
) -> Path:
    """The sheet of answers, a row for each student; where nothing was typed it is blank."""
    with file.open("w", encoding="utf-8", newline="") as lines:
        writer = csv.writer(lines, lineterminator="\n")
        writer.writerow(["student", *columns])
        for student in students:
            writer.writerow([student, *(sheet.get((student, column), "") for column in columns)])
    return file
