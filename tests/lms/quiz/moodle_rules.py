"""Moodle XML read the way Moodle reads it, and everything that Moodle would refuse or silently
spoil.
"""

from __future__ import annotations

import re
from base64 import b64decode
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from urllib.parse import unquote
from xml.etree import ElementTree

FRACTIONS = set(
    map(
        Fraction,
        (
            "100",
            "90",
            "83.33333",
            "80",
            "75",
            "70",
            "66.66667",
            "60",
            "50",
            "40",
            "33.33333",
            "30",
            "25",
            "20",
            "16.66667",
            "14.28571",
            "12.5",
            "11.11111",
            "10",
            "5",
            "0",
        ),
    )
)
WIDTH = len("-1.2345678901234E+300")
NUMBER = r"-?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?"
BOX = re.compile(r"\{([0-9]*):(?:NUMERICAL|NM):(.*?)(?<!\\)\}", re.DOTALL)
ANYTHING_LIKE_A_BOX = re.compile(r"\{(?:[0-9]*:|#)")
ALTERNATIVE = re.compile(rf"(=|%({NUMBER})%)({NUMBER}):({NUMBER})(?:#(.*))?", re.DOTALL)
ADDRESS = re.compile(r'src="@@PLUGINFILE@@/([^"]+)"')


@dataclass(frozen=True)
class Answer:
    value: Fraction
    room: Fraction
    share: Fraction
    feedback: str

    @property
    def interval(self) -> tuple[Fraction, Fraction]:
        return self.value - self.room, self.value + self.room

    @property
    def never(self) -> bool:
        """Whether nobody types such a number."""
        return abs(self.value) > 10**100

    def takes(self, typed: float) -> bool:
        """Whether Moodle takes a number for this answer: in doubles, with its slack of the
        fourteenth digit.
        """
        value, room = float(self.value), float(self.room)
        slack = 1e-14 * max(room, abs(value), 1e-14)
        return value - (room + slack) <= typed <= value + (room + slack)


def stored(number: Fraction) -> str:
    """A number as PHP turns it into a text that is kept: to fourteen significant digits."""
    mantissa, _, exponent = f"{float(number):.13E}".partition("E")
    power = int(exponent)
    if -5 < power < 14:
        return f"{Decimal(f'{float(number):.14G}'):f}"
    digits = mantissa.rstrip("0").rstrip(".")
    return f"{digits if '.' in digits else digits + '.0'}E{power:+d}"


def box_width(found: tuple[Answer, ...]) -> int:
    """By how many characters Moodle sizes a box: the longest answer that it keeps."""
    return max(len(stored(answer.value)) for answer in found)


@dataclass(frozen=True)
class Question:
    kind: str
    category: str
    name: str
    text: str
    identifier: str
    feedback: str
    tags: tuple[str, ...]
    files: dict[str, bytes]  # of the text; Moodle keeps those of the feedback apart
    feedback_files: dict[str, bytes]
    boxes: tuple[tuple[Fraction, tuple[Answer, ...]], ...]  # marks and answers


def read(content: str) -> list[Question]:
    """The questions of a file with their categories."""
    category, found = "", []
    for element in ElementTree.fromstring(content):
        if element.get("type") == "category":
            category = text_of(element, "category/text")
        else:
            found.append(question(element, category))
    return found


def question(element: ElementTree.Element, category: str) -> Question:
    text = text_of(element, "questiontext/text")
    kind = element.get("type", "")
    boxes = (
        cloze_boxes(text)
        if kind == "cloze"
        else ((Fraction(text_of(element, "defaultgrade")), answers(element)),)
    )
    tags = tuple(tag.text or "" for tag in element.findall("tags/tag/text"))
    return Question(
        kind,
        category,
        text_of(element, "name/text"),
        text,
        text_of(element, "idnumber"),
        text_of(element, "generalfeedback/text"),
        tags,
        files_of(element, "questiontext"),
        files_of(element, "generalfeedback"),
        boxes,
    )


def files_of(element: ElementTree.Element, text: str) -> dict[str, bytes]:
    return {
        file.get("name", ""): b64decode(file.text or "", validate=True)
        for file in element.findall(f"{text}/file")
    }


def text_of(element: ElementTree.Element, path: str) -> str:
    return element.findtext(path) or ""


def answers(element: ElementTree.Element) -> tuple[Answer, ...]:
    return tuple(
        Answer(
            number(text_of(answer, "text")),
            number(text_of(answer, "tolerance")),
            number(answer.get("fraction", "")),
            text_of(answer, "feedback/text"),
        )
        for answer in element.findall("answer")
    )


