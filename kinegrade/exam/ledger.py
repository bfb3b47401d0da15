"""The numbers that every part of a class got, known to all processes that draw: a page for each
part, in a folder.
"""

from __future__ import annotations

import json
import os
import time
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

PAUSE = 0.005  # seconds between two looks for a page that another process is about to write

Values = tuple[str, ...]
Numbers = Mapping[str, Values]  # of a paper: the values drawn for each question


@dataclass
class Ledger:
    """The pages in a folder, of which this process has read the first `known`; `taken` has what
    stands on those.
    """

    folder: Path
    known: int = 0
    taken: dict[str, set[Values]] = field(default_factory=lambda: defaultdict(set))

    def write(self, part: int, papers: Sequence[Numbers]) -> None:
        """The page of a part; it appears whole."""
        draft = self.folder / f"{part}.{os.getpid()}"
        draft.write_text(json.dumps(papers), encoding="utf-8")
        draft.replace(self.folder / str(part))

    def read_before(self, part: int) -> None:
        """Read the pages of all parts before this one. Parts are begun in order: a page that is
        missing is waited for.
        """
        while self.known < part:
            page = self.folder / str(self.known)
            while not page.exists():
                time.sleep(PAUSE)
            for paper in json.loads(page.read_text(encoding="utf-8")):
                for question, values in paper.items():
                    self.taken[question].add(tuple(values))
            self.known += 1
