"""Nothing of one kind is written under the name of another, by whichever command."""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.errors import OutputError
from kinegrade.files.endings import require_ending
from tests.grading.marked_folder import RIGHT, mark_class
from tests.small_class import kinegrade

COMMANDS = (
    ("solve slider-crank -o out.html", "PDF", ".pdf"),
    ("solve slider-crank -o out.tex", "PDF", ".pdf"),
    ("show slider-crank -o out.docx", "PDF", ".pdf"),
    ("gallery slider-crank -o out.png", "PDF", ".pdf"),
    ("report EXAM MARKS -o out.pdf", "HTML", ".html or .htm"),
    ("sharing EXAM MARKS -o out.xlsx", "CSV", ".csv"),
    ("diff MARKS MARKS -o out.xlsx", "CSV", ".csv"),
    ("export MARKS --to moodle -o out.xlsx", "CSV", ".csv, .txt, .tsv or .xls"),
    ("export MARKS --to xlsx -o out.csv", "XLSX", ".xlsx"),
)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with EXAM and MARKS."""
    made = tmp_path_factory.mktemp("endings")
    mark_class(made, {"007": RIGHT, "0012": RIGHT})
    return made


@pytest.mark.parametrize(("command", "kind", "endings"), COMMANDS)
def test_a_name_that_promises_another_kind_is_refused(
    folder: Path, command: str, kind: str, endings: str
) -> None:
    words = [
        str(folder / word) if word in ("EXAM", "MARKS") or word.startswith("out.") else word
        for word in command.split()
    ]
    done = kinegrade(*words)
    assert done.exit_code == 2
    said = done.stderr.splitlines()[-1]
    assert f"what is written is a file of the kind {kind} - expected a name that" in said
    assert said.endswith(f"ends in {endings}")
    assert not list(folder.glob("out.*"))


@pytest.mark.parametrize("name", ["page.PDF", "page", "page.2026-11"])
def test_a_name_that_says_the_kind_or_none_is_taken(tmp_path: Path, name: str) -> None:
    done = kinegrade("solve", "slider-crank", "-o", tmp_path / name)
    assert done.exit_code == 0, done.stderr
    assert (tmp_path / name).read_bytes().startswith(b"%PDF")


def test_the_kind_is_told_by_the_last_ending() -> None:
    with pytest.raises(OutputError, match=r"page\.pdf\.csv: what is written"):
        require_ending(Path("page.pdf.csv"), "pdf")