def cloze_boxes(text: str) -> tuple[tuple[Fraction, tuple[Answer, ...]], ...]:
    return tuple(
        (Fraction(mark or 1), tuple(alternatives(inside))) for mark, inside in BOX.findall(text)
    )


def alternatives(inside: str) -> Iterator[Answer]:
    for alternative in re.split(r"(?<!\\)~", inside):
        read_as = ALTERNATIVE.fullmatch(alternative)
        if read_as is None:
            raise ValueError(f"no alternative of a numerical box: {alternative}")
        share = Fraction(100) if read_as[1] == "=" else number(read_as[2])
        feedback = (read_as[5] or "").replace(r"\}", "}").replace(r"\#", "#")
        yield Answer(number(read_as[3]), number(read_as[4]), share, feedback)


def number(text: str) -> Fraction:
    """A number as Moodle stores it; with a comma, a unit or a blank it would be another one."""
    if not re.fullmatch(NUMBER, text):
        raise ValueError(f"Moodle would store another number: {text!r}")
    return Fraction(text)


def right(found: tuple[Answer, ...], typed: Fraction) -> Fraction:
    """The share that a typed number gets: that of the first answer that fits."""
    taken = first(found, typed)
    return Fraction(0) if taken is None else taken.share


def first(found: tuple[Answer, ...], typed: Fraction) -> Answer | None:
    """The answer that Moodle takes a typed number for, and whose sentence it shows."""
    return next((answer for answer in found if answer.takes(float(typed))), None)


def faults(content: str) -> list[str]:
    """What Moodle would refuse or spoil; nothing as a rule."""
    questions = read(content)
    found = [] if questions else ["a quiz without questions is an exception"]
    if "<!" in content.replace("<![CDATA[", ""):
        found.append("a declaration or entity")
    found += [
        f"the name {name} comes {count} times"
        for name, count in Counter((one.category, one.name) for one in questions).items()
        if count > 1
    ]
    found += [
        f"{place} loses its idnumber"
        for place, count in Counter((one.category, one.identifier) for one in questions).items()
        if count > 1
    ]
    return found + [f"{one.name}: {fault}" for one in questions for fault in faults_of(one)]


def faults_of(one: Question) -> Iterator[str]:
    if not one.category.startswith("$course$/top/") or any(
        not 0 < len(part) < 250 for part in one.category.split("/")
    ):
        yield f"category {one.category}"
    if not 0 < len(one.name) < 250 or not 0 < len(one.identifier) <= 100:
        yield "name or idnumber empty or cut"
    for text, files in ((one.text, one.files), (one.feedback, one.feedback_files)):
        addresses = {unquote(address) for address in ADDRESS.findall(text)}
        if addresses != set(files) or text.count("@@PLUGINFILE@@") != len(addresses):
            yield f"files {set(files)} for {addresses}"
        for content in files.values():
            ElementTree.fromstring(content)
    ElementTree.fromstring(f"<div>{BOX.sub('', one.text)}</div>")
    if one.kind == "cloze" and len(ANYTHING_LIKE_A_BOX.findall(one.text)) != len(one.boxes):
        yield "something else looks like a box"
    if not one.boxes:
        yield "no embedded answer"
    for mark, found in one.boxes:
        yield from faults_of_box(one, mark, found)


def faults_of_box(one: Question, mark: Fraction, found: tuple[Answer, ...]) -> Iterator[str]:
    if one.kind == "cloze" and mark.denominator != 1:
        yield f"mark {mark}"
    if not found or found[0].share != 100:
        yield "the first answer is not right"
    yield from (f"share {answer.share}" for answer in found if answer.share not in FRACTIONS)
    wrong = [answer.interval for answer in found if answer.share < 100]
    for place, (low, high) in enumerate(wrong):
        if any(before[0] <= low and high <= before[1] for before in wrong[:place]):
            yield "a wide answer hides a narrow one"
    if one.kind == "cloze" and (box_width(found) != WIDTH or not found[-1].never):
        yield "the width of the box tells the length of the number"
    for answer in found:
        if any(Fraction(stored(kept)) != kept for kept in (answer.value, answer.room)):
            yield f"Moodle keeps another number than {answer.value} or {answer.room}"
    if any(answer.room < 0 for answer in found):
        yield "a negative tolerance"
