"""The demonstration class types its answers: banks/demo-answers.csv, made from an exam folder.

    python -m tests.demo.type_answers demo/EXAM banks/demo-answers.csv

Every student knows a share of the answers and types them in an own manner; the rest are the slips
that instructors know. What is rare in one exam (a cell nobody can read, a row twice, a stranger) is
planted. Each choice comes from a seed, the student and the column, so that one answer more changes
no other: the same exam gives the same bytes. `make demo-answers` runs this after templates have
changed.
"""

from __future__ import annotations

import csv
import json
import sys
from bisect import bisect
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from decimal import Decimal
from itertools import accumulate
from pathlib import Path
from random import Random
from typing import TypeVar

SEED = "class of the demonstration"
REMARKS = "remarks"
FULL_WIDTH = str.maketrans(
    {**{str(digit): chr(0xFF10 + digit) for digit in range(10)}, ".": "．", "-": "－"}
)
DEGREES = Decimal("57.29577951308232")

ABSENT = "0241334"
TWICE = "20220524"
ZEROS_EATEN = "0241306"
STRANGER = ("20220999", "Alex Morgan")
UNREADABLE: dict[tuple[str, str], str] = {
    ("0241205", "q1.a_B"): "see sheet",
    ("0241291", "q4.omega_AB"): "5-3",
    ("20220341", "q3.a_BC_y"): "12 or 14",
    ("20220421", "q3.a_cor_y"): "1 23 4,5",
    ("20220462", "q2.v_B"): "=1+1",
    ("PB22000417", "q1.omega_AB"): "?",
    ("s1830227", "q4.v_O"): "1/2√3",
}
WRONG_UNIT: dict[tuple[str, str], str] = {("u7204431", "q2.omega_II"): "7.5 m/s"}
# A decimal comma, as in the same student's other answers
CERTAIN: dict[tuple[str, str], str] = {
    ("0241289", "q1.a_B"): "-2,640 m/s^2",
    ("0241289", "q4.alpha_AB"): "22,836",
    ("20220368", "q3.a_cor_y"): "1,234",
}
DOUBTFUL: dict[tuple[str, str], str] = {
    ("20220518", "q2.v_C_x"): "8.887",
    ("0241211", "q1.a_B"): "6.416",
    ("0241211", "q3.a_cor_y"): "9.021",
}
NOTES: Mapping[str, str] = {
    "0241211": "第 4 题时间不够",
    "20220329": "q3: rho read off the figure, sorry",
    "u7204485": 'wrote "left" for the minus sign on paper',
}


@dataclass(frozen=True)
class Key:
    """What is right for one ask of one student, in `unit`."""

    value: Decimal
    unit: str


@dataclass(frozen=True)
class Answer:
    """A typed cell, how its number came about ("right" where nothing went wrong) and how that is
    spelled.
    """

    text: str
    slip: str
    spelling: str


@dataclass(frozen=True)
class Row:
    """A line of the sheet; `planted` says what is odd about it, "" where nothing is."""

    student: str
    name: str
    answers: Mapping[str, Answer]
    note: str = ""
    planted: str = ""


Choice = TypeVar("Choice")
Weighted = Mapping[str, tuple[float, Choice]]


def significant(value: Decimal, digits: int) -> str:
    """The value with so many significant digits, never in powers of ten.

    >>> significant(Decimal("-0.08664"), 3), significant(Decimal("1234.5"), 3)
    ('-0.0866', '1230')
    """
    return f"{Decimal(f'{value:.{digits}g}'):f}"


def without_zero(text: str) -> str:
    """A decimal without the zero before its point.

    >>> without_zero("-0.866"), without_zero("10.1")
    ('-.866', '10.1')
    """
    return text.replace("0.", ".", 1) if text.lstrip("-").startswith("0.") else text


SPELLINGS: Weighted[Callable[[Decimal, str], str]] = {
    "four digits": (34, lambda value, unit: significant(value, 4)),
    "five digits": (14, lambda value, unit: significant(value, 5)),
    "three digits": (12, lambda value, unit: significant(value, 3)),
    # three digits: with four, "1,234" might be thousands, and CERTAIN plants the only one
    "decimal comma": (10, lambda value, unit: significant(value, 3).replace(".", ",")),
    "no leading zero": (5, lambda value, unit: without_zero(significant(value, 4))),
    "comma, no leading zero": (
        4,
        lambda value, unit: without_zero(significant(value, 3)).replace(".", ","),
    ),
    "unit": (6, lambda value, unit: f"{significant(value, 4)} {unit}"),
    "unit as printed": (4, lambda value, unit: significant(value, 4) + unit.replace("^2", "²")),
    "full width": (3, lambda value, unit: significant(value, 4).translate(FULL_WIDTH)),
    "minus sign": (3, lambda value, unit: significant(value, 4).replace("-", "\u2212")),
    "blanks": (3, lambda value, unit: f" {significant(value, 4)}\u00a0 "),
    "scientific": (2, lambda value, unit: f"{value:.3e}".lower()),
}
SLIPS: Weighted[Callable[[Decimal], Decimal]] = {
    "sign": (24, lambda value: -value),
    "arithmetic": (27, lambda value: value * Decimal("1.17")),
    "twice": (12, lambda value: 2 * value),
    "half": (10, lambda value: value / 2),
    "degrees": (7, lambda value: value * DEGREES),
    "blank": (20, lambda value: value),
}
TWO_DIGITS_SHARE = 0.06  # of the answers that would be right; whether they still are is luck
OWN_SPELLING_SHARE = 0.6  # most people keep to one way of typing


