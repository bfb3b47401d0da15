"""How many pages the printed solutions of templates take, and how far down their last page is
filled.

`python -m tests.worked.lengths [LANGUAGE [TEMPLATE...]]` lists them.
"""

from __future__ import annotations

import subprocess
import sys
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass

from kinegrade.exam.printing.sample import print_worked_solution
from kinegrade.language import Language
from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_shipped, list_names, load_template
from kinegrade.problem.template.template import Method
from tests.exam.printed_pages import split_images

_DPI = 18
_PAPER_WHITE = 250  # of 255: anything darker is printed
_HEAD, _FOOT = 18.0, 15.5  # millimetres that the running head and foot take
_MM = _DPI / 25.4


@dataclass(frozen=True)
class Length:
    """The pages of a solution, each with the share of its height down to its last line."""

    filled: tuple[float, ...]

    @property
    def pages(self) -> int:
        """How many pages the solution has."""
        return len(self.filled)


def measure_length(
    name: str,
    language: Language = "en",
    given: Mapping[str, str] | None = None,
    method: Method | None = None,
) -> Length:
    """The length of a template's solution at the values given, or at the published ones."""
    return measure_printed_length(
        solve_template(load_template(name), given or {}), language, method
    )


def measure_printed_length(
    solution: Solution, language: Language, method: Method | None = None
) -> Length:
    """The length of the solution of an instance."""
    pdf = print_worked_solution(solution, language, method=method)
    command = ["pdftoppm", "-r", str(_DPI), "-gray", "-"]
    images = subprocess.run(command, input=pdf, capture_output=True, check=True).stdout
    return Length(tuple(_measure_pages(images)))


def _measure_pages(images: bytes) -> list[float]:
    """The share of each page that is filled, from the images of the pages one after another."""
    return [_find_lowest(rows) for rows in split_images(images)]


def _find_lowest(rows: list[bytes]) -> float:
    """How far down the last printed row lies between head and foot, from 0 to 1."""
    body = rows[round(_HEAD * _MM) : len(rows) - round(_FOOT * _MM)]
    printed = [place for place, row in enumerate(body, start=1) if min(row) < _PAPER_WHITE]
    return max(printed, default=0) / len(body)


def main(words: list[str]) -> None:
    """Print a line for each template, and how many templates take how many pages."""
    language = words[0] if words else "en"
    names = words[1:] or list_names(find_shipped("templates"))
    lengths = {}
    for name in names:
        lengths[name] = measure_length(name, language)
        shares = " ".join(f"{share:4.0%}" for share in lengths[name].filled)
        print(f"{name:44} {lengths[name].pages}  {shares}", flush=True)
    counts = Counter(length.pages for length in lengths.values())
    print("  ".join(f"{count} of {pages} pages" for pages, count in sorted(counts.items())))


if __name__ == "__main__":
    main(sys.argv[1:])
