"""Papers that are to have the same number of pages, printed one after the other."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from kinegrade.press.binding.part import count_pages
from kinegrade.press.sheet import Paper


class AlikePapers:
    """Prints each paper with as many pages as the longest before it, or of others, so that few are
    left that have to be printed once more. Large print takes as many as it takes.

    A paper that needs as many pages of its own is the same byte for byte as if it were asked for
    none.
    """

    def __init__(
        self, pages: int | None, longest: int, print_one: Callable[[Paper], bytes]
    ) -> None:
        self._rises = pages is None
        self._most = longest if pages is None else pages
        self._print_one = print_one
        self.counts: list[int] = []

    def __call__(self, paper: Paper) -> bytes:
        """The next paper as PDF. Raises TypesetError."""
        pdf = self._print_one(paper if paper.large else replace(paper, pages=self._most))
        count = count_pages(pdf)
        self.counts.append(count)
        if self._rises and not paper.large:
            self._most = max(self._most, count)
        return pdf

    def find_short(self, papers: Mapping[str, Paper]) -> dict[str, Paper]:
        """Those of the papers that were printed which have too few pages, to be printed with as
        many as the others.
        """
        counted = zip(papers.items(), self.counts, strict=True)
        return {
            name: replace(paper, pages=self._most)
            for (name, paper), count in counted
            if count < self._most and not paper.large
        }
