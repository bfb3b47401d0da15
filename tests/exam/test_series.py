"""Homework: several sheets of one bank without repeats, numbered in words and files, with a date on
which they are due and before which no solutions are given out.
"""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path

import pytest
from click.testing import Result
from pypdf import PdfReader

from kinegrade.deadlines.moment import is_past, parse_moment, read_moment, write_moment
from kinegrade.errors import FieldError
from kinegrade.exam.folder.exam_folder import ExamFolder, open_exam
from kinegrade.files.csv_writing import write_csv_text
from kinegrade.grading import exams_beside
from kinegrade.grading.fast.intervals import Intervals, list_intervals
from kinegrade.grading.misplaced import other_sheets
from tests.problem.crank import crank_text
from tests.small_class import contents, key_lines, kinegrade

BANK = """title = { en = "Cranks", zh = "曲柄", de = "Kurbeln" }
course = "Mechanics"
[[questions]]
template = "crank.toml"
draw = { h = [1], r = [2], omega = "1 .. 8 step 1" }
"""


def write(folder: Path, before: str = "", students: int = 2) -> Path:
    """A bank that has eight combinations, and a roster."""
    (folder / "bank.toml").write_text(f"{before}{BANK}", encoding="utf-8")
    (folder / "crank.toml").write_text(crank_text(), encoding="utf-8")
    rows = "".join(f"s{number},Ann {number}\n" for number in range(students))
    (folder / "roster.csv").write_text(f"student,name\n{rows}", encoding="utf-8")
    return folder


def series(folder: Path, sheets: int, *options: str | Path) -> Result:
    files = folder / "bank.toml", folder / "roster.csv", "-o", folder / "HW"
    return kinegrade("series", *files, "--sheets", str(sheets), "--jobs", "1", *options)


def dealt(exam: Path) -> set[str]:
    return {line["questions"][0]["drawn"]["omega"] for line in key_lines(exam)}


def read_paper(exam: Path) -> str:
    pages = PdfReader(exam / "papers" / "s0.pdf").pages
    return " ".join("".join(page.extract_text() for page in pages).split())


