"""The page about the files that kinegrade writes: exam folders and marks folders."""

from __future__ import annotations

from collections.abc import Mapping
from types import ModuleType

from docs.generator.described import read_constants, read_words
from docs.generator.markdown import write_code, write_page, write_table, write_words
from kinegrade.exam.folder import contents
from kinegrade.marks_folder import layout

_LAYOUT = "kinegrade.marks_folder.layout"
_JUDGE = "kinegrade.grading.judging.judge"


def write_folder_page() -> str:
    """The files of EXAM and MARKS with their columns."""
    return write_page(
        "# Files of EXAM and MARKS",
        "## EXAM",
        "`kinegrade generate` writes this folder, and everything later reads it. Students may see "
        f"{' and '.join(map(write_code, contents.FOR_STUDENTS))}; the rest gives the key away, and "
        "only its owner can open it (`--share-with-group`: the group of the folder too).",
        write_table(("file", "holds"), _list_files(contents)),
        f"{write_code('papers.pdf')} and {write_code('solutions.pdf')} hold all papers and all "
        "solutions in one file each, with every student on sheets of their own.",
        "## MARKS",
        "`kinegrade grade` writes this folder; `moodle.csv`, which Moodle imports as it is, stands "
        "in it too.",
        write_table(("file", "holds", "columns"), _list_tables()),
        "### Columns of marks.csv",
        write_words("column", read_words(_LAYOUT, "ANSWER_COLUMNS")),
        "### Columns of grades.csv",
        "Between `name` and `total` stands a column for each question.",
        write_words(
            "column",
            {
                **read_words(_LAYOUT, "BEFORE_QUESTIONS"),
                **read_words(_LAYOUT, "AFTER_QUESTIONS"),
                **read_words(_LAYOUT, "WHERE_NEEDED"),
            },
        ),
        "### Verdicts",
        write_words("verdict", read_words(_JUDGE, "Kind")),
    )


def _list_files(module: ModuleType) -> list[tuple[str, str]]:
    """The files that a module names, with what each holds."""
    described = _read_described(module)
    return [(write_code(str(file)), meaning) for file, meaning in described.items()]


def _read_described(module: ModuleType) -> Mapping[object, str]:
    """The values of a module's constants with their descriptions."""
    constants = read_constants(module.__name__)
    return {getattr(module, name): meaning for name, meaning in constants.items()}


def _list_tables() -> list[tuple[str, str, str]]:
    rows = []
    for file, meaning in _read_described(layout).items():
        match file:
            case layout.TableFile(name, columns):
                rows.append((write_code(name), meaning, ", ".join(map(write_code, columns))))
            case str():
                rows.append((write_code(file), meaning, ""))
    return rows
