"""What the alternatives of an entry have to be, of which each student gets some."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from fractions import Fraction

from kinegrade.exam.bank.blueprint import BankAsk
from kinegrade.files.fields.table import Table
from kinegrade.language.message import Message, Quoted, list_plainly
from kinegrade.numbers.amounts import write_amount
from kinegrade.problem.template.template import Template

MOST_ALTERNATIVES = 26  # the letters that tell them apart
_FROM_TO = Message("bank.alternatives-from-to", most=MOST_ALTERNATIVES)


def require_different(entry: Table, templates: Sequence[Template]) -> None:
    """A fault where the templates that `any` lists are too few or too many, or one is listed
    twice.
    """
    named = entry.value("any")
    if not isinstance(named, list) or len(named) != len(templates):
        return  # what is at fault there has been said
    if not 2 <= len(templates) <= MOST_ALTERNATIVES:
        entry.fault("any", Message("bank.alternatives", count=len(templates)), _FROM_TO)
    for name, count in Counter(each.name for each in templates).items():
        if count > 1:
            what = Message("bank.alternative-twice", name=Quoted(name))
            entry.fault("any", what, Message("bank.each-alternative-once"))


def require_equal_points(
    entry: Table, choice: Sequence[tuple[Template, tuple[BankAsk, ...]]]
) -> None:
    """A fault where alternatives carry different points, which says those of each."""
    points = {each.name: sum((ask.points for ask in asks), Fraction(0)) for each, asks in choice}
    if len(set(points.values())) > 1:
        each = list_plainly(f"{name} {write_amount(amount)}" for name, amount in points.items())
        what = Message("bank.unequal-alternatives", points=each)
        entry.fault("points", what, Message("bank.equal-points"), Message("bank.state-points"))
