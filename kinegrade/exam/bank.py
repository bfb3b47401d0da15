"""The exam blueprint: which questions are put, for how many points, and within which tolerance they are right.

    title  = { en = "Kinematics midterm", zh = "运动学期中测验" }
    course = { en = "Theoretical mechanics", zh = "理论力学" }
    tolerance = { relative = "1 %" }

    [[questions]]
    template = "slider-crank"                # a shipped template, or a file beside the bank: "mine.toml"
    asks = { v_B = 3, omega_AB = 2 }         # optional: what is asked, with points
    draw = { k = ["sqrt(3)", "2"] }          # optional: other domains for some parameters
    tolerance = { relative = "2 %" }         # optional: for this question
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from datetime import date
from fractions import Fraction
from pathlib import Path
from typing import Any

from kinegrade.errors import BankError, KinegradeError, did_you_mean
from kinegrade.exact.angle import Inexact
from kinegrade.exact.field import Field
from kinegrade.expression import read
from kinegrade.problem.assemble import parameter_value
from kinegrade.problem.domain import read_choices
from kinegrade.problem.library import load_template
from kinegrade.problem.reading import TOO_LARGE, shortened, too_large
from kinegrade.problem.statement import check_statements
from kinegrade.problem.template import Template, Translated

TEMPLATE_FILE = re.compile(r"[\w. -]{1,100}\.toml")
KEYS = {"title", "course", "date", "tolerance", "questions"}
QUESTION_KEYS = {"template", "asks", "draw", "tolerance"}
MAX_QUESTIONS, MAX_POINTS, MAX_BYTES = 50, 1000, 200_000
NUMBER = r"(\d{1,4}(?:\.\d{1,9})?)"  # few enough digits to pass through JSON unchanged
DECIMAL = re.compile(NUMBER, re.ASCII)
SHARE = re.compile(NUMBER + r"\s*(%?)", re.ASCII)


@dataclass(frozen=True)
class Tolerance:
    """Right within max(relative*|exact value|, absolute), the bounds included; absolute in the ask's unit."""

    relative: Fraction
    absolute: Fraction


@dataclass(frozen=True)
class BankAsk:
    """One quantity asked for."""

    name: str
    points: Fraction
    tolerance: Tolerance


@dataclass(frozen=True)
class BankQuestion:
    """One question: its template, what is asked, and domains that replace the template's."""

    identifier: str
    template: Template
    asks: tuple[BankAsk, ...]
    domains: Mapping[str, tuple[str, ...]]

    @property
    def points(self) -> Fraction:
        """The sum of the asks' points."""
        return sum((ask.points for ask in self.asks), Fraction(0))


@dataclass(frozen=True)
class Bank:
    """A blueprint; `text` is the file as it was read, kept with the exam."""

    title: Translated
    course: Translated
    date: str
    tolerance: Tolerance
    questions: tuple[BankQuestion, ...]
    text: str


def read_bank(path: Path) -> Bank:
    """The blueprint in a file. Raises BankError with all faults at once."""
    try:
        with path.open("rb") as file:
            data = file.read(MAX_BYTES + 1)
        if len(data) > MAX_BYTES:
            raise BankError(f"{path}: too large: at most {MAX_BYTES} bytes are read: give the path of a bank file")
        text = data.decode("utf-8-sig")
        table = tomllib.loads(text, parse_float=str)
    except OSError as error:
        raise BankError(f"{path}: cannot be read: {error.strerror}: give the path of a bank file") from error
    except (ValueError, RecursionError) as error:  # no UTF-8, no TOML, an integer of thousands of digits
        raise BankError(f"{path}: not readable as TOML in UTF-8: {error}: mend it, or give a bank file") from error
    if too_large(table):
        raise BankError(f"{path}: {TOO_LARGE}")
    return Reader(path, table, text).bank()


