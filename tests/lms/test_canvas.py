"""Canvas: allowed header beginnings, no byte-order mark, nothing in its own ID column, no number
misread.
"""

from __future__ import annotations

import csv
import io
import re
from pathlib import Path

import pytest

from kinegrade.errors import TableError
from kinegrade.lms.grades.dialect import ExportOptions
from kinegrade.lms.grades.systems.canvas import CANVAS
from kinegrade.marks_folder.folder import MarksFolder
from tests.golden_files import Hold
from tests.lms.marked_folder import changed, filled, fresh, write_exam, write_marks
from tests.small_class import kinegrade

HEADER = (
    "Student,ID,SIS User ID,SIS Login ID,Section,Notes (old),Kinematics quiz (1234),Final "
    "Score (77),Sum (9)\n"
)
POSSIBLE = "    Points Possible,,,,,,10.00,(read only),(read only)\n"
DOWNLOAD = (
    HEADER
    + ",,,,,,Manual Posting,,\n"
    + POSSIBLE
    + (
        '"伟, 王",501,0012345,wangwei,A,,3.00,3.00,3.00\n'
        '"O\'Neil, Zoë",502,0012346,zoneil,A,,EX,,\n'
        "Nobody,503,0012347,nobody,A,,,,\n"
        "Some Blank,504,0012348,sblank,A,,,,\n"
    )
)
QUIZ = "Kinematics quiz (1234)"


def test_the_golden_file(tmp_path: Path, hold: Hold) -> None:
    hold("lms/canvas.csv", fresh(tmp_path, CANVAS).text)


@pytest.mark.parametrize("by", [None, "id", "login"])
def test_a_new_file_begins_as_canvas_allows_and_is_nobodys_by_name(
    tmp_path: Path, by: str | None
) -> None:
    text = fresh(tmp_path, CANVAS, ExportOptions(by=(by,) if by else ())).text  # type: ignore[arg-type]
    header, first, *_ = csv.reader(io.StringIO(text))
    assert header == ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", "Kinematics quiz"]
    keys = ["", "0012345"] if by == "login" else ["0012345", ""]
    assert first == [
        "王伟 [0012345]",
        "",
        *keys,
        "",
        "8.25",
    ]  # ID is Canvas's own number; the name is no one's
    assert not text.startswith("\ufeff")
    assert '""' not in text  # a quoted empty cell counts as a change there
    assert "Points Possible" not in text  # it would change the points of an assignment that exists


def test_an_existing_assignment_is_named_by_its_whole_header(tmp_path: Path) -> None:
    text = fresh(tmp_path, CANVAS, ExportOptions(columns={"": QUIZ})).text
    assert text.splitlines()[0].endswith(f",{QUIZ}")


@pytest.mark.parametrize(
    ("title", "reason"),
    [
        ("Final Score of May", "Canvas ignores every column with these words"),
        ("My Override Grade", "Canvas ignores every column with these words"),
        ("Midterm (2026)", "Canvas takes the number at its end for the id of an assignment"),
    ],
)
def test_titles_that_canvas_ignores_or_cuts_are_refused(
    tmp_path: Path, title: str, reason: str
) -> None:
    with pytest.raises(TableError, match=re.escape(f'the title "{title}" does not fit: {reason}')):
        fresh(tmp_path, CANVAS, ExportOptions(title=title))


def test_only_the_scores_of_matched_students_change(tmp_path: Path) -> None:
    result = filled(tmp_path, CANVAS, DOWNLOAD)
    assert changed(tmp_path) == {
        (4, QUIZ): "8.25",
        (7, QUIZ): "9.67",
    }  # two decimals are kept there
    assert result.students == 2
    assert [str(each) for each in result.complaints] == [
        f'download.csv:5: {QUIZ}: student "0012346" is excused there (EX) - left as it is; 4 would '
        "be the grade"
    ]


