"""Single values of a bank's file: texts in two languages, whole numbers, amounts and tolerances,
read exactly.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from datetime import date
from fractions import Fraction
from pathlib import Path
from typing import Any

from kinegrade.errors import did_you_mean, misspelt, short_line
from kinegrade.language import LANGUAGES
from kinegrade.problem.template import Translated
from kinegrade.problem.tolerance import Tolerance

NUMBER = r"(\d{1,4}(?:\.\d{1,9})?)"  # few enough digits to pass through JSON unchanged
DECIMAL = re.compile(NUMBER, re.ASCII)
MOST_FIGURES = 6  # as many as the key prints
SHARE = re.compile(NUMBER + r"\s*(%?)", re.ASCII)


class Values:
    """Reads values of one file, collecting its faults; what is missing under a misspelt key is not
    one more.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self.faults: list[str] = []
        self.misspelt: set[str] = set()

    def fault(self, place: str, problem: str) -> None:
        """Note a fault."""
        if place in self.misspelt:
            return
        place = f"{short_line(place)}: " if place else ""
        self.faults.append(f"{self.path}: {place}{short_line(problem)}")

    def unknown_keys(self, place: str, table: Mapping[str, Any], known: Iterable[str]) -> None:
        """A fault for every key that is not known; the one that it was meant to be is not missed
        any more.
        """
        known = list(known)
        unknown = sorted(set(table) - set(known))
        for key in unknown:
            self.fault(place, f'unknown key "{key}": {did_you_mean(key, known)}')
        before = f"{place}." if place else ""
        self.misspelt.update(f"{before}{key}" for key in misspelt(unknown, set(known) - set(table)))

    def translated(self, place: str, value: Any) -> Translated:
        """A text in both languages; one text serves for both."""
        if isinstance(value, str) and value.strip():
            return Translated(value, value)
        if (
            isinstance(value, dict)
            and set(value) == set(LANGUAGES)
            and all(isinstance(text, str) and text.strip() for text in value.values())
        ):
            return Translated(value["en"], value["zh"])
        self.fault(place, 'expected a text, or texts { en = "...", zh = "..." }')
        return Translated("", "")

    def date(self, place: str, value: Any) -> str:
        """A date as it is printed."""
        if not isinstance(value, str | date):
            self.fault(place, 'expected a text or a date, like "spring 2026" or 2026-05-01')
        return str(value)

    def flag(self, place: str, value: Any) -> bool:
        """True or false."""
        if not isinstance(value, bool):
            self.fault(place, f"expected true or false, not {written(value)!r}")
        return value is True

    def whole(self, place: str, value: Any, least: int, most: int) -> int:
        """A whole number within bounds; after a fault the least one, with which reading goes on."""
        if isinstance(value, int) and not isinstance(value, bool) and least <= value <= most:
            return value
        self.fault(place, f"expected a whole number from {least} to {most}, not {written(value)!r}")
        return least

    def tolerance(self, place: str, value: Any, default: Tolerance) -> Tolerance:
        """{ relative = "1 %", absolute = 0.01, figures = 3 }, each optional; what gives most room
        holds.
        """
        if value is None:
            return default
        if not isinstance(value, dict):
            self.fault(
                place,
                'expected a table like { relative = "1 %" }, { absolute = 0.01 } or { figures = 3 '
                "}",
            )
            return default
        known = ("relative", "absolute", "figures")
        self.unknown_keys(place, value, known)
        if value and set(value).isdisjoint(known):
            return default
        relative = self.share(f"{place}.relative", value.get("relative", 0))
        absolute = self.amount(f"{place}.absolute", value.get("absolute", 0))
        figures = (
            self.whole(f"{place}.figures", value["figures"], 2, MOST_FIGURES)
            if "figures" in value
            else None
        )
        if relative is None or absolute is None:
            return default
        if relative >= 1 or (relative + absolute == 0 and figures is None):
            self.fault(place, "expected a tolerance above zero, the relative one below 100 %")
        return Tolerance(relative, absolute, figures)

    def amount(self, place: str, value: Any) -> Fraction | None:
        """A number of zero or more, exactly."""
        match = DECIMAL.fullmatch(written(value))
        if match is None:
            self.fault(
                place,
                "expected a number like 0.01, at most 4 digits before the point and 9 after it, "
                f"not {written(value)!r}",
            )
            return None
        return Fraction(match[1])

    def share(self, place: str, value: Any) -> Fraction | None:
        """A number of zero or more, or a percentage as text, exactly."""
        match = SHARE.fullmatch(written(value))
        if match is None:
            self.fault(
                place, f'expected a text like "1 %" or a number like 0.01, not {written(value)!r}'
            )
            return None
        return Fraction(match[1]) / (100 if match[2] else 1)


def written(value: Any) -> str:
    """A number or a text as it stands in the file, cut where it is long; of anything else its
    kind.
    """
    if isinstance(value, bool) or not isinstance(value, int | str):
        return f"a {type(value).__name__}"
    return str(value).strip()[:40]
