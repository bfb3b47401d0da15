"""A small exam folder, as generate writes it: two questions, three asks, four students."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

STUDENTS = {"007": "王伟", "0012": "O'Neil, Zoë", "S9": "=HYPERLINK(1)", "12": "Ann"}
HALF_ROOT_12 = "1.732050807568877293527446341505872366943"


def exam() -> dict[str, Any]:
    return {
        "format": 1,
        "title": "Kinematics",
        "language": "en",
        "questions": [
            {
                "question": "q1",
                "template": "slider-crank",
                "points": 7,
                "asks": [
                    {"ask": "v_B", "unit": "m/s", "points": 4},
                    {"ask": "omega_AB", "unit": "rad/s", "points": 3},
                ],
            },
            {
                "question": "q2",
                "template": "bar",
                "points": 2.5,
                "asks": [{"ask": "a_B", "unit": "m/s^2", "points": 2.5}],
            },
        ],
        "students": [
            {"student": student, "name": name, "paper": "K7Q2", "email": ""}
            for student, name in STUDENTS.items()
        ],
    }


def entry(
    exact: str | None, decimal: str, unit: str, points: float, **tolerance: float
) -> dict[str, Any]:
    return {
        "exact": exact,
        "value": float(decimal),
        "decimal": decimal,
        "unit": unit,
        "tolerance": {"relative": 0, "absolute": 0, **tolerance},
        "points": points,
    }


def paper(student: str) -> dict[str, Any]:
    asks = {
        "v_B": entry("sqrt(3)", HALF_ROOT_12, "m/s", 4, relative=0.01),
        "omega_AB": entry("0", "0", "rad/s", 3, relative=0.01, absolute=0.002),
    }
    more = {"a_B": entry("-1/8", "-0.125", "m/s^2", 2.5, relative=0.1)}
    questions = [{"question": "q1", "asks": asks}, {"question": "q2", "asks": more}]
    return {"student": student, "paper": "K7Q2", "questions": questions}


def asks(paper: dict[str, Any], question: int = 0) -> dict[str, Any]:
    """What a line of the key asks in a question."""
    found: dict[str, Any] = paper["questions"][question]["asks"]
    return found


def write_exam(folder: Path, head: object, papers: list[Any]) -> Path:
    folder.mkdir()
    (folder / "exam.json").write_text(json.dumps(head), encoding="utf-8")
    (folder / "key.jsonl").write_text(
        "".join(f"{json.dumps(each)}\n" for each in papers), encoding="utf-8"
    )
    return folder
