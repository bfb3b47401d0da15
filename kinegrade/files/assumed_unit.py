"""A number in a unit that stands elsewhere: in a header, in a question's text."""

from __future__ import annotations

import re

_NUMBER = re.compile(r"[-+−]?[\d.,\s]*\d[\d.,\s]*(?:[eE][-+−]?\d+)?")


def in_unit(typed: str, unit: str) -> str:
    """What was typed as a number in that unit; anything but a number without a unit is unchanged.

    >>> in_unit("4.25", "mm/s"), in_unit("4.25 m/s", "mm/s"), in_unit("4.25", "")
    ('4.25 mm/s', '4.25 m/s', '4.25')
    """
    return f"{typed} {unit}" if unit and _NUMBER.fullmatch(typed.strip()) else typed
