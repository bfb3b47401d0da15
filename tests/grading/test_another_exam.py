"""Marks of a make-up exam are not taken for those of the exam, by any command."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.small_class import contents, generate, kinegrade, write_class

ANSWERS = "student,q1.v_B,q2.v_y\n007,1.5,4\n0012,2,3\n"
BY_HAND = "student,question,points\n007,q2.v_y,1\n"
COMMANDS = (
    ("explain", "{exam}", "{marks}", "007"),
    ("feedback", "{exam}", "{marks}", "-o", "{out}", "--format", "md"),
    ("report", "{exam}", "{marks}", "-o", "{out}"),
    ("sharing", "{exam}", "{marks}", "-o", "{out}"),
    ("archive", "{exam}", "--marks", "{marks}", "-o", "{out}"),
    ("export", "{marks}", "--to", "moodle", "--exam", "{exam}", "-o", "{out}"),
    ("grade", "{exam}", "{answers}", "-o", "{out}", "--never-lower", "{marks}"),
    ("grade", "{exam}", "{answers}", "-o", "{out}", "--since", "{marks}", "--reason", "Appeals"),
    ("forget", "{exam}", "{marks}", "--yes"),
)


@pytest.fixture(scope="module")
def term(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """EXAM and LATER of one bank and the same students, with their marks; one by hand in each."""
    folder = write_class(tmp_path_factory.mktemp("term"))
    (folder / "answers.csv").write_text(ANSWERS, encoding="utf-8")
    (folder / "hand.csv").write_text(BY_HAND, encoding="utf-8")
    for name in ("EXAM", "LATER"):
        made = generate(folder, name, "--reproducible", name, "--no-papers")
        assert made.exit_code == 0, made.stderr
        mark(folder, name)
    return folder


def mark(folder: Path, exam: str, *options: str) -> None:
    """The marks of an exam, in a folder of its name and `-MARKS`."""
    files = folder / exam, folder / "answers.csv", "-o", folder / f"{exam}-MARKS"
    marked = kinegrade("grade", *files, "--manual", folder / "hand.csv", *options)
    assert marked.exit_code in (0, 1), marked.stderr


def run(folder: Path, command: tuple[str, ...], marks: str, out: Path) -> tuple[int, str]:
    places = {"exam": folder / "EXAM", "marks": folder / marks, "out": out}
    places["answers"] = folder / "answers.csv"
    done = kinegrade(*(each.format_map(places) for each in command))
    return done.exit_code, done.stderr.rstrip()


@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
def test_marks_of_another_exam_are_refused(
    term: Path, tmp_path: Path, command: tuple[str, ...]
) -> None:
    before = contents(term)
    assert run(term, command, "LATER-MARKS", tmp_path / "out") == (
        2,
        f"error: {term}/LATER-MARKS: these are marks of another exam than {term}/EXAM"
        " - name the exam folder by which these marks were made",
    )
    assert contents(term) == before
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("by_hand", [True, False])
def test_marks_of_another_exam_are_not_replaced(
    term: Path, tmp_path: Path, *, by_hand: bool
) -> None:
    shutil.copytree(term / "LATER-MARKS", tmp_path / "MARKS")
    if not by_hand:
        (tmp_path / "MARKS" / "manual.csv").unlink()
    before = contents(tmp_path)
    command = "grade", "{exam}", "{answers}", "-o", "{marks}", "--force"
    assert run(term, command, str(tmp_path / "MARKS"), tmp_path) == (
        2,
        f"error: {tmp_path}/MARKS: these are marks of another exam than {term}/EXAM"
        " - choose another folder, or remove this one if nobody needs these marks any more",
    )
    assert contents(tmp_path) == before
    code, _ = run(term, command, "EXAM-MARKS", tmp_path)
    assert code in (0, 1)


def test_markings_of_two_exams_are_not_compared(
    term: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(term)
    done = kinegrade("diff", "EXAM-MARKS", "LATER-MARKS")
    said = "LATER-MARKS: has marks of another exam than EXAM-MARKS - name two markings of one exam"
    assert (done.exit_code, done.stderr) == (2, f"error: {said}\n")


def test_two_markings_of_one_exam_are_not_two_parts_of_a_term(
    term: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(term)
    files = "EXAM", "answers.csv", "-o", tmp_path / "AGAIN"
    assert kinegrade("grade", *files).exit_code in (0, 1)
    done = kinegrade("term", "EXAM-MARKS", tmp_path / "AGAIN", "-o", tmp_path / "term.csv")
    assert done.exit_code == 2
    said = (
        f"{tmp_path / 'AGAIN'}: has marks of the same exam as EXAM-MARKS - leave one of the two out"
    )
    assert said in done.stderr
    assert not (tmp_path / "term.csv").exists()


@pytest.mark.parametrize("command", COMMANDS[:-1], ids=" ".join)
def test_those_of_the_exam_are_taken_by_every_command(
    term: Path, tmp_path: Path, command: tuple[str, ...]
) -> None:
    code, said = run(term, command, "EXAM-MARKS", tmp_path / "out")
    assert code in (0, 1), said


def test_marks_of_earlier_versions_do_not_say_of_which_exam_they_are(
    term: Path, tmp_path: Path
) -> None:
    (term / "LATER-MARKS" / "exam.csv").rename(tmp_path / "exam.csv")
    try:
        code, said = run(term, COMMANDS[0], "LATER-MARKS", tmp_path / "out")
    finally:
        (tmp_path / "exam.csv").rename(term / "LATER-MARKS" / "exam.csv")
    assert code == 0, said


def test_merged_marks_go_by_the_first_exam(term: Path, tmp_path: Path) -> None:
    folders = term / "EXAM-MARKS", term / "LATER-MARKS"
    merged = kinegrade("merge", *folders, "-o", tmp_path / "ALL", "--prefer", "first")
    assert merged.exit_code in (0, 1), merged.stderr
    page = "-o", tmp_path / "page.html"
    assert kinegrade("report", term / "EXAM", tmp_path / "ALL", *page).exit_code == 0
    refused = kinegrade("report", term / "LATER", tmp_path / "ALL", *page, "--force")
    assert "ALL: these are marks of another exam than" in refused.stderr


def test_late_students_leave_it_the_same_exam(term: Path, tmp_path: Path) -> None:
    (tmp_path / "late.csv").write_text("student,name\n0099,Eve\n", encoding="utf-8")
    files = term / "bank.toml", term / "roster.csv", "-o", term / "LATER", "--allow-odd-ids"
    added = kinegrade("generate", *files, "--add", tmp_path / "late.csv")
    assert added.exit_code in (0, 1), added.stderr
    page = tmp_path / "page.html"
    again = kinegrade("report", term / "LATER", term / "LATER-MARKS", "-o", page)
    assert again.exit_code in (0, 1), again.stderr


def test_forgotten_marks_still_go_with_their_exam_alone(term: Path, tmp_path: Path) -> None:
    forgotten = kinegrade("forget", term / "LATER", term / "LATER-MARKS", "--yes")
    assert forgotten.exit_code == 0, forgotten.stderr
    page = "-o", tmp_path / "page.html"
    taken = kinegrade("report", term / "LATER", term / "LATER-MARKS", *page)
    assert taken.exit_code in (0, 1), taken.stderr
    refused = kinegrade("report", term / "EXAM", term / "LATER-MARKS", *page, "--force")
    assert "LATER-MARKS: these are marks of another exam than" in refused.stderr


@pytest.mark.parametrize(
    "options",
    [
        ("-o", "{out}", "--since", "{merged}", "--reason", "Appeals"),
        ("-o", "{out}", "--never-lower", "{merged}"),
        ("-o", "{merged}", "--force"),
    ],
    ids=" ".join,
)
def test_marks_that_a_make_up_gave_do_not_flow_into_those_of_the_exam(
    term: Path, tmp_path: Path, options: tuple[str, ...]
) -> None:
    merged = tmp_path / "MERGED"
    folders = term / "EXAM-MARKS", term / "LATER-MARKS"
    assert kinegrade("merge", *folders, "-o", merged, "--prefer", "last").exit_code in (0, 1)
    before = contents(merged)
    command = ("grade", "{exam}", "{answers}", *options)
    places = {"exam": term / "EXAM", "answers": term / "answers.csv", "merged": merged}
    done = kinegrade(*(each.format_map({**places, "out": tmp_path / "out"}) for each in command))
    assert done.exit_code == 2
    assert (
        f"error: {merged}: the marks of 4 students are taken from other marks, put beside these by "
        "merge - name the folder in which this exam was marked, and merge anew"
    ) in done.stderr
    assert contents(merged) == before
