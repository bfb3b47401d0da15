"""`kinegrade papers --by-group`: one PDF, or one ZIP, for each group of the roster."""

from __future__ import annotations

from pathlib import Path
from zipfile import ZipFile

import pytest

from tests.printed_text import read_pages
from tests.small_class import contents, generate, kinegrade, write_class, write_short_class

ROSTER = """student,name,group
1,Ann,Tue/A
2,Bob,
3,Cem,Tue/A
4,Dan,Wed
"""


@pytest.fixture(scope="module")
def exam(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An exam of two groups, and somebody in none."""
    folder = write_class(tmp_path_factory.mktemp("groups"))
    (folder / "roster.csv").write_text(ROSTER, encoding="utf-8")
    result = generate(folder, "EXAM", "--also", "html")
    assert "complaint: roster.csv: group: nothing for 1 student" in result.stderr
    return folder / "EXAM"


def refusal(*arguments: str | Path) -> str:
    result = kinegrade("papers", *arguments)
    assert result.exit_code == 2
    return result.stderr


def pages(pdf: bytes) -> list[str]:
    return read_pages(pdf)


def test_a_pdf_holds_the_papers_of_a_group_each_on_a_new_sheet(exam: Path, tmp_path: Path) -> None:
    result = kinegrade("papers", exam, "-o", tmp_path / "OUT", "--by-group", "pdf")
    assert "OUT: 4 papers, and nothing that gives the key away" in result.stderr
    found = contents(tmp_path / "OUT")
    assert sorted(found) == ["Tue-A.pdf", "Wed.pdf", "without-group.pdf"]
    alone = {number: pages((exam / "papers" / f"{number}.pdf").read_bytes()) for number in "134"}
    blank = [""] * (len(alone["1"]) % 2)
    assert pages(found["Tue-A.pdf"]) == [*alone["1"], *blank, *alone["3"], *blank]
    assert pages(found["Wed.pdf"]) == [*alone["4"], *blank]


def test_a_zip_holds_every_kind_of_file(exam: Path, tmp_path: Path) -> None:
    for name in ("A", "B"):
        assert kinegrade("papers", exam, "-o", tmp_path / name, "--by-group", "zip").exit_code == 0
    assert contents(tmp_path / "A") == contents(tmp_path / "B")
    with ZipFile(tmp_path / "A" / "Tue-A.zip") as package:
        assert package.namelist() == ["1.pdf", "1.html", "3.pdf", "3.html"]
        assert package.read("3.pdf") == (exam / "papers" / "3.pdf").read_bytes()


def test_spare_papers_have_a_file_beside_those_of_groups(tmp_path: Path) -> None:
    folder = write_short_class(tmp_path)
    roster = "student,name,group\n1,Ann,spare\n2,Bob,\n3,Cem,without-group\n"
    (folder / "roster.csv").write_text(roster, encoding="utf-8")
    generate(folder, "EXAM", "--spare", "2")  # complains of Bob, who has no group
    out = tmp_path / "OUT"
    result = kinegrade("papers", folder / "EXAM", "-o", out, "--by-group", "zip")
    assert (
        "OUT: 5 papers, and nothing that gives the key away; the spare ones are " in result.stderr
    )
    held = {}
    for file in sorted(out.iterdir()):
        with ZipFile(file) as package:
            held[file.name] = package.namelist()
    assert held == {
        "spare.zip": ["1.pdf"],
        "spare-.zip": ["spare-1.pdf", "spare-2.pdf"],
        "without-group.zip": ["3.pdf"],
        "without-group-.zip": ["2.pdf"],
    }


def test_they_replace_themselves_and_nothing_else(exam: Path, tmp_path: Path) -> None:
    out = tmp_path / "OUT"
    assert kinegrade("papers", exam, "-o", out, "--by-group", "pdf").exit_code == 0
    assert kinegrade("papers", exam, "-o", out, "--by-group", "pdf", "--force").exit_code == 0
    (out / "notes.txt").write_text("mine", encoding="utf-8")
    assert "notes.txt" in refusal(exam, "-o", out, "--by-group", "pdf", "--force")


def test_without_groups_it_is_refused(small_class: Path, tmp_path: Path) -> None:
    line = refusal(small_class / "EXAM", "-o", tmp_path / "OUT", "--by-group", "zip")
    assert "no student has a group - expected an exam whose roster has a column group" in line
    assert not (tmp_path / "OUT").exists()


def test_a_list_of_single_files_is_refused(exam: Path, tmp_path: Path) -> None:
    listed = "--send-list", tmp_path / "send.csv"
    line = refusal(exam, "-o", tmp_path / "OUT", "--by-group", "zip", *listed)
    assert "--send-list names a file for each student" in line