def test_semicolons_line_ends_and_an_unquoted_mark_are_kept(tmp_path: Path) -> None:
    plain = DOWNLOAD.replace('"伟, 王"', "王").replace('"O\'Neil, Zoë"', "Zoë")
    filled(tmp_path, CANVAS, "\ufeff" + plain.replace(",", ";").replace("\n", "\r\n"))
    assert changed(tmp_path) == {(4, QUIZ): "8.25", (7, QUIZ): "9.67"}


@pytest.mark.parametrize(
    "beginning",
    [
        "Student,ID,SIS User ID,Section",
        "ID,Student,Section",
        "Student,Section",
        "student,ID,SIS Login ID,Section",
    ],
)
def test_a_header_that_canvas_calls_invalid_is_refused(tmp_path: Path, beginning: str) -> None:
    row = ",".join("0012345" for _ in beginning.split(","))
    with pytest.raises(
        TableError, match="expected those of Canvas, in their order - download it again"
    ):
        filled(tmp_path, CANVAS, f"{beginning},{QUIZ}\n{row},1\n")


@pytest.mark.parametrize(
    "beginning",
    [
        "Student,ID,SIS Login ID,Section",
        "Student,ID,SIS User ID,SIS Login ID,Integration ID,Root Account,Section",
        "LastName,FirstName,ID,SIS User ID,SIS Login ID,Section",
    ],
)
def test_all_headers_that_canvas_allows_are_taken(tmp_path: Path, beginning: str) -> None:
    row = ",".join("0012345" if "SIS Login" in name else "x" for name in beginning.split(","))
    filled(tmp_path, CANVAS, f"{beginning},{QUIZ}\n{row},1\n")
    assert changed(tmp_path) == {(2, QUIZ): "8.25"}


def test_a_mark_before_a_quotation_mark_would_fail_there(tmp_path: Path) -> None:
    with pytest.raises(
        TableError, match="begins with a byte-order mark that Canvas takes for data"
    ):
        filled(tmp_path, CANVAS, "\ufeff" + DOWNLOAD.replace("Student,", '"Student",', 1))


def test_another_encoding_than_utf_8_would_fail_there(tmp_path: Path) -> None:
    with pytest.raises(
        TableError, match=r"download.csv: is GB18030 - expected UTF-8, or Canvas refuses it"
    ):
        filled(
            tmp_path,
            CANVAS,
            DOWNLOAD.replace("ë", "").replace("伟, 王", "王伟，力学一班的学生").encode("gb18030"),
        )


def test_a_thousand_with_a_comma_is_read_as_one(tmp_path: Path) -> None:
    result = filled(tmp_path, CANVAS, DOWNLOAD.replace("A,,3.00", 'A,"1,000",3.00'))
    assert (
        'download.csv:4: Notes (old): Canvas reads "1,000" as 1.000 - left as it is; correct it '
        "before you import" in map(str, result.complaints)
    )


def test_read_only_and_ignored_columns_cannot_be_named(tmp_path: Path) -> None:
    for header in ("Final Score (77)", "Sum (9)", "Section"):
        with pytest.raises(
            TableError, match="is no column from which Canvas takes grades - expected one that is"
        ):
            filled(tmp_path, CANVAS, DOWNLOAD, ExportOptions(columns={"": header}))


def test_other_points_are_refused_unless_scaled(tmp_path: Path) -> None:
    twenty = DOWNLOAD.replace("10.00", "20")
    with pytest.raises(
        TableError, match=r"counts 20 there, 10 in the exam - expected the same - add --scale"
    ):
        filled(tmp_path, CANVAS, twenty)
    filled(tmp_path, CANVAS, twenty, ExportOptions(scale=True))
    assert changed(tmp_path)[4, QUIZ] == "16.5"


def exported(folder: Path, *options: str | Path) -> str:
    """The file of `kinegrade export --to canvas`."""
    marks, exam, out = folder / "MARKS", folder / "EXAM", folder / "out.csv"
    where = "--exam", write_exam(exam), "-o", out, "--force"
    result = kinegrade("export", write_marks(marks), "--to", "canvas", *where, *options)
    assert result.exit_code in (0, 1), result.stderr
    return f"{out.read_text(encoding='utf-8')}{result.stderr}"


