"""The preview: from the saved file to the picture, for edits of shipped templates, in the process
that makes the picture; with the calm that is waited for after a save, without the browser.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from shutil import copy
from tempfile import TemporaryDirectory
from time import perf_counter

from benchmarks.figure_of_merit import Figure
from kinegrade.language import ENGLISH
from kinegrade.preview.parts import Shown, write_part
from kinegrade.problem.template.library.library import find_shipped, find_template_names

AIM, CALM = 0.3, 0.03  # seconds
_EVERY, _SHARE = 2, 0.95
_TITLE, _NUMBER = re.compile(r'(?m)^en = "'), re.compile(r'published = "(\d+)"')


def figures() -> Iterator[Figure]:
    """Seconds from the save to the picture."""
    waits: list[float] = []
    with TemporaryDirectory() as name:
        for template in find_template_names()[::_EVERY]:
            path = Path(copy(find_shipped("templates") / f"{template}.toml", name))
            waits += _measure_edits(path)
    wait = sorted(waits)[int(_SHARE * len(waits))] + CALM
    said = f"from save to picture, 95 of 100 edits of {len(waits)} (peer: 300 ms)"
    yield Figure(said, wait, AIM, 1.0)


def _measure_edits(path: Path) -> Iterator[float]:
    """The seconds after each edit of a file that a page has shown: of its words, and of a value."""
    shown = Shown(path, 0, ENGLISH)
    write_part("problem", shown)
    text = path.read_text(encoding="utf-8")
    reworded = _TITLE.sub('en = "A ', text, count=1)
    revalued = _NUMBER.sub(lambda found: f'published = "{int(found[1]) + 1}"', text, count=1)
    for edited in (reworded, revalued):
        path.write_text(edited, encoding="utf-8")
        start = perf_counter()
        write_part("problem", shown)
        yield perf_counter() - start
