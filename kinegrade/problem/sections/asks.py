"""The table `[asks]`: the quantities that may be asked for."""

from __future__ import annotations

from kinegrade.errors import FieldError, did_you_mean
from kinegrade.fields.table import Table
from kinegrade.fields.values import flag, found, whole
from kinegrade.language import LANGUAGES
from kinegrade.problem.notation import write_symbol
from kinegrade.problem.sections.keys import ASK, TEXTS
from kinegrade.problem.sections.parameters import unit
from kinegrade.problem.sections.values import expression, present, words, written
from kinegrade.problem.signs import CONVENTIONS
from kinegrade.problem.template import Ask, Translated
from kinegrade.problem.translations import translated

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
    sign = entry.with_default("sign", read_sign, CONVENTIONS["magnitude"])
    points = entry.with_default("points", whole(0, _MOST_POINTS), 0)
    vanishes = entry.with_default("vanishes", flag, False)
    cyclic = entry.with_default("cyclic", flag, False)
    if quantity is None or counted_in is None or means is None:
        return None
    return Ask(name, label, quantity, counted_in, means, sign, points, vanishes, cyclic)


def read_sign(value: object) -> Translated:
    """The words of a sign convention: those of a keyword, or the author's in both languages.

    >>> read_sign("ccw").en
    'counter-clockwise positive'
    """
    match value:
        case str() if value in CONVENTIONS:
            return CONVENTIONS[value]
        case dict() if set(value) == set(LANGUAGES):
            return Translated(words(value["en"]), words(value["zh"]))
        case _:
            near = did_you_mean(value, CONVENTIONS) if isinstance(value, str) else ""
            raise FieldError(found(value), f"a keyword, or {TEXTS}", near)
