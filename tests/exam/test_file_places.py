"""No folder of an exam has more than a thousand files: papers, solutions and sheets of a large
class stand in numbered folders, and everything that reads them finds them there.
"""

from __future__ import annotations

import json
import shutil
from collections import Counter
from pathlib import Path

import pytest

from kinegrade.exam.roster import students
from kinegrade.exam.roster.students import choose_places, read_place
from tests.small_class import contents, generate, kinegrade, table, write_class, write_short_class

FEW = 2


def count_files(folder: Path) -> Counter[str]:
    """How many files each folder below this one has."""
    files = (file for file in folder.rglob("*") if file.is_file())
    return Counter(file.parent.relative_to(folder).as_posix() for file in files)


def run(*arguments: str | Path) -> str:
    """What a command prints on standard output, which has to succeed."""
    result = kinegrade(*arguments)
    assert result.exit_code == 0, result.stderr
    return result.stdout


@pytest.fixture
def small_folders(monkeypatch: pytest.MonkeyPatch) -> None:
    """Folders that hold two files."""
    monkeypatch.setattr(students, "MOST_TOGETHER", FEW)


@pytest.fixture(scope="module")
def generated(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A class with an exam of four students and a spare paper in such folders."""
    folder, options = tmp_path_factory.mktemp("class"), ("--solutions", "--spare", "1")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(students, "MOST_TOGETHER", FEW)
        result = generate(write_class(folder), "EXAM", *options, "--jobs", "1")
    assert result.exit_code == 0, result.stderr
    return folder


@pytest.fixture
def exam(generated: Path, small_folders: None, tmp_path: Path) -> Path:
    """The exam, with all that it was generated from beside it."""
    shutil.copytree(generated, tmp_path, dirs_exist_ok=True)
    return tmp_path / "EXAM"


def test_a_thousand_files_stand_side_by_side() -> None:
    names = [str(number) for number in range(1000)]
    assert choose_places(names) == names


def test_of_more_each_thousand_has_a_folder() -> None:
    places = choose_places([str(number) for number in range(2001)])
    assert [places[0], places[999], places[1000], places[2000]] == [
        "00/0",
        "00/999",
        "01/1000",
        "02/2000",
    ]


def test_a_folder_holds_fewer_students_with_several_files() -> None:
    counts = Counter(place.partition("/")[0] for place in choose_places(["x"] * 700, each=3))
    assert counts == {"00": 333, "01": 333, "02": 34}


@pytest.mark.parametrize(
    ("file", "place"),
    [("papers/0012.pdf", "0012"), ("papers/07/a.b.pdf", "07/a.b"), ("", "")],
)
def test_the_place_of_a_paper_is_read_from_its_file(file: str, place: str) -> None:
    assert read_place(file) == place


def test_papers_and_solutions_stand_in_numbered_folders(exam: Path) -> None:
    assert count_files(exam / "papers") == {"00": 2, "01": 2, "02": 1}
    assert count_files(exam / "solutions") == {"00": 2, "01": 2, "02": 1}
    head = json.loads((exam / "exam.json").read_text(encoding="utf-8"))
    assert [each["file"] for each in head["students"]] == [
        "papers/00/007.pdf",
        "papers/00/0012.pdf",
        "papers/01/a%2Fb.pdf",
        "papers/01/%3D2.pdf",
    ]


def test_the_papers_are_those_of_one_folder(generated: Path, tmp_path: Path) -> None:
    whole = generate(write_class(tmp_path), "EXAM", "--solutions", "--spare", "1", "--jobs", "1")
    assert whole.exit_code == 0, whole.stderr
    for name in ("papers", "solutions"):
        here, there = generated / "EXAM" / name / "01", tmp_path / "EXAM" / name
        assert (here / "a%2Fb.pdf").read_bytes() == (there / "a%2Fb.pdf").read_bytes()


def test_a_paper_is_found_in_its_folder(exam: Path) -> None:
    here = exam / "papers" / "01" / "a%2Fb.pdf"
    assert kinegrade("paper", exam, "a/b").stdout_bytes == here.read_bytes()


def test_several_kinds_of_files_share_a_folder(small_folders: None, tmp_path: Path) -> None:
    kinds = ("--also", "html", "--engine", "latex")
    generate(write_short_class(tmp_path), "EXAM", *kinds, "--jobs", "1")
    papers = tmp_path / "EXAM" / "papers"
    assert count_files(papers) == {"00": 2, "01": 2, "02": 2, "03": 2}
    sources = tmp_path / "EXAM" / "tex" / "papers"
    assert {"kinegrade.sty", "0012.tex"} <= {file.name for file in (sources / "01").iterdir()}


def test_they_are_handed_out_in_the_same_folders(exam: Path, tmp_path: Path) -> None:
    out, listed = tmp_path / "OUT", tmp_path / "send.csv"
    run("papers", exam, "-o", out, "--send-list", listed)
    assert contents(out) == contents(exam / "papers")
    files = [Path(row["file"]) for row in table(listed)]
    assert [file.relative_to(out.resolve()).as_posix() for file in files] == [
        "00/007.pdf",
        "00/0012.pdf",
        "01/a%2Fb.pdf",
        "01/%3D2.pdf",
    ]
    run("papers", exam, "-o", out, "--force")
    (out / "00" / "notes.txt").write_text("mine", encoding="utf-8")
    refused = kinegrade("papers", exam, "-o", out, "--force")
    assert (refused.exit_code, (out / "00" / "notes.txt").exists()) == (2, True)
    assert "holds 00/notes.txt, which would be lost" in refused.stderr


@pytest.mark.parametrize("file", ["papers/../key.pdf", "papers/00/../x.pdf", "papers/a/x.pdf"])
def test_a_paper_elsewhere_is_refused(exam: Path, tmp_path: Path, file: str) -> None:
    head = (exam / "exam.json").read_text(encoding="utf-8")
    changed = head.replace("papers/00/007.pdf", file)
    (exam / "exam.json").write_text(changed, encoding="utf-8")
    result = kinegrade("papers", exam, "-o", tmp_path / "OUT")
    assert (result.exit_code, (tmp_path / "OUT").exists()) == (2, False)
    assert f'the paper "{file}"' in result.stderr


def test_feedback_with_solutions_stands_in_numbered_folders(exam: Path, tmp_path: Path) -> None:
    marks, out = tmp_path / "MARKS", tmp_path / "FEEDBACK"
    run("grade", exam, exam / "answers.csv", "-o", marks)
    said = run("explain", exam, marks, "a/b")
    assert str(exam / "papers" / "01" / "a%2Fb.pdf") in said
    assert str(exam / "solutions" / "01" / "a%2Fb.pdf") in said
    run("feedback", exam, marks, "-o", out, "--format", "html", "--solutions")
    assert count_files(out / "sheets") == {f"{number:02}": 2 for number in range(4)}
    rows = table(out / "feedback.csv")
    assert [row["file"] for row in rows][:2] == ["sheets/00/007.html", "sheets/01/0012.html"]
    assert 'href="007-solution.pdf"' in (out / rows[0]["file"]).read_text(encoding="utf-8")


def test_those_who_come_late_stand_behind_the_others(exam: Path, tmp_path: Path) -> None:
    (tmp_path / "late.csv").write_text("student,name\nlate,Lou\n", encoding="utf-8")
    files = tmp_path / "bank.toml", tmp_path / "roster.csv", "-o", exam
    run("generate", *files, "--add", tmp_path / "late.csv", "--allow-odd-ids")
    head = json.loads((exam / "exam.json").read_text(encoding="utf-8"))
    run("assign", exam, head["spares"][0]["paper"], "new", "--name", "Nora")
    for kind in ("papers", "solutions"):
        folder = exam / kind / "02"
        assert {file.name for file in folder.iterdir()} == {"late.pdf", "new.pdf"}
        option = ("--solution",) if kind == "solutions" else ()
        for student in ("late", "new"):
            printed = kinegrade("paper", exam, student, *option).stdout_bytes
            assert printed == (folder / f"{student}.pdf").read_bytes()
    run("verify", exam, "--all")


def test_an_exam_of_one_folder_is_added_to_and_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    generate(write_class(tmp_path), "EXAM", "--solutions", "--jobs", "1")
    exam, late = tmp_path / "EXAM", tmp_path / "late.csv"
    solutions = contents(exam / "solutions")
    monkeypatch.setattr(students, "MOST_TOGETHER", FEW)
    late.write_text("student,name\nlate,Lou\n", encoding="utf-8")
    files = tmp_path / "bank.toml", tmp_path / "roster.csv", "-o", exam
    run("generate", *files, "--add", late, "--allow-odd-ids")
    assert count_files(exam / "papers") == {".": 4, "02": 1}
    run("verify", exam, "--all")
    roster = (tmp_path / "roster.csv").read_text(encoding="utf-8")
    (tmp_path / "roster.csv").write_text(f"{roster}late,Lou,\n", encoding="utf-8")
    result = generate(tmp_path, "EXAM", "--force", "--jobs", "1")
    assert result.exit_code == 0, result.stderr
    assert count_files(exam / "solutions") == {"00": 2, "01": 2, "02": 1}
    assert contents(exam / "solutions")["01/a%2Fb.pdf"] == solutions["a%2Fb.pdf"]
