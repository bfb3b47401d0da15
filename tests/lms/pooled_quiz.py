"""A Moodle that draws from a pool: read from the file that `kinegrade quiz --variants` wrote,
answered, downloaded.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from html import unescape
from pathlib import Path
from random import Random
from xml.etree import ElementTree

from tests.lms.response_files import csv_text

BOX = re.compile(r"\{[0-9]+:NUMERICAL:=([^:}]*):[^}]*(?:\\\}[^}]*)*\}")
TAG = re.compile(r"<img[^>]*alt=\"([^\"]*)\"[^>]*>|<[^>]*>")
IDENTITY = ("Last name", "First name", "ID number")
STATE = ("Finished", "1 May", "1 May", "2 mins", "5.00")
STATES = ("Status", "Started", "Completed", "Duration", "Grade/10.00")


@dataclass(frozen=True)
class Drawn:
    """A question of the pool as Moodle shows it, and the right answer to each of its boxes."""

    text: str
    right: tuple[str, ...]
    cloze: bool = True  # of boxes in its text; else a question of one number

    def cell(self, texts: Sequence[str]) -> str:
        """Answers to it, or its right ones, in the one cell of a download."""
        return parts(texts) if self.cloze else texts[0]


def pool(quiz: Path) -> Mapping[str, Sequence[Drawn]]:
    """The questions of a quiz by category."""
    found: dict[str, list[Drawn]] = {}
    category = ""
    for question in ElementTree.parse(quiz).getroot():
        if question.get("type") == "category":
            category = question.findtext("category/text") or ""
            continue
        html = question.findtext("questiontext/text") or ""
        cloze = question.get("type") == "cloze"
        boxes = tuple(found[1] for found in BOX.finditer(html))
        right = boxes if cloze else (question.findtext("answer/text") or "",)
        plain = TAG.sub(lambda tag: f"[{tag[1]}]" if tag[1] else " ", BOX.sub("_____", html))
        found.setdefault(category, []).append(Drawn(unescape(plain), right, cloze))
    return found


def attempt(quiz: Path, seed: int) -> list[Drawn]:
    """What a student is put: of every category one question, drawn by itself."""
    return [Random(f"{seed} {name}").choice(each) for name, each in pool(quiz).items()]


def download(
    rows: Sequence[tuple[str, Sequence[Drawn], Sequence[Sequence[str]]]],
    columns: Sequence[str] = ("Question", "Response", "Right answer"),
    decimal: str = ".",
) -> str:
    """The responses report: students with what they were put and what they typed; with these
    columns.
    """
    count = len(rows[0][1])
    header = [f"{name} {slot}" for slot in range(1, count + 1) for name in columns]
    lines = [(*IDENTITY, *STATES, *header)]
    for student, drawn, typed in rows:
        cells: list[str] = []
        for each, answers in zip(drawn, typed, strict=True):
            told = [value.replace(".", decimal) for value in each.right]
            whole = {
                "Question": each.text,
                "Response": each.cell(answers),
                "Right answer": each.cell(told),
            }
            cells += [whole[name] for name in columns]
        lines.append(("Wang", "Wei", student, *STATE, *cells))
    return csv_text(*lines)


def parts(texts: Sequence[str]) -> str:
    """Answers as Moodle puts those of a Cloze question into one cell."""
    return "; ".join(f"part {number}: {text}" for number, text in enumerate(texts, 1))


def perfect(drawn: Sequence[Drawn]) -> list[list[str]]:
    """The right answers to what was drawn, with the figures of a calculator."""
    return [[f"{float(value):.8g}" for value in each.right] for each in drawn]
