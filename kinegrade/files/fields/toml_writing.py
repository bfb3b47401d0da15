"""Tables as the text of a TOML file, which reads back as the same."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping

from kinegrade.files.fields.digits import Digits

_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+", re.ASCII)


def write_toml(content: Mapping[str, object]) -> str:
    """The text of a file with these keys, each on a line of its own.

    >>> write_toml({"steps": {"v": "a*t"}, "points": 3})
    'steps = { v = "a*t" }\\npoints = 3\\n'
    """
    return "".join(f"{_write_entry(key, value)}\n" for key, value in content.items())


def _write_entry(key: str, value: object) -> str:
    return f"{key if _BARE_KEY.fullmatch(key) else _write_text(key)} = {_write_value(value)}"


def _write_value(value: object) -> str:
    """A value on one line; a number as it stood in the file it was read from."""
    match value:
        case bool():
            return "true" if value else "false"
        case int() | Digits():
            return str(value)
        case list():
            return f"[{', '.join(map(_write_value, value))}]"
        case dict():
            inside = ", ".join(_write_entry(key, part) for key, part in value.items())
            return f"{{ {inside} }}" if inside else "{}"
        case _:
            return _write_text(str(value))


def _write_text(text: str) -> str:
    """A text in quotation marks, its control characters escaped as in JSON."""
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")
