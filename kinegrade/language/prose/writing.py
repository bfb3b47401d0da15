"""Prose for targets that are written as text: what differs in its formulas alone is laid out once.

The papers of a class share their words and differ in their numbers.
"""

from __future__ import annotations

import re
from abc import abstractmethod
from functools import cached_property, lru_cache, partial
from itertools import chain

from markdown_it import MarkdownIt

from kinegrade.errors import TypesetError
from kinegrade.language.message import Location
from kinegrade.language.prose.rendering import ProseRenderer, make_reader

_FORMULA = re.compile(r"\$([^$\n]+)\$")
_GAP = "\ue000"  # stands for each formula while the words are laid out: no formula may hold it
_MISREAD = ("\\$", "`", _GAP)  # where dollar signs may not enclose a formula


class TextRenderer(ProseRenderer[str]):
    """A target whose pieces are texts to be written one after another."""

    def formula(self, latex: str, where: Location) -> str:
        """A formula in its line, or the gap that is left for one."""
        return latex if latex == _GAP else self.inline_formula(latex, where)

    def formula_block(self, latex: str, where: Location) -> str:
        """A formula between paragraphs, as in one."""
        return self.displayed_formula(latex, where)

    @abstractmethod
    def inline_formula(self, latex: str, where: Location) -> str:
        """A formula in its line. Raises TypesetError."""


class ProseWriter:
    """Writes prose in the form of one target, and keeps what papers have in common."""

    def __init__(self, renderer: type[TextRenderer]) -> None:
        self._renderer = renderer()
        self._make_reader = partial(make_reader, renderer)
        self._lay_out_words_once = lru_cache(maxsize=1024)(self._lay_out_words)
        self._lay_out_line_once = lru_cache(maxsize=4096)(self._lay_out_line)

    def write_prose(self, markdown: str, where: Location) -> str:
        """Several paragraphs. Raises TypesetError with every fault of the text, each naming
        `where`.
        """
        around = self._write_around_formulas(markdown)
        return self._lay_out(markdown, where) if around is None else around

    def write_line(self, markdown: str, where: Location) -> str:
        """One line: a title, the meaning of a symbol. Raises TypesetError as `write_prose` does."""
        try:
            return self._lay_out_line_once(markdown, "")
        except TypesetError:
            return self._lay_out_line(markdown, where)

    @cached_property
    def _reader(self) -> MarkdownIt:
        return self._make_reader()

    def _lay_out(self, markdown: str, where: Location) -> str:
        return "".join(self._reader.render(markdown, {"where": where}))

    def _lay_out_line(self, markdown: str, where: Location) -> str:
        return "".join(self._reader.renderInline(markdown, {"where": where}))

    def _lay_out_words(self, words: str) -> list[str]:
        """What stands between the gaps."""
        return self._lay_out(words, "").split(_GAP)

    def _write_around_formulas(self, markdown: str) -> str | None:
        """A text whose words may be known already; None if it must be read as a whole, for instance
        to report its faults.
        """
        parts = _FORMULA.split(markdown)
        formulas = parts[1::2]
        if markdown.count("$") != 2 * len(formulas) or any(odd in markdown for odd in _MISREAD):
            return None
        try:
            between = self._lay_out_words_once(f"${_GAP}$".join(parts[::2]))
            if len(between) != len(formulas) + 1:
                return None
            written = [self._renderer.inline_formula(latex.strip(), "") for latex in formulas]
        except TypesetError:
            return None
        return "".join(chain.from_iterable(zip(between, [*written, ""], strict=True)))