@pytest.fixture(scope="module")
def homework(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Three sheets for two students; not to be changed."""
    folder = write(tmp_path_factory.mktemp("series"))
    done = series(folder, 3, "--due", "2099-12-01 18:00 +01:00", "--every", "14")
    assert done.exit_code == 0, done.stderr
    return folder / "HW"


def test_nobody_gets_what_anybody_had_on_another_sheet(homework: Path) -> None:
    sheets = [dealt(homework / f"homework-{number}") for number in (1, 2, 3)]
    assert [len(each) for each in sheets] == [2, 2, 2]
    assert len(set().union(*sheets)) == 6


def test_a_sheet_is_called_by_its_number_and_says_when_it_is_due(homework: Path) -> None:
    first, third = (read_paper(homework / f"homework-{number}") for number in (1, 3))
    assert "Homework 1: Cranks" in first
    assert "2099-12-01 18:00 +01:00" in first
    assert "Homework 3: Cranks" in third
    assert "2099-12-29 18:00 +01:00" in third
    head = open_exam(homework / "homework-3").head
    assert (head.kind, head.title, head.due) == (
        "homework", "Homework 3: Cranks", "2099-12-29 18:00 +01:00",
    )  # fmt: skip


@pytest.mark.parametrize(
    ("language", "title", "due"),
    [("zh", "第1次作业：曲柄", "截止时间"), ("de", "Übungsblatt1:Kurbeln", "Abgabebis")],
)
def test_a_sheet_is_numbered_in_every_language(
    tmp_path: Path, language: str, title: str, due: str
) -> None:
    bank = write(tmp_path) / "bank.toml"
    own = 'template = "crank.toml"\ndraw = { h = [1], r = [2], omega = "1 .. 8 step 1" }'
    shipped = 'template = "slider-crank"\nasks = { v_B = 1 }'  # which is translated
    bank.write_text(BANK.replace(own, shipped), encoding="utf-8")
    done = series(tmp_path, 1, "--due", "2099-12-01 18:00", "--lang", language)
    assert done.exit_code == 0, done.stderr
    text = read_paper(tmp_path / "HW" / "homework-1").replace(" ", "")
    assert title in text
    assert due in text


def test_a_series_is_continued_and_sheets_that_exist_stay(tmp_path: Path) -> None:
    assert series(write(tmp_path), 1).exit_code == 0
    before = contents(tmp_path / "HW" / "homework-1")
    done = series(tmp_path, 2)
    assert done.exit_code == 0, done.stderr
    assert "homework-1: exists and stays as it is" in done.stderr
    assert contents(tmp_path / "HW" / "homework-1") == before
    assert not dealt(tmp_path / "HW" / "homework-1") & dealt(tmp_path / "HW" / "homework-2")


def test_a_series_that_is_continued_avoids_what_its_sheets_avoid(tmp_path: Path) -> None:
    files = write(tmp_path) / "bank.toml", tmp_path / "roster.csv", "-o", tmp_path / "EXAM"
    assert kinegrade("generate", *files, "--no-papers").exit_code == 0
    assert series(tmp_path, 1, "--avoid", tmp_path / "EXAM").exit_code == 0
    done = series(tmp_path, 3)
    assert done.exit_code == 0, done.stderr
    sheets = [dealt(tmp_path / "HW" / f"homework-{number}") for number in (1, 2, 3)]
    assert len(dealt(tmp_path / "EXAM").union(*sheets)) == 8


def test_a_series_continued_by_other_dates_says_which_stay(tmp_path: Path) -> None:
    dates = "2099-12-01 18:00", "2099-12-08 18:00"
    assert series(write(tmp_path), 1, "--due", dates[0]).exit_code == 0
    kept = f"{tmp_path / 'HW' / 'homework-1'}: exists and stays as it is"
    said = [
        series(tmp_path, 1, *options).stderr
        for options in ((), ("--due", dates[1]), ("--due", dates[0]))
    ]
    assert f"{kept} (due {dates[0]}, by this command without a date)" in said[0].splitlines()
    assert f"{kept} (due {dates[0]}, by this command due {dates[1]})" in said[1].splitlines()
    assert kept in said[2].splitlines()


def test_a_series_continued_with_another_class_says_who_has_no_paper_and_who_left(
    tmp_path: Path,
) -> None:
    write(tmp_path, students=2)
    assert series(tmp_path, 1).exit_code == 0
    roster, sheet = tmp_path / "roster.csv", tmp_path / "HW" / "homework-1"
    roster.write_text("student,name\ns1,Ann 1\ns7,Ann 7\ns8,Ann 8\n", encoding="utf-8")
    done = series(tmp_path, 1)
    assert done.exit_code == 0, done.stderr
    kept, lacks, has = done.stderr.splitlines()[-3:]
    assert kept == f"{sheet}: exists and stays as it is"
    assert lacks == (
        f'{sheet}: has no paper for "s7", "s8" - list new students alone in a file LATE, the '
        f"others in ROSTER: kinegrade generate {sheet}/bank.toml ROSTER -o {sheet} --add LATE"
    )
    assert has == f'{sheet}: has a paper for "s0", not in roster.csv'


def test_a_series_continued_with_an_old_id_says_whose_it_is(tmp_path: Path) -> None:
    write(tmp_path, students=2)
    assert series(tmp_path, 1).exit_code == 0
    sheet = tmp_path / "HW" / "homework-1"
    assert kinegrade("exchange", sheet, "s0", "n0", "--new-id").exit_code == 0
    done = series(tmp_path, 1)
    assert done.exit_code == 0, done.stderr
    assert done.stderr.splitlines()[-2:] == [
        f"{sheet}: exists and stays as it is",
        f'{sheet}: "s0" is "n0" now - write that id in roster.csv',
    ]


def test_a_series_continued_with_other_points_says_which_sheet_has_which(tmp_path: Path) -> None:
    bank = write(tmp_path) / "bank.toml"
    assert series(tmp_path, 1).exit_code == 0
    by_hand = '[[questions]]\ntext = { en = "Why?" }\npoints = 3\nbonus = true\n'
    bank.write_text(f"{BANK}asks = {{ v_x = 5 }}\n{by_hand}", encoding="utf-8")
    done = series(tmp_path, 1)
    assert done.exit_code == 0, done.stderr
    sheet = tmp_path / "HW" / "homework-1"
    anew = "if it is not handed out, move the folder away and run the command again"
    assert done.stderr.splitlines()[-2:] == [
        f"{sheet}: q1 has 2 points here, 5 in the bank - {anew}",
        f"{sheet}: q2 has 0 points here, +3 in the bank - {anew}",
    ]


def test_answers_to_one_sheet_given_for_the_next_are_told(tmp_path: Path) -> None:
    bank = write(tmp_path, students=6) / "bank.toml"
    bank.write_text(bank.read_text(encoding="utf-8").replace("1 .. 8", "1 .. 20"), encoding="utf-8")
    assert series(tmp_path, 2).exit_code == 0
    first, second = (tmp_path / "HW" / name for name in ("homework-1", "homework-2"))
    columns = open_exam(first).head.columns
    asked = [line["questions"][0]["asks"] for line in key_lines(first)]
    rows = [[f"s{n}", *(each["decimal"] for each in asks.values())] for n, asks in enumerate(asked)]
    answers = tmp_path / "answers.csv"
    answers.write_text(write_csv_text(["student", *columns], rows), encoding="utf-8")
    right = kinegrade("grade", first, answers, "-o", tmp_path / "RIGHT")
    wrong = kinegrade("grade", second, answers, "-o", tmp_path / "WRONG")
    said = "6 students have 0 % of the points together: look whether the answers are to this exam"
    assert "of the points together" not in right.stderr
    assert said in wrong.stderr


def test_too_few_numbers_for_all_sheets_are_refused_and_the_others_are_there(
    tmp_path: Path,
) -> None:
    done = series(write(tmp_path, students=3), 3)
    assert done.exit_code == 2
    assert (tmp_path / "HW" / "homework-2" / "exam.json").exists()
    assert not (tmp_path / "HW" / "homework-3").exists()


def test_the_words_of_a_reproducible_series_give_each_sheet_its_own_numbers(
    tmp_path: Path,
) -> None:
    assert series(write(tmp_path), 2, "--reproducible", "autumn").exit_code == 0
    first, second = (open_exam(tmp_path / "HW" / f"homework-{number}").head for number in (1, 2))
    assert (first.reproducible, second.reproducible) == ("autumn 1", "autumn 2")


def test_a_series_of_exams_is_called_so(tmp_path: Path) -> None:
    assert series(write(tmp_path, 'kind = "exam"\n'), 1).exit_code == 0
    assert open_exam(tmp_path / "HW" / "exam-1").head.title == "Cranks 1"


def test_a_paper_of_a_sheet_is_printed_again_as_it_was(homework: Path, tmp_path: Path) -> None:
    sheet, again = homework / "homework-2", tmp_path / "again.pdf"
    assert kinegrade("paper", sheet, "s1", "-o", again).exit_code == 0
    assert again.read_bytes() == (sheet / "papers" / "s1.pdf").read_bytes()


@pytest.mark.parametrize(
    ("before", "options", "said"),
    [
        ("sheet = 2\n", (), "bank.toml: the bank is sheet 2 of a series already"),
        (
            'due = "2026-12-01 18:00"\n',
            ("--due", "2026-12-08 18:00"),
            "the bank is due 2026-12-01 18:00 already - leave it out, or leave out --due",
        ),
        ('kind = "test"\n', (), 'bank.toml:1: kind: "test"'),
        ("sheet = 0\n", (), "bank.toml:1: sheet: 0"),
        ('due = "tomorrow"\n', (), 'bank.toml:1: due: "tomorrow" - expected a date with a time'),
        ("due = 2026-12-01\n", (), "bank.toml:1: due: 2026-12-01"),
        ('due = "2026-02-30 18:00"\n', (), '"2026-02-30 18:00"'),
        ("", ("--due", "soon"), '"soon" - expected a date with a time'),
    ],
)
def test_what_does_not_fit_is_refused(
    tmp_path: Path, before: str, options: tuple[str, ...], said: str
) -> None:
    done = series(write(tmp_path, before), 1, *options)
    assert done.exit_code == 2
    assert said in done.stderr
    assert not list(tmp_path.glob("HW/*"))


def test_solutions_are_given_out_after_the_due_date_unless_told(tmp_path: Path) -> None:
    assert series(write(tmp_path), 1, "--due", "2099-12-01 18:00").exit_code == 0
    sheet = tmp_path / "HW" / "homework-1"
    refused = kinegrade("solutions", sheet, "s0", "--jobs", "1")
    assert refused.exit_code == 2
    assert (
        "to be handed in by 2099-12-01 18:00 - expected worked solutions given out after it - "
        "wait, or add --before-due" in refused.stderr
    )
    told = kinegrade("solutions", sheet, "--before-due", "--jobs", "1")
    assert told.exit_code == 0, told.stderr
    marks, output = tmp_path / "MARKS", tmp_path / "F"
    assert kinegrade("grade", sheet, sheet / "answers.csv", "-o", marks).exit_code == 0
    wishes = sheet, marks, "-o", output, "--solutions", "--format", "md"
    assert "--before-due" in kinegrade("feedback", *wishes).stderr
    assert kinegrade("feedback", *wishes, "--before-due").exit_code == 0


def test_solutions_are_given_out_when_the_date_is_past(tmp_path: Path) -> None:
    assert series(write(tmp_path), 1, "--due", "2020-12-01 18:00").exit_code == 0
    sheet = tmp_path / "HW" / "homework-1"
    assert kinegrade("solutions", sheet, "s0", "--jobs", "1").exit_code == 0


@pytest.mark.parametrize(
    ("text", "written"),
    [
        ("2026-12-01T18:00", "2026-12-01 18:00"),
        ("2026-12-01 18:00:30", "2026-12-01 18:00:30"),
        ("2026-12-01 18:00Z", "2026-12-01 18:00 +00:00"),
        ("2026-12-01 18:00 -05:30", "2026-12-01 18:00 -05:30"),
    ],
)
def test_a_moment_is_read_and_written(text: str, written: str) -> None:
    assert write_moment(read_moment(text)) == written
    assert parse_moment(written) == read_moment(text)


@pytest.mark.parametrize("text", ["2026-12-01", "1.12.2026 18:00", "18:00", "2026-12-01 25:00", ""])
def test_what_is_no_moment_is_refused(text: str) -> None:
    assert parse_moment(text) is None
    with pytest.raises(FieldError, match="a date with a time"):
        read_moment(text)


def test_a_moment_in_another_zone_is_past_when_it_is() -> None:
    now = datetime(2026, 12, 1, 17, 30, tzinfo=UTC)
    assert is_past(read_moment("2026-12-01 18:00 +01:00"), now)
    assert not is_past(read_moment("2026-12-01 18:00 +00:00"), now)


def test_answers_to_an_earlier_sheet_are_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write(tmp_path)
    bank = tmp_path / "bank.toml"
    bank.write_text(f"{BANK}asks = {{ v_x = 1, v_y = 1 }}\n", encoding="utf-8")
    assert series(tmp_path, 3).exit_code == 0
    first, second, third = (tmp_path / "HW" / f"homework-{number}" for number in (1, 2, 3))
    strangers = tmp_path / "HW" / "a class of others"
    shutil.copytree(third, strangers)
    head = strangers / "exam.json"
    head.write_text(head.read_text("utf-8").replace('"s0"', '"t0"'), encoding="utf-8")
    read: list[Path] = []

    def note(exam: ExamFolder) -> Sequence[Intervals]:
        read.append(exam.path)
        return list_intervals(exam)

    def open_another(path: Path) -> ExamFolder:
        assert path != second
        return open_exam(path)

    monkeypatch.setattr(other_sheets, "list_intervals", note)
    monkeypatch.setattr(exams_beside, "open_exam", open_another)
    values = key_lines(first)[0]["questions"][0]["asks"]
    typed = ",".join(values[ask]["decimal"] for ask in ("v_x", "v_y"))
    answers = tmp_path / "answers.csv"
    answers.write_text(f"student,q1.v_x,q1.v_y\ns0,{typed}\n", encoding="utf-8")
    marked = kinegrade("grade", second, answers, "-o", tmp_path / "MARKS")
    assert marked.exit_code == 1
    assert f"are right on the paper of {first} - marked as answers to this one" in marked.stderr
    assert read == [first]  # that of another class has nobody of it, and no third is needed
    shutil.copytree(second, tmp_path / "HW" / "a copy")
    numbers = key_lines(second)[0]["questions"][0]["asks"]
    reversed_row = ",".join(numbers[ask]["decimal"] for ask in ("v_y", "v_x"))
    answers.write_text(f"student,q1.v_x,q1.v_y\ns0,{reversed_row}\n", encoding="utf-8")
    copied = kinegrade("grade", second, answers, "-o", tmp_path / "COPIED")
    assert "right on the paper of" not in copied.stderr
    answers.write_text(f"student,q1.v_x,q1.v_y\ns0,{typed}\n", encoding="utf-8")
    own = kinegrade("grade", first, answers, "-o", tmp_path / "FIRST")
    assert "marked as answers to this one" not in own.stderr
    # The others are read for the row that is right on the copy alone, and none when nobody is wrong
    assert read == [first, first, third]
    (first / "key.jsonl").write_text("{}\n", encoding="utf-8")
    damaged = kinegrade("grade", second, answers, "-o", tmp_path / "BESIDE")
    assert damaged.exit_code == 1
    assert "right on the paper of" not in damaged.stderr
