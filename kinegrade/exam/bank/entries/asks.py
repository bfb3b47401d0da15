"""What a question of a bank asks, with points: as the bank says, or as the template weighs it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

from kinegrade.exam.bank.blueprint import BankAsk
from kinegrade.exam.bank.entries.points import share_points
from kinegrade.exam.bank.keys import ASK
from kinegrade.exam.bank.terms import MAX_POINTS, BankTolerance, read_bank_tolerance, read_points
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import choice, whole
from kinegrade.language.message import Message, Text
from kinegrade.problem.template.tags import KINDS, select_asks
from kinegrade.problem.template.template import Template

_POINTED = Message("bank.asks-with-points")


def read_asks(entry: Table, template: Template, wider: BankTolerance) -> tuple[BankAsk, ...]:
    """What is asked of a template: what the bank names, or what the template gives points."""
    if entry.holds_table("asks") and entry.table("asks"):
        return _read_named_asks(entry, template, wider)
    kind = read_kind(entry, _POINTED)
    if kind is None:
        return ()
    asked = weigh_asks(entry, [template], kind, wider).get(template.name, ())
    if not asked:
        entry.fault("asks", Message("bank.gives-no-points", template=template.name), _POINTED)
    return asked


def read_kind(entry: Table, otherwise: Text = "") -> str | None:
    """The kind of asks that an entry wants, "" for all; None after a fault.

    `otherwise` describes what else is accepted.
    """
    if "asks" not in entry:
        return ""
    return entry.optional("asks", choice(KINDS, otherwise))


def weigh_asks(
    entry: Table, templates: Sequence[Template], kind: str, stated: BankTolerance
) -> dict[str, tuple[BankAsk, ...]]:
    """What each template asks of the entry's kind, with its points or its share of the entry's
    points; templates without such asks are left out.
    """
    weights: dict[str, Mapping[str, int]] = {}
    for template in templates:
        asked = select_asks(template, kind)
        if asked:
            weights[template.name] = {name: template.asks[name].points for name in asked}
    total = _read_total(entry, weights)
    if total is not None:
        weights = {name: share_points(total, asks) for name, asks in weights.items()}
    return {
        name: tuple(_make_ask(ask, Fraction(points), stated) for ask, points in asks.items())
        for name, asks in weights.items()
    }


def _read_total(entry: Table, weights: Mapping[str, Mapping[str, int]]) -> int | None:
    """The points to be shared out, at least one for each ask; None if the bank does not state them,
    or after a fault.
    """
    total = entry.optional("points", whole(1, MAX_POINTS))
    longest = max(weights, key=lambda name: len(weights[name]), default=None)
    if total is None or longest is None:
        return None
    count = len(weights[longest])
    if total < count:
        what = Message("bank.asks-quantities", template=longest, count=count)
        entry.fault("points", what, Message("bank.point-for-each"))
        return None
    return total


def _read_named_asks(entry: Table, template: Template, wider: BankTolerance) -> tuple[BankAsk, ...]:
    """The asks that the bank names."""
    if "points" in entry:
        what, do = Message("bank.points-given-twice"), Message("bank.leave-one-out")
        entry.fault("points", what, do=do)
    asks = entry.table("asks").only(
        *template.asks, unknown=Message("fields.unknown-ask-of", template=template.name)
    )
    return tuple(_read_ask(asks, name, template, wider) for name in asks)


def _read_ask(asks: Table, name: str, template: Template, wider: BankTolerance) -> BankAsk:
    """One ask: points, or a table with points (by default the template's) and tolerance."""
    usual = Fraction(template.asks[name].points)
    if not asks.holds_table(name):
        return _make_ask(name, asks.with_default(name, read_points, usual), wider)
    ask = asks.table(name).only(*ASK)
    return _make_ask(name, _read_points(ask, usual), read_bank_tolerance(ask, wider))


def _make_ask(name: str, points: Fraction, stated: BankTolerance) -> BankAsk:
    return BankAsk(name, points, stated.tolerance, stated.honest)


def _read_points(ask: Table, usual: Fraction) -> Fraction:
    """The points of an ask; a template's ask that has none needs some."""
    if "points" not in ask and not usual:
        ask.missing("points", Message("bank.points-of-ask"))
    return ask.with_default("points", read_points, usual)
