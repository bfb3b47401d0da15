"""An exam folder of any size, in the shape that `generate` writes, and its answer sheet: nothing of
it is solved.

Ten asks in four questions; each key has a surd, forty digits and eight to fifteen mistakes, as
those of the shipped templates have. Of the answers seven in ten are right, the others mistakes and
numbers that are simply wrong.
"""

from __future__ import annotations

import csv
import json
from collections.abc import Iterator
from pathlib import Path
from random import Random
from typing import Any

import msgspec

from kinegrade.exam.folder.columns.writing import write_columns
from kinegrade.exam.folder.contents import KEY, KEY_COLUMNS
from kinegrade.exam.folder.exam_folder import open_exam

ASKS = {
    "q1": ("v_B", "omega_AB", "a_B"),
    "q2": ("omega_II", "v_B", "v_C_x"),
    "q3": ("v_BC_y", "a_cor_y"),
    "q4": ("omega_AB", "alpha_AB"),
}
UNITS = {"v": "m/s", "a": "m/s^2", "omega": "rad/s", "alpha": "rad/s^2"}
# So nothing is worked out for these papers, and nothing follows from own answers
TEMPLATE = "of-no-mechanism"
COLUMNS = [f"{question}.{ask}" for question, asks in ASKS.items() for ask in asks]
MISTAKES = (
    "wrong-pole",
    "other-branch",
    "sine-for-cosine",
    "degrees-for-radians",
    "diameter-for-radius",
    "coriolis-dropped",
    "coriolis-halved",
    "coriolis-reversed",
    "path-normal-dropped",
    "relative-normal-dropped",
    "transport-for-absolute",
    "relative-for-absolute",
    "sense-reversed",
    "power-of-ten-up",
    "power-of-ten-down",
)
_FACTORS = {"sense-reversed": -1.0, "power-of-ten-up": 10.0, "power-of-ten-down": 0.1}
_PARAMETERS = {"r": "m", "k": "1", "phi": "deg", "omega": "rad/s", "alpha": "rad/s^2"}
_NOT_PLAIN = (
    "{comma}", "{number} "
               "{unit}", "{number}{unit}", "\u221a({square})", "", "-", "I do not "
                                                                        "know", "{number} cm/s",
)  # fmt: skip


def write_class(folder: Path, students: int, odd_share: float, seed: int = 1) -> None:
    """Writes folder/EXAM and folder/answers.csv; of the cells `odd_share` are no plain numbers."""
    random, exam = Random(seed), folder / "EXAM"
    exam.mkdir(parents=True)
    head = msgspec.json.encode(_head(students))
    (exam / "exam.json").write_bytes(msgspec.json.format(head, indent=1))  # as `generate` lays out
    with (
        (exam / KEY).open("w", encoding="utf-8") as keys,
        (folder / "answers.csv").open("w", encoding="utf-8", newline="") as sheet,
    ):
        answers = csv.writer(sheet, lineterminator="\n")
        answers.writerow(["student", "name", *COLUMNS])
        for number in range(students):
            paper = _paper(number, random)
            keys.write(f"{json.dumps(paper)}\n")
            typed = [_typed(entry, random, odd_share) for entry in _entries(paper)]
            answers.writerow([paper["student"], f"Student {number}", *typed])
    write_columns(exam / KEY_COLUMNS, exam / KEY, open_exam(exam).head)


def _head(students: int) -> dict[str, Any]:
    questions = [
        {
            "question": question,
            "template": TEMPLATE,
            "points": 3 * len(asks),
            "asks": [
                {"ask": ask, "unit": _unit(ask), "sign": "counter-clockwise positive", "points": 3}
                for ask in asks
            ],
        }
        for question, asks in ASKS.items()
    ]
    everybody = [
        {"student": f"{number:06}", "name": f"Student {number}", "paper": "K7Q2-41MB"}
        for number in range(students)
    ]
    return {
        "format": 1,
        "title": "A large class",
        "language": "en",
        "questions": questions,
        "students": everybody,
    }


def _unit(ask: str) -> str:
    return UNITS[ask.partition("_")[0]]


def _paper(number: int, random: Random) -> dict[str, Any]:
    questions = [
        {
            "question": question,
            "template": TEMPLATE,
            "parameters": {
                name: {"exact": "1/4", "value": 0.25, "unit": unit}
                for name, unit in _PARAMETERS.items()
            },
            "asks": {ask: _key(_unit(ask), random) for ask in asks},
        }
        for question, asks in ASKS.items()
    ]
    return {"student": f"{number:06}", "paper": "K7Q2-41MB", "questions": questions}


def _key(unit: str, random: Random) -> dict[str, Any]:
    value = random.choice((-1, 1)) * 10 ** random.uniform(-1, 2)
    mistakes = {
        name: f"{value * _FACTORS.get(name, random.uniform(0.2, 3)):.9g}"
        for name in sorted(random.sample(MISTAKES, random.randint(8, 15)))
    }
    return {
        "exact": "5*sqrt(2)/8 + 5*sqrt(6)/8 + 35*sqrt(14 - sqrt(3))/386",
        "value": value,
        "unit": unit,
        "decimal": f"{value!r}{random.randrange(10**22):022}",
        "tolerance": {"relative": 0.01, "absolute": 0},
        "points": 3,
        "mistakes": mistakes,
    }


def _entries(paper: dict[str, Any]) -> Iterator[dict[str, Any]]:
    for question in paper["questions"]:
        yield from question["asks"].values()


def _typed(entry: dict[str, Any], random: Random, odd_share: float) -> str:
    chance, number = random.random(), entry["value"]
    if chance > 0.85:
        number = float(random.choice(list(entry["mistakes"].values())))
    elif chance > 0.7:
        number *= random.uniform(1.02, 4)
    plain = f"{number:.{4 if abs(number) < 1 else 3 if abs(number) < 10 else 2}f}"
    if random.random() >= odd_share:
        return plain
    return random.choice(_NOT_PLAIN).format(
        comma=plain.replace(".", ","), number=plain, unit=entry["unit"], square=f"{number**2:.4f}"
    )
