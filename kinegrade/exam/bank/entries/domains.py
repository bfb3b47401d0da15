"""The values that a bank lets a question draw, in place of its template's.

draw = { k = ["sqrt(3)", 2], phi = "30 .. 60 step 15", r = 0.2 }
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from contextlib import suppress
from functools import partial
from typing import assert_never

from kinegrade.draws.deck import Deck
from kinegrade.draws.examining import Refused, solve_sensible
from kinegrade.errors import FieldError
from kinegrade.expressions.reading import read_expression
from kinegrade.files.fields.digits import Digits
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import found
from kinegrade.language.message import Listing, Message, list_plainly
from kinegrade.numbers.field import Field
from kinegrade.numbers.refusals import Inexact
from kinegrade.problem.assembling.parameters import read_parameter
from kinegrade.problem.template.domain import read_choices
from kinegrade.problem.template.template import Parameter, Template

_TRIED = 40  # combinations, before it is said that the template allows none
_SHOWN = 6  # values that a refusal lists
_RANGE = ".."

Domains = dict[str, tuple[str, ...]]


def read_domains(entry: Table, template: Template, *, kept: bool) -> Domains:
    """The domains of an entry `[[questions]]` that replace the template's. A bank that is `kept`
    with an exam was dealt from, so that its values are not tried again.
    """
    draw = entry.table("draw", "{ k = [2, 3] }").only(
        *template.parameters, unknown=Message("fields.unknown-parameter")
    )
    read = {
        name: draw.optional(name, partial(_read_values, template.parameters[name])) for name in draw
    }
    domains = {name: choices for name, choices in read.items() if choices is not None}
    if not kept and len(domains) == len(draw):
        _note_unfit(draw, template, domains)
    return domains


def _read_values(parameter: Parameter, value: object) -> tuple[str, ...]:
    """The values that may be drawn for a parameter; each must be one that it can have."""
    if isinstance(value, bool):
        raise FieldError(found(value), Message("bank.values-to-draw"))
    choices = read_choices([value] if _is_single(value) else value)
    for choice in choices:
        with suppress(Inexact):  # then it is a number all the same
            read_parameter(parameter, read_expression(choice), Field())
    return choices


def _is_single(value: object) -> bool:
    """Whether one value is stated: a number, or the text of an expression."""
    if isinstance(value, str) and not isinstance(value, Digits):
        return _RANGE not in value
    return isinstance(value, Digits | int)


def _note_unfit(draw: Table, template: Template, domains: Domains) -> None:
    """A fault for a parameter at none of whose values the mechanism can be built, although it can
    at those of the template.
    """
    refusal = _find_refusal(template, domains)
    if refusal is None:
        return
    for name in domains:
        others = {other: choices for other, choices in domains.items() if other != name}
        if _find_refusal(template, others) is None:
            expected = Message(
                "bank.values-like", values=_list_some(template.parameters[name].choices)
            )
            draw.fault(name, _explain(_list_some(domains[name]), refusal), expected)


def _find_refusal(template: Template, domains: Domains) -> Refused | None:
    """Why most of the first combinations of a deck cannot be built; None where one can.

    Whether answers can be asked for is no matter of the domains alone.
    """
    refusals: list[Refused] = []
    whole = {name: each.choices for name, each in template.parameters.items()} | domains
    for values in Deck(whole, "sample", template.name).walk(_TRIED):
        try:
            solve_sensible(template, values, (), None)
        except Refused as refused:
            refusals.append(refused)
        else:
            return None
    reasons = Counter(each.reason for each in refusals)
    return max(refusals, key=lambda each: reasons[each.reason])


def _explain(values: Listing, refusal: Refused) -> Message:
    """That the values cannot be had."""
    match refusal.reason:
        case "condition":
            return Message("bank.no-condition", values=values, why=refusal.detail)
        case (
            "earlier"
            | "mechanism"
            | "degenerate"
            | "absurd"
            | "rounding"
            | "mistake"
            | "decimals"
            | "figure"
        ):
            return Message("bank.no-mechanism", values=values)
        case _:
            assert_never(refusal.reason)


def _list_some(choices: Sequence[str]) -> Listing:
    """The first of some values."""
    return list_plainly([*choices[:_SHOWN], *(["..."] if len(choices) > _SHOWN else [])])
