"""`generate --no-papers`: an exam that is set and not printed; a paper costs when it is fetched."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import pytest

from tests.exam.test_resuming import has, interrupt, write_files
from tests.small_class import contents, generate, kinegrade, write_class

PRINTED = {"papers.pdf", "key.pdf", "spare-key.pdf"}


def without_prints(folder: Path) -> dict[str, bytes]:
    """What an exam holds beside what was printed and its head."""
    found = contents(folder)
    return {
        name: content
        for name, content in found.items()
        if name not in {*PRINTED, "exam.json"} and not name.startswith("papers/")
    }


def read_head(folder: Path) -> dict[str, object]:
    head = json.loads((folder / "exam.json").read_text(encoding="utf-8"))
    assert isinstance(head, dict)
    return head


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A class with one exam that is printed and one that is not, of the same numbers."""
    folder = write_class(tmp_path_factory.mktemp("unprinted"))
    for name, options in (("EXAM", ()), ("SET", ("--no-papers",))):
        result = generate(folder, name, "--spare", "1", *options)
        assert result.exit_code == 0, result.stderr
    return folder


def refusal(*arguments: str | Path) -> str:
    result = kinegrade(*arguments)
    assert result.exit_code == 2
    (line,) = result.stderr.splitlines()
    return line


def test_the_exam_is_the_same_but_for_what_is_printed(folder: Path) -> None:
    assert without_prints(folder / "SET") == without_prints(folder / "EXAM")
    assert [name for name in (*PRINTED, "papers") if (folder / "SET" / name).exists()] == []
    printed, unprinted = read_head(folder / "EXAM"), read_head(folder / "SET")
    assert unprinted.pop("unprinted") is True
    assert printed.pop("pages")
    assert printed == unprinted


def test_a_paper_that_is_fetched_has_the_bytes_of_a_printed_one(folder: Path) -> None:
    fetched = kinegrade("paper", folder / "SET", "007")
    assert (fetched.exit_code, fetched.stderr) == (0, "")
    assert fetched.stdout_bytes == (folder / "EXAM" / "papers" / "007.pdf").read_bytes()


def test_it_is_said_how_a_paper_is_printed(tmp_path: Path) -> None:
    said = generate(write_class(tmp_path), "SET", "--no-papers").stderr
    assert "SET: numbers and key for 4 students, no paper printed; kinegrade paper" in said
    assert "kinegrade papers" not in said


def test_it_is_marked_reported_and_solved_like_a_printed_one(folder: Path, tmp_path: Path) -> None:
    sheet = tmp_path / "answers.csv"
    with (folder / "SET" / "answers.csv").open(encoding="utf-8-sig", newline="") as blank:
        rows = list(csv.reader(blank))
    rows[1][2:] = ["1"] * len(rows[1][2:])
    with sheet.open("w", encoding="utf-8", newline="") as filled:
        csv.writer(filled).writerows(rows)
    for name in ("EXAM", "SET"):
        exam, marks = folder / name, tmp_path / f"M-{name}"
        assert kinegrade("grade", exam, sheet, "-o", marks).exit_code == 0
        for command, place in (("report", f"{name}.html"), ("feedback", f"feedback-{name}")):
            result = kinegrade(command, exam, marks, "-o", tmp_path / place)
            assert result.exit_code == 0, result.stderr
    assert contents(tmp_path / "feedback-SET") == contents(tmp_path / "feedback-EXAM")
    grades = [(tmp_path / f"M-{name}" / "grades.csv").read_bytes() for name in ("EXAM", "SET")]
    assert grades[0] == grades[1]
    said = kinegrade("explain", folder / "SET", tmp_path / "M-SET", "007").stdout
    assert "kinegrade paper" in said


def test_handing_it_out_is_refused_with_what_to_do(folder: Path, tmp_path: Path) -> None:
    line = refusal("papers", folder / "SET", "-o", tmp_path / "OUT")
    assert "has no papers: it was generated with --no-papers" in line
    assert "print one with kinegrade paper EXAM STUDENT -o FILE, or all with the same" in line


def test_papers_in_other_kinds_of_files_are_refused(tmp_path: Path) -> None:
    result = generate(write_class(tmp_path), "SET", "--no-papers", "--also", "html")
    assert result.exit_code == 2
    assert "--no-papers: with --also html - expected papers that are printed later" in result.stderr
    assert not (tmp_path / "SET").exists()


def test_the_whole_class_is_printed_later_with_the_same_numbers(tmp_path: Path) -> None:
    folder = write_class(tmp_path)
    generate(folder, "EXAM", "--no-papers")
    result = generate(folder, "EXAM", "--force")
    assert "4 papers keep their numbers, 0 changed" in result.stderr
    assert len(list((folder / "EXAM" / "papers").iterdir())) == 4
    assert "unprinted" not in read_head(folder / "EXAM")


def test_solutions_late_students_and_corrections_leave_it_unprinted(tmp_path: Path) -> None:
    folder = write_class(tmp_path)
    generate(folder, "EXAM", "--no-papers", "--spare", "1")
    exam = folder / "EXAM"
    solved = kinegrade("solutions", exam, "007")
    assert solved.exit_code == 0, solved.stderr
    (folder / "late.csv").write_text("student,name\nlate,Lou\n", encoding="utf-8")
    files = folder / "bank.toml", folder / "roster.csv", "-o", exam
    late = "--add", folder / "late.csv", "--allow-odd-ids"
    assert "1 paper added, 4 stay" in kinegrade("generate", *files, *late).stderr
    assert (exam / "solutions" / "late.pdf").is_file()
    spare = read_head(exam)["spares"]
    assert isinstance(spare, list)
    assigned = kinegrade("assign", exam, spare[0]["paper"], "new", "--name", "Nora")
    assert assigned.exit_code == 0, assigned.stderr
    template = exam / "templates" / "crank.toml"
    (folder / "crank.toml").write_bytes(template.read_bytes())
    again = kinegrade("reprint", exam, "--template", folder / "crank.toml", "--jobs", "1")
    assert again.exit_code == 0, again.stderr
    assert again.stderr == (
        f"{exam}: has the corrected template; its papers are not printed, and are fetched with it\n"
    )
    assert [name for name in (*PRINTED, "papers") if (exam / name).exists()] == []
    for student in ("late", "new"):
        assert kinegrade("paper", exam, student).stdout_bytes.startswith(b"%PDF")
    assert kinegrade("verify", exam, "--all").exit_code == 0


def test_texts_that_cannot_be_printed_are_found_when_the_exam_is_set(tmp_path: Path) -> None:
    folder = write_class(tmp_path)
    bank = (folder / "bank.toml").read_text(encoding="utf-8")
    (folder / "bank.toml").write_text(bank.replace("Mechanics", "Mech\u0b83nics"), encoding="utf-8")
    result = generate(folder, "EXAM", "--no-papers")
    assert (result.exit_code, (folder / "EXAM").exists()) == (2, False)
    assert "no font prints ஃ (U+0B83)" in result.stderr


def test_killed_it_is_resumed_with_the_same_bytes(tmp_path: Path) -> None:
    folder, options = write_files(tmp_path), ("--no-papers", "--reproducible", "spring")
    assert generate(folder, "WHOLE", "--no-papers").exit_code == 0
    assert interrupt(folder, has("key.jsonl"), *options, "--resume")
    result = generate(folder, "EXAM", "--no-papers", "--resume")
    assert result.exit_code == 0, result.stderr
    assert contents(folder / "EXAM") == contents(folder / "WHOLE")