def read_keys(exam: Path) -> dict[str, dict[str, Key]]:
    """What is right, by student and column."""
    papers = [
        json.loads(line) for line in (exam / "key.jsonl").read_text(encoding="utf-8").splitlines()
    ]
    return {
        paper["student"]: {
            f"{question['question']}.{name}": Key(Decimal(ask["decimal"]), ask["unit"])
            for question in paper["questions"]
            for name, ask in question["asks"].items()
        }
        for paper in papers
    }


def chance(*address: str) -> Random:
    """The chances at an address; only `random()` is drawn from it, which no Python changes."""
    return Random("\n".join((SEED, *address)))


def one_of(choices: Weighted[Choice], draw: float) -> tuple[str, Choice]:
    """The name and the thing that a draw from [0, 1) falls on, by the weights."""
    sums = list(accumulate(weight for weight, _ in choices.values()))
    name = list(choices)[bisect(sums, draw * sums[-1])]
    return name, choices[name][1]


def typed(student: str, column: str, key: Key) -> Answer:
    """What a student types for one ask."""
    planted = (UNREADABLE | WRONG_UNIT | CERTAIN | DOUBTFUL).get((student, column))
    if planted:
        return Answer(planted, "planted", "planted")
    own, cell = chance(student), chance(student, column)
    skill = 0.2 + 0.8 * (own.random() + own.random()) / 2
    slip, value = slipped(key, cell, skill)
    if slip == "blank":
        return Answer("", slip, "blank")
    if slip == "two digits":
        return Answer(significant(value, 2), slip, "two digits")
    spelling, spell = one_of(
        SPELLINGS, own.random() if cell.random() < OWN_SPELLING_SHARE else cell.random()
    )
    return Answer(spell(value, key.unit), slip, spelling)


def slipped(key: Key, cell: Random, skill: float) -> tuple[str, Decimal]:
    """What becomes of the right value; a zero has no sign and no double, so it is simply known."""
    if key.value == 0:
        return "right", key.value
    if cell.random() < skill:
        return ("two digits" if cell.random() < TWO_DIGITS_SHARE else "right"), key.value
    known = {
        name: entry
        for name, entry in SLIPS.items()
        if name != "degrees" or key.unit.startswith("rad")
    }
    slip, change = one_of(known, cell.random())
    return slip, change(key.value)


def class_rows(exam: Path) -> Iterator[Row]:
    """The rows in the order in which the sheets came in, those that are planted among them."""
    keys = read_keys(exam)
    names = read_names(exam)
    for student in sorted(keys, key=lambda student: chance(student, "order").random()):
        answers = {column: typed(student, column, key) for column, key in keys[student].items()}
        row = Row(student, names[student], answers, NOTES.get(student, ""))
        yield from handed_in(row, keys[student])
    answers = {column: typed(STRANGER[0], column, key) for column, key in keys[TWICE].items()}
    yield Row(*STRANGER, answers, planted="stranger")


def handed_in(row: Row, keys: Mapping[str, Key]) -> Iterator[Row]:
    """What comes in from one student: a row, two, or none."""
    if row.student == TWICE:
        first = {
            column: typed(f"{TWICE}, first attempt", column, key) for column, key in keys.items()
        }
        yield replace(row, answers=first, planted="first attempt")
    if row.student == ZEROS_EATEN:
        yield replace(row, student=ZEROS_EATEN.lstrip("0"), planted="zeros eaten")
    elif row.student != ABSENT:
        yield row


def read_names(exam: Path) -> dict[str, str]:
    """The names on the blank sheet, by student."""
    with (exam / "answers.csv").open(encoding="utf-8-sig", newline="") as sheet:
        return {line["student"]: line["name"] for line in csv.DictReader(sheet)}


def write_answers(exam: Path, output: Path) -> None:
    """Writes the sheet as the class hands it in."""
    rows = list(class_rows(exam))
    columns = list(rows[0].answers)
    lines = (
        [row.student, row.name, *(row.answers[column].text for column in columns), row.note]
        for row in rows
    )
    with output.open("w", encoding="utf-8", newline="") as sheet:
        csv.writer(sheet, lineterminator="\n").writerows(
            [["student", "name", *columns, REMARKS], *lines]
        )


if __name__ == "__main__":
    write_answers(Path(sys.argv[1]), Path(sys.argv[2]))
