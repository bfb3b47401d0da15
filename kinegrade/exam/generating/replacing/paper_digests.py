"""Whether two papers are the same, by digests of what stands on them and in their key."""

from __future__ import annotations

from hashlib import sha256

from msgspec import json, structs

from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.key.lines import KeyLine, StatedAnswer


def paper_digests(exam: ExamFolder) -> dict[str, bytes]:
    """For each student of the key a digest of what the paper asks and what is right on it. Raises
    ExamError.
    """
    return {line.student: _paper_digest(line) for line in exam.keys.lines()}


def _paper_digest(line: KeyLine) -> bytes:
    """A digest of a paper and of what its marks depend on: without the known mistakes, which are
    not on the paper, and without what folders of format 1 do not keep.
    """
    questions = tuple(
        structs.replace(
            question, drawn={}, asks=dict(map(_without_mistakes, question.asks.items()))
        )
        for question in line.questions
    )
    paper = structs.replace(line, place=None, questions=questions)
    return sha256(json.encode(paper, order="sorted")).digest()


def _without_mistakes(named: tuple[str, StatedAnswer]) -> tuple[str, StatedAnswer]:
    """An ask by its name, without what known mistakes lead to."""
    name, answer = named
    return name, structs.replace(answer, mistakes={})
