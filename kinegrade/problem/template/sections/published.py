"""The list `[[published]]`: results that the source gives, with the values for which they hold."""

from __future__ import annotations

import re

from kinegrade.errors import FieldError
from kinegrade.expressions.reading import read_expression
from kinegrade.expressions.tree import Expression
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import found
from kinegrade.language.message import Message
from kinegrade.numbers.units import is_unit
from kinegrade.problem.template.sections import keys
from kinegrade.problem.template.sections.values import present, written
from kinegrade.problem.template.template import Published

_LIKE = '{ source = "...", gives = { v_B = "2*omega*r" } }'
# A number as people write some, with a decimal comma or a unit
_COUNTED = re.compile(r"([+-]?\d+(?:[.,]\d+)?)\s*(\S*)", re.ASCII)


def read_published(table: Table) -> dict[int, Published]:
    """The published results that can be read, by their position in the file."""
    entries = table.tables("published", _LIKE)
    return present({number: _read_published(entry) for number, entry in enumerate(entries)})


def _read_published(table: Table) -> Published | None:
    entry = table.only(*keys.PUBLISHED)
    source = entry.required("source", written)
    given = entry.table("given", '{ r = "1" }').entries(written)
    if not entry.require(["gives"]) or source is None:
        return None
    results = entry.table("gives", '{ v_B = "2*omega*r" }').entries(_read_result)
    trees = {name: tree for name, (_, tree) in results.items()}
    texts = {name: text for name, (text, _) in results.items()}
    return Published(source, given, trees, texts)


def _read_result(value: object) -> tuple[str, Expression]:
    """An expression as it is written, and its tree."""
    text = written(value)
    number = _COUNTED.fullmatch(text)
    if number is not None and "," in number[1]:
        do = Message("template.decimal-point", number=number[1].replace(",", "."))
        raise FieldError(found(value), do=do)
    if number is not None and is_unit(number[2]):
        raise FieldError(found(value), do=Message("template.number-alone", number=number[1]))
    return text, read_expression(text)
