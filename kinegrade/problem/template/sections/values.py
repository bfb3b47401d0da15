"""Single values of a template: texts, expressions, names."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Literal, TypeVar

from kinegrade.errors import FieldError, suggest
from kinegrade.expressions.reading import read_expression
from kinegrade.expressions.tree import Expression
from kinegrade.files.fields.values import found
from kinegrade.language.message import Message, Part

_Key = TypeVar("_Key")
_Entry = TypeVar("_Entry")
NamedKind = Literal["point", "body", "point-or-side", "parameter", "ask", "length"]


def words(value: object) -> str:
    """A text, which may be blank.

    >>> words("by hand")
    'by hand'
    """
    if isinstance(value, str):
        return str(value)
    raise FieldError(found(value), Message("fields.a-text"))


def written(value: object) -> str:
    """A text or a number as it is written.

    >>> written(2), written("sqrt(3)")
    ('2', 'sqrt(3)')
    """
    if isinstance(value, int) and not isinstance(value, bool):
        return str(value)
    return words(value)


def expression(value: object) -> Expression:
    """The tree of an expression, which may be a number without quotation marks."""
    return read_expression(written(value))


def named(kind: NamedKind, names: Iterable[str]) -> Callable[[object], str]:
    """A reader of one of these names, which are called a `kind` in messages."""
    known = frozenset(names)

    def read_name(value: object) -> str:
        if isinstance(value, str) and value in known:
            return value
        raise FieldError(explain_missing(kind, found(value)), do=suggest(str(value), known))

    return read_name


def explain_missing(kind: NamedKind, name: Part) -> Message:
    """What is said of a name that nothing of its kind has."""
    return Message(f"template.missing-{kind}", name=name)


def present(entries: Mapping[_Key, _Entry | None]) -> dict[_Key, _Entry]:
    """Those entries that could be read."""
    return {key: entry for key, entry in entries.items() if entry is not None}
