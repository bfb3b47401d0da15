"""What nothing in the package uses, by vulture; what it cannot see is listed with the reason."""

from __future__ import annotations

from pathlib import Path

from vulture import Vulture

SEEN_BY_OTHERS = {
    "__*__": "Python calls them",
    "compress_type": "zipfile reads it",
    "create_system": "zipfile reads it",
    "external_attr": "zipfile reads it",
    "cards": "the layout of the class report reads it",
    "few": "the layout of the class report reads it",
    "hardness": "the layout of the class report reads it",
    "legend": "the layout of the class report reads it",
    "more_complaints": "the layout of the class report reads it",
    "number_of_complaints": "the layout of the class report reads it",
    "riders": "the script of a practice sheet reads it",
    "font": "openpyxl reads it",
    "StartElementHandler": "expat calls it",
    "EndElementHandler": "expat calls it",
    "CharacterDataHandler": "expat calls it",
    "freeze_panes": "openpyxl reads it",
    "ref": "openpyxl reads it",
    "print_title_rows": "openpyxl reads it",
    "fitToHeight": "openpyxl reads it",
    "orientation": "openpyxl reads it",
    "pageSetUpPr": "openpyxl reads it",
    "_repr_html_": "a notebook calls it",
    "_repr_latex_": "a notebook calls it",
    "_repr_svg_": "a notebook calls it",
    "__dir__": "Python calls it",
    "__getattr__": "Python calls it",
    "content_separator": "pylatex reads it",
    "filters": "jinja2 reads it",
    "get_metavar": "click calls it",
    "help": "click reads it",
    "latex_name": "pylatex reads it",
    "parser": "markdown-it gives it to its renderers",
    "sympy": "a public method, for those who calculate on",
}
USED_BY_TESTS = {
    "greatest": "by how much the positions of a path miss their conditions",
    "choose_way": "the way of one mistake, for a student who makes it in a benchmark",
    "list_help_keys": "the entries of help, which no other code names",
    "SOURCES": "all systems that responses come from, each of which a test reads",
    "page_images": "what a page looks like, for characters that no font has",
    "parse_roster": "a roster that stands in the test",
    "read_bank": "a bank in one step, for tests and benchmarks",
    "read_sheet": "a sheet of answers that stands in the test",
    "work_out": "one mistake in any arithmetic, which the run of all of them is held against",
}


def unused_names(package: Path) -> list[str]:
    """A line for every name that nothing uses: no code, nothing listed above."""
    listed = [*SEEN_BY_OTHERS, *USED_BY_TESTS]
    search = Vulture(ignore_names=listed)
    search.scavenge([str(package)])
    return [
        f"{Path(item.filename).relative_to(package.parent).as_posix()}:{item.first_lineno} "
        f"{item.name}: used nowhere"
        for item in search.get_unused_code()
    ]
