"""Texts from files as a line on the terminal shows them."""

from __future__ import annotations


def show_in_one_line(text: str) -> str:
    """A text from a file as a message shows it: unprintable characters become dots.

    >>> show_in_one_line("1 +\\n2")
    '1 +·2'
    """
    return "".join(letter if letter.isprintable() else "·" for letter in text)


def shorten(text: str, longest: int = 300) -> str:
    """A text as a part of a one-line message, cut where it is too long.

    >>> shorten("a very long text", 10)
    'a very lo…'
    """
    line = show_in_one_line(text)
    return line if len(line) <= longest else f"{line[: longest - 1]}…"
