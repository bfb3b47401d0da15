"""A file's name says what is in it: nothing of one kind is written under the name of another."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Literal

from kinegrade.errors import OutputError
from kinegrade.language.message import Fault, Message, list_choices

Kind = Literal["pdf", "html", "csv", "xlsx", "toml", "svg", "zip", "grades"]

_ENDINGS: Mapping[Kind, tuple[str, ...]] = {
    "pdf": (".pdf",),
    "html": (".html", ".htm"),
    "csv": (".csv",),
    "xlsx": (".xlsx",),
    "toml": (".toml",),
    "svg": (".svg",),
    "zip": (".zip",),
    "grades": (".csv", ".txt", ".tsv", ".xls"),  # text, as systems name it
}
_FILLED_IN: frozenset[Kind] = frozenset({"csv", "xlsx", "toml", "grades"})  # by people, afterwards
# Kinds that nothing here writes, but that people ask for
_OTHERS = (".docx", ".tex", ".md", ".txt", ".json", ".jsonl", ".xml", ".png", ".xls", ".ods")


def is_filled_in(kind: Kind) -> bool:
    """Whether people write into files of a kind, so that each of them may hold their work."""
    return kind in _FILLED_IN


def require_ending(path: Path, kind: Kind) -> None:
    """Raises OutputError where a name ends as files of another kind do; one without an ending that
    says a kind is taken as it is.
    """
    ending, fitting = path.suffix.lower(), _ENDINGS[kind]
    known = {each for endings in _ENDINGS.values() for each in endings} | {*_OTHERS}
    if ending in known and ending not in fitting:
        what = Message("files.other-kind", kind=fitting[0].removeprefix(".").upper())
        expected = Message("files.ending", endings=list_choices(fitting))
        raise OutputError(Fault(str(path), what, expected))