def test_people_are_known_by_address_where_logins_are_addresses(tmp_path: Path) -> None:
    made = exported(tmp_path, "--by", "email")
    assert "\n王伟 [0012345],,,w1@example.invalid,,8.25\n" in made
    assert 'student "0012348" has no e-mail - not exported' in made
    addresses = DOWNLOAD.replace("0012345,wangwei", "7001,W1@example.invalid").replace(
        "0012346,zoneil,A,,EX", "7002,w2@example.invalid,A,,"
    )
    (tmp_path / "download.csv").write_text(addresses, encoding="utf-8", newline="")
    filled_in = exported(tmp_path, "--into", tmp_path / "download.csv", "--by", "email")
    assert '"伟, 王",501,7001,W1@example.invalid,A,,8.25,3.00,3.00\n' in filled_in
    assert ",w2@example.invalid,A,,4,,\n" in filled_in
    both = exported(tmp_path, "--into", tmp_path / "download.csv")
    assert "W1@example.invalid,A,,8.25" in both  # without --by, ids and addresses are tried
    assert "0012348,sblank,A,,9.67" in both


@pytest.mark.parametrize("system", ["canvas", "moodle", "generic"])
def test_addresses_that_nobody_knows_are_asked_for_once(tmp_path: Path, system: str) -> None:
    marks, out = write_marks(tmp_path / "MARKS"), tmp_path / "out.csv"
    options = "--to", system, "--by", "email", "--title", "Quiz"
    result = kinegrade("export", marks, *options, "-o", out)
    assert (result.exit_code, out.exists()) == (2, False)
    assert result.stderr == (
        "error: --by email: no student's address is known - expected those of the roster - name the "
        "exam with --exam, or choose another key\n"
    )


@pytest.mark.parametrize(
    ("header", "row"),
    [
        (HEADER, '"Student, Test",599,,4f1c0ffee0,A,,,,\n'),
        (HEADER.replace("Student,", "LastName,FirstName,", 1), "Student,Test,599,,4f1c,A,,,,\n"),
    ],
)
def test_the_student_view_of_a_teacher_is_no_stranger(
    tmp_path: Path, header: str, row: str
) -> None:
    last_first = header.startswith("LastName")
    own = "王,伟,501,0012345,w,A,,3.00,,\n" if last_first else '"伟, 王",501,0012345,w,A,,3.00,,\n'
    (tmp_path / "download.csv").write_text(header + own + row, encoding="utf-8", newline="")
    options = "--by", "id", "--column", QUIZ
    made = exported(tmp_path, "--into", tmp_path / "download.csv", *options)
    assert "no student of the marked class" not in made
    assert row in made  # as it was


def test_somebody_who_is_called_test_student_gets_a_grade(tmp_path: Path) -> None:
    named = DOWNLOAD.replace('"伟, 王"', '"Student, Test"')
    filled(tmp_path, CANVAS, named)
    assert changed(tmp_path)[4, QUIZ] == "8.25"


def test_canvas_takes_no_comments_in_this_file(tmp_path: Path) -> None:
    with pytest.raises(
        TableError,
        match="--feedback: Canvas takes none in this file - expected a file with a column",
    ):
        fresh(tmp_path, CANVAS, ExportOptions(feedback=True))
    with pytest.raises(
        TableError, match="no column for feedback on the total - expected one, as Canvas has it"
    ):
        filled(tmp_path, CANVAS, DOWNLOAD, ExportOptions(feedback=True))


def test_a_new_assignment_needs_a_title(tmp_path: Path) -> None:
    from kinegrade.lms.grades.from_scratch import new_file
    from kinegrade.lms.grades.grades import read_grades

    with pytest.raises(
        TableError,
        match="Canvas: the item has no title - expected one - give it with --title, or name",
    ):
        new_file(CANVAS, read_grades(MarksFolder(write_marks(tmp_path))), ExportOptions())
