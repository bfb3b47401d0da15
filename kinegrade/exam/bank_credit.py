"""What a bank gives for answers that are not right: what follows from an earlier mistake, known
mistakes, wrong units.

    credit = { follow-through = "1/2", wrong-unit = "50 %", mistakes = { coriolis-halved = 0.5 } }

Shares of the points. They are kept in exam.json, by which the class is marked; a policy may say
otherwise later.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from kinegrade.errors import did_you_mean
from kinegrade.exam.bank_values import SHARE, Values, written
from kinegrade.problem.mistake_kinds import sentences

RATIO = re.compile(r"(\d{1,4})\s*/\s*(\d{1,4})", re.ASCII)
ALONE = ("follow-through", "wrong-unit")


@dataclass(frozen=True)
class Credit:
    """Shares of the points, from 0 to 1: by kind what stands alone, by identifier those of known
    mistakes.
    """

    alone: Mapping[str, Fraction] = field(default_factory=dict)
    mistakes: Mapping[str, Fraction] = field(default_factory=dict)

    def record(self) -> dict[str, Any]:
        """As exam.json keeps it; empty where nothing is said."""
        mistakes = (
            {"mistakes": {name: str(share) for name, share in self.mistakes.items()}}
            if self.mistakes
            else {}
        )
        return {**{name: str(share) for name, share in self.alone.items()}, **mistakes}


NO_CREDIT = Credit()


def read_credit(values: Values, content: Any) -> Credit:
    """The credit table of a bank; faults are noted in `values`."""
    if content is None:
        return NO_CREDIT
    if not isinstance(content, dict):
        values.fault("credit", 'expected a table like { follow-through = "1/2" }')
        return NO_CREDIT
    values.unknown_keys("credit", content, (*ALONE, "mistakes"))
    mistakes = content.get("mistakes", {})
    if not isinstance(mistakes, dict):
        values.fault("credit.mistakes", 'expected a table like { coriolis-halved = "1/2" }')
        mistakes = {}
    known = sentences()
    for name in sorted(mistakes.keys() - known.keys()):
        values.fault("credit.mistakes", f'unknown mistake "{name}": {did_you_mean(name, known)}')
    return Credit(
        {name: part(values, f"credit.{name}", content[name]) for name in ALONE if name in content},
        {
            name: part(values, f"credit.mistakes.{name}", share)
            for name, share in mistakes.items()
            if name in known
        },
    )


def part(values: Values, place: str, content: Any) -> Fraction:
    """A share from 0 to 1: 0.5, "50 %" or "1/2"; 0 after a fault, with which reading goes on."""
    text = written(content)
    ratio, share = RATIO.fullmatch(text), SHARE.fullmatch(text)
    if ratio and int(ratio[2]):
        found = Fraction(int(ratio[1]), int(ratio[2]))
    else:
        found = Fraction(share[1]) / (100 if share[2] else 1) if share else Fraction(-1)
    if 0 <= found <= 1:
        return found
    values.fault(place, f'expected a share from 0 to 1, like 0.5, "50 %" or "1/2", not {text!r}')
    return Fraction(0)