class Reader:
    """Reads one bank, collecting faults."""

    def __init__(self, path: Path, table: dict[str, Any], text: str) -> None:
        self.path, self.table, self.text = path, table, text
        self.faults: list[str] = []

    def fault(self, place: str, problem: str) -> None:
        """Note a fault."""
        place = f"{shortened(place)}: " if place else ""
        self.faults.append(f"{self.path}: {place}{shortened(problem)}")

    def bank(self) -> Bank:
        """The whole; raises BankError when anything is at fault."""
        self.unknown_keys("", self.table, KEYS)
        tolerance = self.tolerance("tolerance", self.table.get("tolerance"), Tolerance(Fraction(1, 100), Fraction(0)))
        entries = self.table.get("questions")
        if not isinstance(entries, list) or not 1 <= len(entries) <= MAX_QUESTIONS:
            self.fault("questions", f"expected 1 to {MAX_QUESTIONS} tables [[questions]]")
            entries = []
        questions = [self.question(number, entry, tolerance) for number, entry in enumerate(entries, start=1)]
        found = tuple(question for question in questions if question is not None)
        self.same_names(found)
        bank = Bank(self.translated("title"), self.translated("course"), self.date(), tolerance, found, self.text)
        if self.faults:
            raise BankError(*self.faults)
        return bank

    def unknown_keys(self, place: str, table: Mapping[str, Any], known: set[str]) -> None:
        """A fault for every key that is not known."""
        for key in sorted(set(table) - known):
            self.fault(place, f'unknown key "{key}": {did_you_mean(key, known)}')

    def translated(self, key: str) -> Translated:
        """A text in both languages; one text serves for both."""
        value = self.table.get(key)
        if isinstance(value, str) and value.strip():
            return Translated(value, value)
        if isinstance(value, dict) and set(value) == {"en", "zh"} and all(
                isinstance(text, str) and text.strip() for text in value.values()):
            return Translated(value["en"], value["zh"])
        self.fault(key, 'expected a text, or texts { en = "...", zh = "..." }')
        return Translated("", "")

    def date(self) -> str:
        """The date as it is printed; none prints nothing."""
        value = self.table.get("date", "")
        if not isinstance(value, str | date):
            self.fault("date", 'expected a text or a date, like "spring 2026" or 2026-05-01')
        return str(value)

    def same_names(self, questions: Iterable[BankQuestion]) -> None:
        """A fault where two different template files share a name: the exam folder keeps one file of a name."""
        texts: dict[str, str] = {}
        for question in questions:
            name, text = question.template.name, question.template.text
            if texts.setdefault(name, text) != text:
                self.fault(f"questions[{question.identifier[1:]}].template",
                           f'another template of this bank has the name "{name}": rename the file')

    def question(self, number: int, entry: Any, tolerance: Tolerance) -> BankQuestion | None:
        """One question, or None when its template cannot be had."""
        place = f"questions[{number}]"
        if not isinstance(entry, dict) or not isinstance(entry.get("template"), str):
            self.fault(place, 'expected a table with template = "..."')
            return None
        self.unknown_keys(place, entry, QUESTION_KEYS)
        template = self.template(place, entry["template"])
        if template is None:
            return None
        own = self.tolerance(f"{place}.tolerance", entry.get("tolerance"), tolerance)
        return BankQuestion(f"q{number}", template, self.asks(place, entry, template, own),
                            self.domains(place, entry, template))

    def template(self, place: str, name: str) -> Template | None:
        """A shipped template, or a file beside the bank."""
        if name.endswith(".toml") and not TEMPLATE_FILE.fullmatch(name):
            self.fault(f"{place}.template", f"{name!r:.60}: expected a file beside the bank, without folders")
            return None
        try:
            template = load_template(str(self.path.parent / name) if name.endswith(".toml") else name)
            check_statements(template)
        except KinegradeError as error:
            for problem in error.problems:
                self.fault(f"{place}.template", problem)
            return None
        return template

    def asks(self, place: str, entry: Mapping[str, Any], template: Template,
             tolerance: Tolerance) -> tuple[BankAsk, ...]:
        """What is asked: as the bank says, or everything the template gives points."""
        chosen = entry.get("asks", {name: template.asks[name].points for name in template.asked()})
        if not isinstance(chosen, dict) or not chosen:
            self.fault(f"{place}.asks", "expected a table of asks with their points, like { v_B = 3 }")
            return ()
        found = [self.ask(f"{place}.asks.{name}", name, value, template, tolerance) for name, value in chosen.items()]
        return tuple(ask for ask in found if ask is not None)

    def ask(self, place: str, name: str, value: Any, template: Template, tolerance: Tolerance) -> BankAsk | None:
        """One ask: points, or a table with points (default: the template's) and tolerance."""
        if name not in template.asks:
            self.fault(place, f'{template.name} has no ask "{name}": {did_you_mean(name, template.asks)}')
            return None
        table = value if isinstance(value, dict) else {"points": value}
        self.unknown_keys(place, table, {"points", "tolerance"})
        points = self.amount(f"{place}.points", table.get("points", template.asks[name].points))
        if points is not None and not 0 < points <= MAX_POINTS:
            self.fault(f"{place}.points", f"expected more than 0 and at most {MAX_POINTS}")
        own = self.tolerance(f"{place}.tolerance", table.get("tolerance"), tolerance)
        return BankAsk(name, points or Fraction(1), own)

    def domains(self, place: str, entry: Mapping[str, Any], template: Template) -> dict[str, tuple[str, ...]]:
        """Domains that replace the template's."""
        table = entry.get("draw", {})
        if not isinstance(table, dict):
            self.fault(f"{place}.draw", "expected a table like { k = [2, 3] }")
            return {}
        found = {}
        for name, draw in table.items():
            if name not in template.parameters:
                self.fault(f"{place}.draw", f'no parameter "{name}": {did_you_mean(name, template.parameters)}')
                continue
            try:
                found[name] = read_choices(draw)
                for text in found[name]:
                    with suppress(Inexact):  # then it is a number all the same
                        parameter_value(template.parameters[name], read(text), Field())
            except KinegradeError as error:
                self.fault(f"{place}.draw.{name}", error.problems[0])
        return found

    def tolerance(self, place: str, value: Any, default: Tolerance) -> Tolerance:
        """{ relative = "1 %", absolute = 0.01 }, each optional."""
        if value is None:
            return default
        if not isinstance(value, dict):
            self.fault(place, 'expected a table like { relative = "1 %" } or { absolute = 0.01 }')
            return default
        self.unknown_keys(place, value, {"relative", "absolute"})
        relative = self.share(f"{place}.relative", value.get("relative", 0))
        absolute = self.amount(f"{place}.absolute", value.get("absolute", 0))
        if relative is None or absolute is None:
            return default
        if relative >= 1 or relative + absolute == 0:
            self.fault(place, "expected a tolerance above zero, the relative one below 100 %")
        return Tolerance(relative, absolute)

    def amount(self, place: str, value: Any) -> Fraction | None:
        """A number of zero or more, exactly."""
        match = DECIMAL.fullmatch(written(value))
        if match is None:
            self.fault(place, "expected a number like 0.01, at most 4 digits before the point and 9 after it, "
                              f"not {written(value)!r}")
            return None
        return Fraction(match[1])

    def share(self, place: str, value: Any) -> Fraction | None:
        """A number of zero or more, or a percentage as text, exactly."""
        match = SHARE.fullmatch(written(value))
        if match is None:
            self.fault(place, f'expected a text like "1 %" or a number like 0.01, not {written(value)!r}')
            return None
        return Fraction(match[1]) / (100 if match[2] else 1)


def written(value: Any) -> str:
    """A number or a text as it stands in the file, cut where it is long; of anything else its kind."""
    if isinstance(value, bool) or not isinstance(value, int | str):
        return f"a {type(value).__name__}"
    return str(value).strip()[:40]
