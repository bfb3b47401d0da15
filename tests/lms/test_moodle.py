"""Moodle: exact ids, dot decimals, nothing that stops its all-or-nothing import; its downloads in
three languages.
"""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest

from kinegrade.errors import TableError
from kinegrade.files.tables import parse_table
from kinegrade.lms.grades.dialect import ExportOptions
from kinegrade.lms.grades.fill_in import fill_in
from kinegrade.lms.grades.grades import read_grades
from kinegrade.lms.grades.moodle import export
from kinegrade.lms.grades.systems.moodle import MOODLE
from kinegrade.marks_folder.folder import MarksFolder
from tests.golden_files import Hold
from tests.lms.marked_folder import changed, filled, fresh, write_marks
from tests.said import all_said

GRADES = '''student,name,q1,q2,total,out_of,percent
0012345,王伟,4,3,7,10,70
=9,"O'Neil, ""Zoë""",0,0.3333,0.3333,10,3.33
'''
MARKS = """student,question,ask,response,read_as,unit,verdict,points,out_of,reason
0012345,q1,v_B,1,1,m/s,right,4,4,"two
lines"
0012345,q1,omega_AB,,,rad/s,blank,0,3,
0012345,q2,a_B,1,1,m/s^2,right,3,3,
=9,q1,v_B,,,m/s,blank,0,4,
=9,q1,omega_AB,,,rad/s,blank,0,3,
=9,q2,a_B,1,1,m/s^2,right,0.3333,3,
"""
SAMPLES = Path(__file__).parent / "samples"
LANGUAGES = {"en": ("Real", "Feedback"), "de": ("Punkte", "Rückmeldung"), "zh_cn": ("分数", "反馈")}
WORKSHEET = (
    "\ufeffIdentifier,Full name,Email address,Status,Grade,Maximum grade,Grade can be changed,"
    "Last modified (submission),Last modified (grade),Feedback comments\r\n"
    '"Participant 12",王伟,w1@example.invalid,"Submitted",,10.00,Yes,"Friday, 1 May 2026","-",\r\n'
    '"Participant 13","O\'Neil, Zoë",w2@example.invalid,"Submitted",3.00,10.00,Yes,-,-,"old, and '
    '""long"""\r\n'
)


def folder(tmp_path: Path, grades: str = GRADES, marks: str = MARKS) -> Path:
    (tmp_path / "grades.csv").write_text(grades, encoding="utf-8")
    (tmp_path / "marks.csv").write_text(marks, encoding="utf-8")
    return tmp_path


def sample(language: str) -> bytes:
    return (SAMPLES / f"moodle-gradebook-{language}.csv").read_bytes()


def test_the_file_is_what_moodle_imports(tmp_path: Path) -> None:
    assert export(MarksFolder(folder(tmp_path))) == (
        "ID number,Full name,Grade,Feedback\n"
        "0012345,王伟,7,1: 4/7; 2: 3/3\n"
        '=9,"O\'Neil, ""Zoë""",0.3333,1: 0/7; 2: 0.3333/3\n'
    )


def test_the_golden_file(tmp_path: Path, hold: Hold) -> None:
    hold("lms/moodle.csv", export(MarksFolder(write_marks(tmp_path))))


def test_feedback_holds_no_html(tmp_path: Path) -> None:
    marked = folder(tmp_path, GRADES.replace("q1", "<b>"), MARKS.replace("q1", "<b>"))
    assert "&lt;b&gt;: 4/7" in export(MarksFolder(marked))


def test_who_handed_in_nothing_is_left_out_because_an_empty_grade_erases_one(
    tmp_path: Path,
) -> None:
    assert "0012347" not in export(MarksFolder(write_marks(tmp_path)))
    everybody = fresh(tmp_path, MOODLE, ExportOptions(ungraded=True))
    assert "0012347,'=HYPERLINK(1),0,1: 0/7; 2: 0/3\n" in everybody.text
    assert (everybody.students, fresh(tmp_path, MOODLE).students) == (4, 3)


def test_lines_are_of_one_length_not_blank_and_without_the_export_time(tmp_path: Path) -> None:
    table = parse_table(export(MarksFolder(write_marks(tmp_path))).encode(), "moodle.csv")
    assert table.complaints == ()
    assert {len(row.cells) for row in table.rows} == {len(table.header)} == {4}
    assert [title for title in table.header if "downloaded" in title.lower()] == []
    assert [row for row in table.rows if row.cells[2] in ("", "-")] == []


