"""Exam folders of a quiz, and the lines of their keys written anew."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

from kinegrade.exam.folder.key.exact_keys import read_key_line
from kinegrade.exam.folder.key.lines import KeyLine
from kinegrade.exam.quiz.document import QuizAsk, QuizPaper


def asks(paper: QuizPaper) -> dict[str, QuizAsk]:
    return {
        f"{question.sheet.identifier}.{ask.identifier}": ask
        for question in paper.questions
        for ask in question.asks
    }


def copied(small_class: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(small_class / "EXAM", tmp_path / "EXAM"))


def rewritten(exam: Path, line: dict[str, Any]) -> Path:
    """The exam with another first line of its key."""
    key = exam / "key.jsonl"
    others = key.read_text(encoding="utf-8").splitlines()[1:]
    key.write_text("\n".join([json.dumps(line), *others]) + "\n", encoding="utf-8")
    return exam


def read_line(line: dict[str, Any]) -> KeyLine:
    return read_key_line(json.dumps(line).encode())


def first_line(exam: Path) -> dict[str, Any]:
    line: dict[str, Any] = json.loads(
        (exam / "key.jsonl").read_text(encoding="utf-8").splitlines()[0]
    )
    return line
