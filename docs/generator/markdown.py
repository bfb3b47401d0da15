"""Markdown as the pages of the reference use it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence


def write_code(text: str) -> str:
    """A text as code, which may stand in a table."""
    return f"`{text}`"


def write_table(header: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table; cells are Markdown."""
    lines = [header, ["---"] * len(header), *rows]
    return "\n".join(f"| {' | '.join(map(_write_cell, line))} |" for line in lines)


def write_words(title: str, words: Mapping[str, str]) -> str:
    """A table of words with what they mean; `title` heads the words."""
    rows = [(write_code(word), meaning) for word, meaning in words.items()]
    return write_table((title, "meaning"), rows)


def write_page(*blocks: str) -> str:
    """A page of these blocks."""
    return "\n\n".join(blocks) + "\n"


def _write_cell(text: str) -> str:
    return " ".join(text.split()).replace("|", r"\|")
