"""Single values of a policy's file: words, shares, amounts and tolerances, read exactly, with all
faults at once.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

from kinegrade.errors import did_you_mean, one_line
from kinegrade.grading.policy import Room

_AMOUNT = re.compile(r"\d{1,9}(?:\.\d{1,12})?", re.ASCII)
_SHARE = re.compile(r"(\d{1,9}(?:\.\d{1,12})?)\s*(%?)|(\d{1,9})\s*/\s*(\d{1,9})", re.ASCII)
_MOST_FIGURES = 15
_LONGEST_SHOWN = 80


class Values:
    """Reads values of one file, collecting its faults; after a fault a value is None or empty, and
    reading goes on.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self.faults: list[str] = []

    def fault(self, place: str, problem: str) -> None:
        """Note a fault: "what - what was expected"."""
        self.faults.append(": ".join(filter(None, (str(self.path), place, one_line(problem)))))

    def table(self, place: str, value: Any, known: Sequence[str]) -> Mapping[str, Any]:
        """A table of which only the known keys are given on; a missing one is empty."""
        if value is None:
            return {}
        if not isinstance(value, dict):
            self.fault(place, f"expected a table with some of: {', '.join(known)}")
            return {}
        self._unknown(place, value, known, "key")
        return {key: content for key, content in value.items() if key in known}

    def named(
        self, place: str, value: Any, known: Iterable[str], kind: str
    ) -> Iterator[tuple[str, Any]]:
        """The entries of a table whose names are those of a `kind`, such as the exam's
        questions.
        """
        if isinstance(value, dict):
            names = set(known)
            self._unknown(place, value, names, kind)
            yield from ((name, content) for name, content in value.items() if name in names)
        elif value is not None:
            self.fault(place, f"expected a table of each {kind}")

    def _unknown(
        self, place: str, table: Mapping[str, Any], known: Iterable[str], kind: str
    ) -> None:
        for name in sorted(table.keys() - set(known)):
            self.fault(place, f'unknown {kind} "{shown(name)}": {did_you_mean(name, known)}')

    def word(self, place: str, value: Any, choices: Sequence[str]) -> Any:
        """One of some words, or None."""
        if value is not None and value not in choices:
            self.fault(place, f"expected {' or '.join(choices)}, not {written(value)!r}")
            return None
        return value

    def share(self, place: str, value: Any) -> Fraction | None:
        """A share from 0 to 1: 0.5, "50 %" or "1/2"."""
        if value is None:
            return None
        match = _SHARE.fullmatch(written(value))
        if match and match[1]:
            share = Fraction(match[1]) / (100 if match[2] else 1)
        elif match and int(match[4]):
            share = Fraction(int(match[3]), int(match[4]))
        else:
            share = Fraction(-1)
        if 0 <= share <= 1:
            return share
        self.fault(
            place,
            f'expected a share from 0 to 1, like 0.5, "50 %" or "1/2", not {written(value)!r}',
        )
        return None

    def amount(self, place: str, value: Any) -> Fraction | None:
        """A number of zero or more, exactly."""
        if value is None:
            return None
        if _AMOUNT.fullmatch(written(value)):
            return Fraction(written(value))
        self.fault(place, f"expected a number of zero or more, like 2.5, not {written(value)!r}")
        return None

    def room(self, place: str, value: Any) -> Room:
        """{ relative = "2 %", absolute = 0.01, figures = 3 }, each optional."""
        table = self.table(place, value, ("relative", "absolute", "figures"))
        figures = table.get("figures")
        if figures is not None and (type(figures) is not int or not 1 <= figures <= _MOST_FIGURES):
            self.fault(
                f"{place}.figures",
                f"expected a whole number from 1 to {_MOST_FIGURES}, not {written(figures)!r}",
            )
            figures = None
        return Room(
            self.share(f"{place}.relative", table.get("relative")),
            self.amount(f"{place}.absolute", table.get("absolute")),
            figures,
        )


def written(value: Any) -> str:
    """A number, a text or a truth value as it stands in the file, cut where it is long; of anything
    else its kind.
    """
    if isinstance(value, bool):
        return str(value).lower()
    return (
        shown(str(value).strip()) if isinstance(value, int | str) else f"a {type(value).__name__}"
    )


def shown(text: str) -> str:
    """A text short enough for a message."""
    return text if len(text) <= _LONGEST_SHOWN else f"{text[:_LONGEST_SHOWN]}…"
