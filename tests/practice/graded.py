"""What `kinegrade grade` says of answers, beside what the page says of the same texts: an exam with
the draws of a practice sheet, drawn from the same words.
"""

from __future__ import annotations

import csv
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from random import Random

import kinegrade
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.follow_through import FollowThrough
from kinegrade.language import ENGLISH
from kinegrade.marks_folder.rows import MarkedAnswer
from kinegrade.practice.document import PracticeQuestion, PracticeSheet
from kinegrade.practice.making import make_practice_sheet
from tests.practice.node import Shown, Typed
from tests.small_class import kinegrade as command

WORDS, EXAM = "practice", "EXAM"
Judge = Callable[[PracticeSheet, Typed], list[list[list[Shown]]]]


@dataclass(frozen=True)
class Pair:
    """A text, what the exam's marks say of it, and what the page says; `is_cut_off` where the page
    says that it cannot tell what follows.
    """

    where: str
    typed: str
    marked: str
    shown: str
    is_cut_off: bool

    @property
    def agrees(self) -> bool:
        """Whether both say the same, but for what the page says it cannot tell."""
        untold = self.is_cut_off and "follow-through" in (self.marked, self.shown)
        return self.marked == self.shown or untold


@dataclass(frozen=True)
class Marked:
    """What was typed for the draws of a sheet (a question, a draw, an ask), with its marks."""

    bank: str
    sheet: PracticeSheet
    typed: Typed
    answers: Mapping[tuple[str, str, str], MarkedAnswer]

    def compare(self, judge: Judge) -> list[Pair]:
        """The marks beside what the page says; mistakes are named behind verdicts."""
        shown = judge(self.sheet, self.typed)
        return [
            Pair(
                f"{self.bank} {name_draw(number)} q{place + 1}.{ask.name}",
                self.typed[place][number][row],
                _describe(self.answers[name_draw(number), f"q{place + 1}", ask.name]),
                " ".join((said.kind, *said.mistakes)),
                said.is_cut_off,
            )
            for place, question in enumerate(self.sheet.questions)
            for number in range(len(question.draws))
            for ask, row, said in zip(
                question.asks, range(len(question.asks)), shown[place][number], strict=True
            )
        ]


def mark_answers(bank: Path, folder: Path, draws: int, seed: int) -> Marked:
    """Answers to so many draws of a bank, or to as many as there are, marked by the command line:
    right, rounded, mistaken, carried on, nonsense.
    """
    random = Random(seed)

    def type_answers(question: PracticeQuestion, number: int, carrying: Carrying) -> Iterator[str]:
        return _type_anything(question, number, carrying, random)

    return mark_typed(bank, folder, draws, type_answers)


def mark_typed(bank: Path, folder: Path, draws: int, type_answers: Typing) -> Marked:
    """What is typed for so many draws of a bank, or for as many as there are, marked by the command
    line.
    """
    blueprint = kinegrade.Bank.read(bank).blueprint
    sheet = make_practice_sheet(blueprint, draws, WORDS, ENGLISH).sheet
    fewest = min(len(question.draws) for question in sheet.questions)
    if fewest < draws:
        return mark_typed(bank, folder, fewest, type_answers)
    _generate(bank, folder, draws)
    follows = FollowThrough(open_exam(folder / EXAM))
    typed = [
        [
            list(type_answers(question, number, Carrying(follows, number, place)))
            for number in range(len(question.draws))
        ]
        for place, question in enumerate(sheet.questions)
    ]
    marked = _mark(folder, sheet, typed)
    answers = {(each.student, each.question, each.ask): each for each in marked}
    return Marked(bank.name, sheet, typed, answers)


def _describe(answer: MarkedAnswer) -> str:
    """The verdict; that a whole paper is another's is told by no page."""
    verdict = "follow-through" if answer.judged == "another paper" else answer.judged
    return " ".join((verdict, *answer.mistakes))


def _generate(bank: Path, folder: Path, draws: int) -> None:
    """The exam with the draws of the sheet, by the command line."""
    names = [name_draw(number) for number in range(draws)]
    roster = folder / "roster.csv"
    rows_of = "".join(f"{name},{name}\n" for name in names)
    roster.write_text(f"student,name\n{rows_of}", encoding="utf-8")
    exam = folder / EXAM
    made = command("generate", bank, roster, "-o", exam, "--reproducible", WORDS, "--jobs", "1")
    assert made.exit_code < 2, made.stderr


def _mark(folder: Path, sheet: PracticeSheet, typed: Typed) -> Iterator[MarkedAnswer]:
    """The marks of the answers, by the command line."""
    answers = folder / "answers.csv"
    with answers.open("w", encoding="utf-8", newline="") as file:
        rows = csv.writer(file)
        asked = enumerate(sheet.questions, 1)
        rows.writerow(["student", *(f"q{q}.{ask.name}" for q, each in asked for ask in each.asks)])
        for number in range(len(typed[0])):
            cells = (cell for question in typed for cell in question[number])
            rows.writerow([name_draw(number), *cells])
    marks = folder / "MARKS"
    done = command("grade", folder / EXAM, answers, "-o", marks)
    assert done.exit_code < 2, done.stderr
    return iter(kinegrade.open_marks(marks).answers())


def name_draw(number: int) -> str:
    """Whose paper has a draw."""
    return f"draw-{number + 1}"


@dataclass(frozen=True)
class Carrying:
    """What follows by the marking, not by the page, from the answers typed for a question."""

    follows: FollowThrough
    number: int
    place: int

    def list_values(self, own: Mapping[str, float], later: str) -> Iterator[float]:
        """The values for a later ask: from each own answer alone."""
        for ask, value in own.items():
            found = self.follows(
                name_draw(self.number), f"q{self.place + 1}", {ask: Fraction(value)}, later
            )
            yield from map(float, found)


Typing = Callable[[PracticeQuestion, int, Carrying], Iterator[str]]


def _type_anything(
    question: PracticeQuestion, number: int, carrying: Carrying, random: Random
) -> Iterator[str]:
    """What a student types for a draw."""
    draw, own = question.draws[number], dict[str, float]()
    for row, ask in enumerate(question.asks):
        shown, _, ratios = draw.keys[row]
        right = float(shown)
        known = [float(ratio) * (right or 1.0) for ratio in ratios.split(" ") if ratio]
        value = random.choice((
            right, right, right * 1.004, right * random.uniform(0.4, 1.8), -right,
            *(random.choice(known) for _ in range(2) if known), *carrying.list_values(own, ask.name),
        ))  # fmt: skip
        own[ask.name] = value
        yield _write(value, ask.unit, random)


def _write(value: float, unit: str, random: Random) -> str:
    """A number as somebody writes it, or something else."""
    number = f"{value:.5g}"
    spelled = "" if unit == "1" else f" {unit}"
    return random.choice((
        number, number, f"{value:.4g}", f"{number}{spelled}", number.replace("-", "−"),
        f"{value:.6e}", f"x = {number}{spelled}", f"about {number}", f"{value:.2g}", "", "?",
        f"{number} kg", f"{number} m s", f"{number} clockwise",
    ))  # fmt: skip
