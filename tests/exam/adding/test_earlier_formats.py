"""Exams of earlier formats grow, and exams whose key other hands have cut."""

from __future__ import annotations

import json
from pathlib import Path

from tests.exam.adding.growing_class import CLASS, LATE, REWRITTEN, added, roster
from tests.small_class import contents, key_lines


def test_a_key_without_its_last_line_end_is_not_broken(folder: Path) -> None:
    key = folder / "EXAM" / "key.jsonl"
    key.write_bytes(key.read_bytes().rstrip(b"\n"))
    added(folder)
    assert [line["student"] for line in key_lines(folder / "EXAM")] == [*CLASS, *LATE]


def as_format_1(exam: Path) -> None:
    """What earlier versions wrote: no places, no values as drawn, no paper size, no digests."""
    head = json.loads((exam / "exam.json").read_text(encoding="utf-8"))
    left_out = ("paper_size", "engine", "editable")
    old = {name: value for name, value in head.items() if name not in left_out} | {"format": 1}
    (exam / "exam.json").write_text(json.dumps(old), encoding="utf-8")
    lines = key_lines(exam)
    for line in lines:
        del line["place"]
        for question in line["questions"]:
            del question["drawn"]
    text = "".join(f"{json.dumps(line)}\n" for line in lines)
    (exam / "key.jsonl").write_text(text, encoding="utf-8")


def test_an_exam_of_format_1_grows_and_grows(folder: Path) -> None:
    as_format_1(folder / "EXAM")
    before = contents(folder / "EXAM")
    added(folder)
    (folder / "roster.csv").write_text(roster({**CLASS, **LATE}), encoding="utf-8")
    (folder / "late.csv").write_text(roster({f"x{n}": "N" for n in range(15)}), encoding="utf-8")
    assert "15 papers added, 5 stay as they are" in added(folder).stderr
    after = contents(folder / "EXAM")
    kept = before.keys() - REWRITTEN
    assert {name: after[name] for name in kept} == {name: before[name] for name in kept}
    assert after["key.jsonl"].startswith(before["key.jsonl"])
    lines = key_lines(folder / "EXAM")
    assert [line.get("place") for line in lines[:3]] == [None] * 3
    assert sorted(line["place"] for line in lines[3:]) == list(range(3, 20))
    for question in (0, 1):
        values = [
            json.dumps({name: each["exact"] for name, each in found["parameters"].items()})
            for found in (line["questions"][question] for line in lines)
        ]
        assert len(set(values)) == 20
