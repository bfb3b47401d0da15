"""Whether a student was put the questions of the own paper: by the right answers that a download
tells.

A quiz may hold variants that everybody draws from, or somebody else's paper. Marked by the
student's own key such answers would all be wrong, so they are told instead.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from kinegrade.errors import ExamError
from kinegrade.lms.responses.exam_asks import BROKEN, MENDING
from kinegrade.tables import trimmed

_NUMBER = re.compile(r"[-+]?\d{1,30}(?:[.,]\d{1,60})?(?:[eE][-+]?\d{1,3})?")
_SHARE = 0.02  # a quiz may state the middle of what is right to three figures
_NEXT_TO_NOTHING = 1e-6


def right_answers(folder: Path) -> Mapping[str, Mapping[str, float]]:
    """The right answers by student and column; none where the folder has no key.jsonl. Raises
    ExamError.
    """
    path = folder / "key.jsonl"
    try:
        with path.open(encoding="utf-8") as lines:
            papers = [json.loads(line) for line in lines if line.strip()]
        return {paper["student"]: _values(paper) for paper in papers}
    except FileNotFoundError:
        return {}
    except OSError as fault:
        raise ExamError(
            f"{path}: cannot be read ({fault.strerror}) - expected the key - check the file"
        ) from fault
    except BROKEN as fault:
        raise ExamError(
            f"{path}: is broken ({type(fault).__name__}: {fault}) - {MENDING}"
        ) from fault


def _values(paper: Mapping[str, Any]) -> Mapping[str, float]:
    return {
        f"{question['question']}.{name}": float(ask["value"])
        for question in paper["questions"]
        for name, ask in question["asks"].items()
    }


def difference(columns: Sequence[str], told: Sequence[str], own: Mapping[str, float]) -> str:
    """How the right answers told by a download differ from those of the own paper; "" where they do
    not.

    What is told may have a decimal comma and a unit; texts that begin with no number are not
    compared.

    >>> difference(["q1.v_B"], ["-1,5 m/s"], {"q1.v_B": 2.5})
    'the right answer to q1.v_B is -1,5 m/s there and 2.5 on the own paper'
    """
    for column, text in zip(columns, told, strict=False):
        value = value_of(text)
        if value is not None and column in own and not agree(value, own[column]):
            return (
                f"the right answer to {column} is {text} there and {own[column]:.6g} on the own "
                "paper"
            )
    return ""


def value_of(text: str) -> float | None:
    """The number with which a right answer begins, None where it begins with none."""
    found = _NUMBER.match(trimmed(text))
    return float(found[0].replace(",", ".")) if found else None


def agree(told: float, own: float, share: float = _SHARE) -> bool:
    """Whether two numbers are the same within that share of themselves."""
    return abs(told - own) <= max(share * abs(own), _NEXT_TO_NOTHING)