def test_a_grade_above_the_maximum_would_stop_the_whole_import(tmp_path: Path) -> None:
    more = folder(tmp_path, GRADES.replace("4,3,7,10", "4,3,11,10"))
    with pytest.raises(
        TableError, match='student "0012345": 11 points of 10 - expected no more than the maximum'
    ):
        export(MarksFolder(more))


def test_questions_in_columns_of_their_own(tmp_path: Path) -> None:
    assert fresh(tmp_path, MOODLE, ExportOptions(per_question=True)).text.splitlines()[:2] == [
        "ID number,Full name,Grade q1,Grade q2",
        "0012345,王伟,7,1.25",
    ]


def test_by_email_those_without_one_are_told(tmp_path: Path) -> None:
    made = fresh(tmp_path, MOODLE, ExportOptions(by=("email",), feedback=False))
    assert made.text.splitlines()[:2] == [
        "Email address,Full name,Grade",
        "w1@example.invalid,王伟,8.25",
    ]
    assert [str(each) for each in made.complaints] == [
        'exam.json: student "0012348" has no e-mail - not exported; give it in the roster, or '
        "match by id"
    ]


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("by", ["id", "email"])
def test_a_downloaded_gradebook_keeps_every_byte_but_grades_and_feedback(
    tmp_path: Path, language: str, by: str
) -> None:
    result = filled(tmp_path, MOODLE, sample(language), ExportOptions(by=(by,)))  # type: ignore[arg-type]
    title = {"en": "Quiz: ", "de": "Test:\u00a0", "zh_cn": "测验："}[language] + "Kinematics quiz"
    grade, feedback = (f"{title} ({word})" for word in LANGUAGES[language])
    expected = {
        (3, grade): "4",
        (3, feedback): "1: 4/7; 2: 0/3",
        (5, grade): "8.25",
        (5, feedback): "1: 7/7; 2: 1.25/3",
    }
    if by == "id":
        expected |= {(4, grade): "9.6667", (4, feedback): "1: 6.6667/7; 2: 3/3"}
    assert changed(tmp_path) == expected
    assert result.students == len(expected) // 2
    told = [str(each) for each in result.complaints]
    assert len(told) == (0 if by == "id" else 2), told


def test_a_maximum_that_only_points_beside_per_cent_tell_is_not_overlooked(tmp_path: Path) -> None:
    of_twenty = sample("en").replace(b"29.41 %", b"14.71 %").replace(b"52.94 %", b"26.47 %")
    with pytest.raises(TableError) as refusal:
        filled(tmp_path, MOODLE, of_twenty, ExportOptions(by=("id",)))
    assert refusal.value.problems == (
        'download.csv: "Quiz: Kinematics quiz (Real)": counts 20 there, 10 in the exam - expected '
        "the same - add "
        "--scale to scale the grades, or correct the item",
    )
    filled(tmp_path, MOODLE, of_twenty, ExportOptions(by=("id",), scale=True))
    assert changed(tmp_path)[5, "Quiz: Kinematics quiz (Real)"] == "16.5"


def test_an_encoding_that_moodle_can_be_told_is_kept(tmp_path: Path) -> None:
    result = filled(
        tmp_path, MOODLE, sample("zh_cn").decode().encode("gb18030"), ExportOptions(by=("id",))
    )
    assert len(changed(tmp_path)) == 6
    assert "测验：Kinematics quiz (反馈)".encode("gb18030") in result.content


def test_without_feedback_only_grades_change(tmp_path: Path) -> None:
    filled(tmp_path, MOODLE, sample("en"), ExportOptions(feedback=False))
    assert {header for _, header in changed(tmp_path)} == {"Quiz: Kinematics quiz (Real)"}


def test_ids_are_exact_texts_and_lost_zeros_are_only_suggested(tmp_path: Path) -> None:
    eaten = sample("en").replace(b"0012345", b"12345")
    result = filled(tmp_path, MOODLE, eaten, ExportOptions(by=("id",)))
    assert [(line, _) for line, _ in changed(tmp_path) if line == 5] == []
    assert [str(each) for each in result.complaints] == [
        'download.csv: no row for student "0012345" by ID number - not exported; line 5 has ID '
        'number "12345", '
        "probably the same: correct one of the two and export again",
        'download.csv:5: no student of the marked class has ID number "12345" - the line was not '
        "changed",
    ]


def test_a_column_can_be_named_but_not_one_of_the_ids(tmp_path: Path) -> None:
    other = sample("en").replace(b"(Real)", b"(Brut)")
    filled(tmp_path, MOODLE, other, ExportOptions(columns={"": "Quiz: Kinematics quiz (Brut)"}))
    assert changed(tmp_path)[5, "Quiz: Kinematics quiz (Brut)"] == "8.25"
    with pytest.raises(TableError, match='"ID number" is no column from which Moodle takes grades'):
        filled(tmp_path, MOODLE, other, ExportOptions(columns={"": "ID number"}))


