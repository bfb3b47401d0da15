"""The key's answers as students may spell them, and an answer sheet that is filled in."""

from __future__ import annotations

import csv
from collections.abc import Callable
from decimal import Context, Decimal
from pathlib import Path
from typing import Any

from tests.small_class import table

Spelling = Callable[[dict[str, Any]], str]  # of an ask of the key
WIDE = {ord(digit): ord(digit) + 0xFEE0 for digit in "0123456789.-"}


def rounded(digits: int) -> Spelling:
    """The answer with so many significant digits."""
    return lambda ask: str(Context(prec=digits).create_decimal(ask["decimal"]))


SPELLINGS: dict[str, Spelling] = {
    "37 digits": rounded(37),  # with the zeros about the point as many as are read
    "6 digits": rounded(6),
    "4 digits": rounded(4),
    "value": lambda ask: repr(ask["value"]),
    # 1,875 would be remarked upon
    "comma": lambda ask: f"{Decimal(ask['decimal']):.9f}".replace(".", ","),
    "unit": lambda ask: f" {rounded(5)(ask)} {ask['unit'] if ask['unit'] != '1' else ''} ",
    "power of ten": lambda ask: f"{Decimal(ask['decimal']):.6e}",
    "minus": lambda ask: rounded(6)(ask).replace("-", "\u2212"),
    "full width": lambda ask: rounded(6)(ask).translate(WIDE),
}


def type_answers(exam: Path, file: Path, typed: Callable[[str, str], str]) -> None:
    """Write a sheet of answers in which every student types `typed(student, column)`."""
    rows = table(exam / "answers.csv")
    for row in rows:
        row.update({column: typed(row["student"], column) for column in row if "." in column})
    with file.open("w", encoding="utf-8", newline="") as stream:
        writer = csv.DictWriter(stream, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)
