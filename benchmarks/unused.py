"""What nothing in the package uses, by vulture; what it cannot see is listed with the reason."""

from __future__ import annotations

import re
from pathlib import Path

from vulture import Vulture

SEEN_BY_OTHERS = {
    "compress_type": "zipfile reads it",
    "create_system": "zipfile reads it",
    "external_attr": "zipfile reads it",
    "font": "openpyxl reads it",
    "freeze_panes": "openpyxl reads it",
    "ref": "openpyxl reads it",
    "print_title_rows": "openpyxl reads it",
    "fitToHeight": "openpyxl reads it",
    "orientation": "openpyxl reads it",
    "pageSetUpPr": "openpyxl reads it",
    "content_separator": "pylatex reads it",
    "filters": "jinja2 reads it",
}
USED_BY_TESTS = {
    "REASONS": "all reasons for a refusal, each of which a test meets",
    "SOURCES": "all systems that responses come from, each of which a test reads",
    "mistake_sentence": "one sentence by its identifier",
    "page_images": "what a page looks like, for characters that no font has",
    "parse_roster": "a roster that stands in the test",
    "read_bank": "a bank in one step, for tests and benchmarks",
    "read_sheet": "a sheet of answers that stands in the test",
    "work_out": "one mistake in any arithmetic, which the run of all of them is held against",
}
TO_GO = {"answer_table": "the responses' former door, which nothing goes through any more"}
_WORD = re.compile(r"words\.(\w+)")


def unused_names(package: Path) -> list[str]:
    """A line for every name that nothing uses: no code, no layout, nothing listed above."""
    listed = [*SEEN_BY_OTHERS, *USED_BY_TESTS, *TO_GO, *_words_of_layouts(package)]
    search = Vulture(ignore_names=listed)
    search.scavenge([str(package)])
    return [
        f"{Path(item.filename).relative_to(package.parent).as_posix()}:{item.first_lineno} "
        f"{item.name}: used nowhere"
        for item in search.get_unused_code()
    ]


def _words_of_layouts(package: Path) -> set[str]:
    """The words that layouts print."""
    files = [file for file in package.rglob("layouts/*") if file.suffix != ".pyc"]
    texts = [file.read_text(encoding="utf-8") for file in files if file.is_file()]
    return {name for text in texts for name in _WORD.findall(text)}