def test_the_assignment_worksheet_is_filled_by_email_and_keeps_its_marks(tmp_path: Path) -> None:
    result = filled(tmp_path, MOODLE, WORKSHEET)
    assert changed(tmp_path) == {
        (2, "Grade"): "8.25",
        (2, "Feedback comments"): "1: 7/7; 2: 1.25/3",
        (3, "Grade"): "4",
        (3, "Feedback comments"): "1: 4/7; 2: 0/3",
    }
    assert result.content.startswith(b"\xef\xbb\xbfIdentifier")
    assert (
        '3.00,10.00,Yes,-,-,"old, and ""long"""'.replace("3.00", "4")
        .replace('old, and ""long""', "1: 4/7; 2: 0/3")
        .encode()
        in result.content
    )
    assert [str(each) for each in result.complaints] == [
        'download.csv: no row for student "0012348" by Email address - not exported'
    ]


def test_a_row_of_the_worksheet_that_moodle_would_pass_over_in_silence_is_told(
    tmp_path: Path,
) -> None:
    result = filled(tmp_path, MOODLE, WORKSHEET.replace("3.00,10.00,Yes", "3.00,10.00,No"))
    assert {line for line, _ in changed(tmp_path)} == {2}
    assert str(result.complaints[-1]) == (
        'download.csv:3: Grade: student "0012346" has "No" under "Grade can be changed" (3.00) - '
        "left as it is; 4 "
        "would be the grade"
    )


def test_where_nobodys_address_is_known_the_exam_is_asked_for(tmp_path: Path) -> None:
    (tmp_path / "download.csv").write_text(WORKSHEET, encoding="utf-8", newline="")
    with pytest.raises(
        TableError, match=r"other keys \(--by\), or the exam that knows the addresses \(--exam\)"
    ):
        fill_in(
            MOODLE,
            read_grades(MarksFolder(write_marks(tmp_path))),
            tmp_path / "download.csv",
            ExportOptions(),
        )


def test_a_worksheet_states_its_maximum(tmp_path: Path) -> None:
    with pytest.raises(
        TableError,
        match='"Grade": counts 20 there, 10 in the exam - expected the same - add --scale',
    ):
        filled(tmp_path, MOODLE, WORKSHEET.replace("10.00", "20.00"))
    filled(tmp_path, MOODLE, WORKSHEET.replace("10.00", "20.00"), ExportOptions(scale=True))
    assert changed(tmp_path)[2, "Grade"] == "16.5"


def test_moodle_keeps_five_decimals(tmp_path: Path) -> None:
    text = fresh(tmp_path, MOODLE, ExportOptions(maximum=Fraction(7), feedback=False)).text
    assert text.splitlines()[3] == "0012348,Some Blank,6.76669"


def test_a_damaged_folder_is_refused(tmp_path: Path) -> None:
    with pytest.raises(TableError, match="grades.csv: cannot be read"):
        export(MarksFolder(tmp_path))
    with pytest.raises(
        TableError, match="grades.csv: no column total - expected the file as kinegrade"
    ):
        export(MarksFolder(folder(tmp_path, grades=GRADES.replace("total", "sum"))))
    with pytest.raises(TableError, match="grades.csv:.*the line has 1 cells, the header 7"):
        export(MarksFolder(folder(tmp_path, grades=GRADES + "7\n")))
    with pytest.raises(
        TableError,
        match='marks.csv:6: out_of is "x" - expected a number of zero or more - grade again',
    ):
        export(MarksFolder(folder(tmp_path, marks=MARKS.replace("0,4,", "0,x,"))))


def test_other_grades_that_stood_in_a_download_are_named(tmp_path: Path) -> None:
    text = "ID number,Assignment: Quiz (Real)\n0012345,3\n0012346,4.00\n0012348,-\n"
    result = filled(tmp_path, MOODLE, text, ExportOptions(columns={"": "Assignment: Quiz (Real)"}))
    assert all_said(result.notes)[-1] == (
        'download.csv: "Assignment: Quiz (Real)": 1 grade that stood there is replaced by another: '
        '"0012345" (3, now 8.25)'
    )
    path = tmp_path / "filled.csv"
    again = filled(tmp_path, MOODLE, path.read_bytes(), ExportOptions())
    assert not [note for note in all_said(again.notes) if "stood there" in note]
