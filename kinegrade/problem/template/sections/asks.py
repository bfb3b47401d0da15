"""The table `[asks]`: the quantities that may be asked for."""

from __future__ import annotations

from kinegrade.errors import FieldError, suggest
from kinegrade.expressions.angular import turns_round
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import flag, found, whole
from kinegrade.language.message import Message
from kinegrade.problem.template.notation import write_symbol
from kinegrade.problem.template.sections.keys import ASK
from kinegrade.problem.template.sections.parameters import unit
from kinegrade.problem.template.sections.values import expression, present, written
from kinegrade.problem.template.signs import Sign
from kinegrade.problem.template.template import Ask
from kinegrade.problem.template.translations import BY_LANGUAGE, translated
from kinegrade.sign_conventions import CONVENTIONS

_LIKE = '{ quantity = "x(velocity(A))", unit = "m/s" }'
_MOST_POINTS = 100


def read_asks(table: Table) -> dict[str, Ask]:
    """The asks of a file that can be read, by name."""
    entries = table.table("asks").each_table(_LIKE)
    return present({name: _read_ask(name, entry) for name, entry in entries.items()})


def _read_ask(name: str, table: Table) -> Ask | None:
    entry = table.only(*ASK)
    quantity = entry.required("quantity", expression)
    counted_in = entry.required("unit", unit)
    means = entry.required("means", translated)
    label = entry.with_default("symbol", written, write_symbol(name))
    sign: Sign = entry.optional("sign", read_sign) or "magnitude"
    points = entry.with_default("points", whole(0, _MOST_POINTS), 0)
    vanishes = entry.with_default("vanishes", flag, False)
    cyclic = entry.optional("cyclic", flag)
    if quantity is None or counted_in is None or means is None:
        return None
    if cyclic is None:
        cyclic = turns_round(quantity)
    return Ask(name, label, quantity, counted_in, means, sign, points, vanishes, cyclic)


def read_sign(value: object) -> Sign:
    """A sign convention: a keyword, or the author's own words, once or by language.

    >>> read_sign("ccw")
    'ccw'
    """
    if isinstance(value, dict) or (isinstance(value, str) and " " in value.strip()):
        return translated(value)
    for convention in CONVENTIONS:
        if value == convention:
            return convention
    near = suggest(value, CONVENTIONS) if isinstance(value, str) else ""
    raise FieldError(found(value), Message("texts.sign", texts=BY_LANGUAGE), near)
