"""Single values of a template: texts, expressions, names."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TypeVar

from kinegrade.errors import FieldError, did_you_mean
from kinegrade.expression import Expression, read_expression
from kinegrade.fields.values import found

_Key = TypeVar("_Key")
_Entry = TypeVar("_Entry")


def words(value: object) -> str:
    """A text, which may be blank.

    >>> words("by hand")
    'by hand'
    """
    if isinstance(value, str):
        return str(value)
    raise FieldError(found(value), 'a text in quotation marks, "..."')


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


def named(kind: str, names: Iterable[str]) -> Callable[[object], str]:
    """A reader of one of these names, which are called a `kind` in messages."""
    known = frozenset(names)

    def read_name(value: object) -> str:
        if isinstance(value, str) and value in known:
            return value
        raise FieldError(f"no {kind} {found(value)}", do=did_you_mean(str(value), known))

    return read_name


def present(entries: Mapping[_Key, _Entry | None]) -> dict[_Key, _Entry]:
    """Those entries that could be read."""
    return {key: entry for key, entry in entries.items() if entry is not None}
