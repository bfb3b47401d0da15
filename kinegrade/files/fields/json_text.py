"""JSON as an exam folder holds it: its content digit by digit, or the fault and its line."""

from __future__ import annotations

import json
from collections.abc import Sequence

from kinegrade.errors import JsonError
from kinegrade.files.fields.digits import TOO_DEEP, TOO_LARGE, Digits, Unbounded, require_bounded
from kinegrade.language.message import Message, Quoted


def read_json(text: str) -> object:
    """The content of a JSON text; numbers with a point are Digits. Raises JsonError with the fault
    and its line.

    >>> read_json('{"points": 2.50}')
    {'points': '2.50'}
    """
    try:
        content: object = json.loads(
            text,
            parse_float=Digits,
            parse_constant=_refuse_constant,
            object_pairs_hook=_object,
        )
        require_bounded(content)
    except json.JSONDecodeError as error:
        raise JsonError(Message("fields.broken-json", reason=error.msg), error.lineno) from error
    except Unbounded as error:
        raise JsonError(error.reason) from error
    except RecursionError as error:
        raise JsonError(TOO_DEEP) from error
    except ValueError as error:  # Python reads no integer of more than 4,300 digits
        raise JsonError(TOO_LARGE) from error
    return content


def _object(pairs: Sequence[tuple[str, object]]) -> dict[str, object]:
    """A JSON object in which no key occurs twice."""
    found = dict(pairs)
    if len(found) == len(pairs):
        return found
    keys = [key for key, _ in pairs]
    twice = next(key for place, key in enumerate(keys) if key in keys[:place])
    raise JsonError(Message("fields.twice-in-object", key=Quoted(twice)))


def _refuse_constant(name: str) -> object:
    raise JsonError(Message("fields.no-number", name=name))
