"""Rosters as registrars, systems and people send them: read as what they are, which is said, or
refused in one line; through the command line.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from time import perf_counter

import pytest
from openpyxl import Workbook

from kinegrade.errors import TableError
from kinegrade.exam.roster.roster import Roster
from tests.small_class import generate, kinegrade, write_class

PARTICIPANTS = (
    '"First name","Last name","ID number","Email address",Groups,Roles\n'
    'Ada,Lovelace,0012345,ada@x.org,"Group A, Group B",Student\n'
    "Zoë,O'Neil,0012346,zoe@x.org,,Student\n"
)
MOODLE_GRADES = (
    '"First name","Last name","ID number",Institution,Department,"Email address",'
    '"Quiz: Kinematics (Real)","Last downloaded from this course"\n'
    "Ada,Lovelace,0012345,,,ada@x.org,-,1790000000\n"
)
CANVAS_GRADES = (
    "Student,ID,SIS User ID,SIS Login ID,Section,Kinematics quiz (1234)\n"
    "    Points Possible,,,,,10\n"
    '"Lovelace, Ada",77,0012345,ada,Mon,8.25\n'
    '"王, 伟",78,0012346,wei,Tue,EX\n'
    '"Student, Test",79,,a1b2c3,Mon,\n'
)
REGISTRAR = (
    "Prüfungsliste Wintersemester 2026/27\n\nTechnische Mechanik II;Prof. Müller\n"
    "Matrikelnummer;Name;Vorname;Hörsaal;Platz;Zeitzuschlag (min)\n"
    "0123;Müller;Jürgen;H 1;12;30\n0124;Weiß;Anna;H 1;2;\n"
)
CHINESE = "学号,姓名,班级\n0123,王伟,力学1班\n0124,李娜,力学2班\n"
FRENCH = "Prénom,Nom de famille,Numéro d’identification,Groupes\nAda,Lovelace,007,G1\n"


def write(folder: Path, content: str | bytes, name: str = "roster.csv") -> Path:
    """A file with that content."""
    path = folder / name
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    return path


def write_sheet(folder: Path, lines: Sequence[Sequence[object]]) -> Path:
    """A workbook of these lines."""
    workbook = Workbook()
    sheet = workbook.active
    assert sheet is not None
    for line in lines:
        sheet.append(line)
    path = folder / "roster.xlsx"
    workbook.save(path)
    return path


def read(folder: Path, content: str | bytes) -> list[tuple[str, str, str]]:
    """The id, name and group of each student."""
    students = Roster.read(write(folder, content)).students
    return [(each.student, each.name, each.group) for each in students]


def test_the_participants_of_moodle(tmp_path: Path) -> None:
    assert read(tmp_path, PARTICIPANTS) == [
        ("0012345", "Ada Lovelace", "Group A, Group B"),
        ("0012346", "Zoë O'Neil", ""),
    ]


def test_gradebooks_of_moodle_and_canvas(tmp_path: Path) -> None:
    assert read(tmp_path, MOODLE_GRADES) == [("0012345", "Ada Lovelace", "")]
    assert read(tmp_path, CANVAS_GRADES) == [
        ("0012345", "Ada Lovelace", "Mon"),
        ("0012346", "王伟", "Tue"),
    ]
    other = CANVAS_GRADES.replace("Student,ID", "LastName,FirstName,ID").replace(
        "    Points Possible", "    Points Possible,"
    )
    other = other.replace('"Lovelace, Ada"', "Lovelace,Ada").replace('"王, 伟"', "王,伟")
    other = other.replace('"Student, Test"', "Student,Test")
    assert read(tmp_path, other.replace("Student,Test", ",")) == read(tmp_path, CANVAS_GRADES)


def test_canvas_without_numbers_of_the_school_has_its_own(tmp_path: Path) -> None:
    text = CANVAS_GRADES.replace("0012345", "").replace("0012346", "")
    assert [student for student, *_ in read(tmp_path, text)] == ["ada", "wei"]


@pytest.mark.parametrize("encoding", ["utf-8-sig", "gb18030", "utf-16"])
def test_chinese_rosters_in_any_encoding(tmp_path: Path, encoding: str) -> None:
    assert read(tmp_path, CHINESE.encode(encoding)) == [
        ("0123", "王伟", "力学1班"),
        ("0124", "李娜", "力学2班"),
    ]


def test_a_name_in_parts_is_put_together_as_its_language_does(tmp_path: Path) -> None:
    assert read(tmp_path, "学号,姓,名\n1,王,伟\n2,Smith,John\n") == [
        ("1", "王伟", ""),
        ("2", "John Smith", ""),
    ]
    assert read(tmp_path, FRENCH) == [("007", "Ada Lovelace", "G1")]


def test_whole_names_are_not_put_together_again(tmp_path: Path) -> None:
    text = "id,name,first name\n1,Ada Lovelace,Ada\n2,Emmy Noether,Emmy\n"
    assert [name for _, name, _ in read(tmp_path, text)] == ["Ada Lovelace", "Emmy Noether"]


def test_a_registrars_list_below_its_titles(tmp_path: Path) -> None:
    roster = Roster.read(write(tmp_path, REGISTRAR.encode("cp1252")))
    assert [(each.student, each.name, each.seat) for each in roster.students] == [
        ("0123", "Jürgen Müller", "12"),
        ("0124", "Anna Weiß", "2"),
    ]
    assert [each.extra_time for each in roster.students] == ["30 min", ""]
    assert [each.line for each in roster.students] == [5, 6]


def test_the_command_says_how_a_file_is_read_and_writes_nothing(tmp_path: Path) -> None:
    path = write_sheet(
        tmp_path,
        [
            ["Registrar's office"],
            [],
            ["No.", "Student No.", "Surname", "First names", "Room", "Group"],
            [1, "0012345", "Lovelace", "Ada", "Hall 7", "G1"],
            [2, "0012346", "Noether", "Emmy", "Hall 7", "G2"],
        ],
    )
    result = kinegrade("roster", path)
    assert result.exit_code == 0, result.stderr
    assert result.stdout.splitlines() == [
        'roster.xlsx: 2 students, the first "0012345" Ada Lovelace',
        'roster.xlsx: read as student from "Student No.", name from "First names" and "Surname", '
        'group from "Group", room from "Room"',
        'roster.xlsx: 1 column is not used: "No."',
        "roster.xlsx: 1 line above the header is left out: 1",
        "roster.xlsx: groups: G1 (1), G2 (1)",
        "roster.xlsx: rooms: Hall 7 (2)",
    ]
    assert [each.name for each in tmp_path.iterdir()] == ["roster.xlsx"]


def test_lines_that_are_no_students_are_named(tmp_path: Path) -> None:
    said = kinegrade("roster", write(tmp_path, CANVAS_GRADES)).stdout
    left_out = '2 lines are no students and left out: 2 ("Points Possible") and 5 ("Student, Test")'
    assert left_out in said
    assert '3 columns are not used: "ID", "SIS Login ID", "Kinematics quiz (1234)"' in said


def test_generate_says_how_it_read_a_roster_with_other_titles(tmp_path: Path) -> None:
    write_class(tmp_path)
    write(tmp_path, MOODLE_GRADES)
    result = generate(tmp_path)
    assert result.exit_code == 0, result.stderr
    assert 'name from "First name" and "Last name"' in result.stderr
    assert '4 columns are not used: "Institution"' in result.stderr
    write(tmp_path, "student,name\n007,Ann\n")
    assert "read as" not in generate(tmp_path, "PLAIN").stderr


def test_columns_with_other_titles_are_named(tmp_path: Path) -> None:
    write_class(tmp_path)
    write(tmp_path, "Nr,Who,Section\n01,Ann,A\n")
    refused = generate(tmp_path)
    assert refused.exit_code == 2
    assert refused.stderr.splitlines() == [
        'error: roster.csv: no column for "student", "name" - the columns here are: Nr, Who, '
        "Section - say which holds it: --column student=HEADER --column name=HEADER"
    ]
    named = ("--column", "student=nr", "--column", "name=Who", "--column", "group=")
    assert generate(tmp_path, "EXAM", *named).exit_code == 0
    shown = kinegrade("roster", tmp_path / "roster.csv", *named).stdout
    assert '1 column is not used: "Section"' in shown


@pytest.mark.parametrize(
    ("wish", "said"),
    [
        ("student=Number", 'no column is called "Number", which is to hold student - the columns'),
        ("students=Nr", '"students=Nr" - expected one of student, name, first, last, email'),
        ("student", '"student" - expected one of student'),
    ],
)
def test_a_wish_that_cannot_be_fulfilled_is_refused(tmp_path: Path, wish: str, said: str) -> None:
    path = write(tmp_path, "Nr,Name\n1,Ann\n")
    result = kinegrade("roster", path, "--column", wish)
    assert result.exit_code == 2
    assert said in result.stderr


def test_ids_that_a_spreadsheet_made_numbers_of_are_repaired_and_that_is_said(
    tmp_path: Path,
) -> None:
    text = "id,name\n12.0,Ann\n0013,Ben\n"
    result = kinegrade("roster", write(tmp_path, text))
    assert "1 id became a number with a fraction in a spreadsheet, such as" in result.stdout
    assert read(tmp_path, text)[0][0] == "12"
    assert read(tmp_path, 'id,name\n"=""007""",Ann\n')[0][0] == "007"
    guarded = "OrgDefinedId,Last Name,First Name\n#007,Lovelace,Ada\n#008,Noether,Emmy\n"
    assert [student for student, *_ in read(tmp_path, guarded)] == ["007", "008"]


@pytest.mark.parametrize("cell", ["1.2E+05", "2,021E+11"])
def test_ids_whose_digits_are_lost_are_refused(tmp_path: Path, cell: str) -> None:
    path = write(tmp_path, f'id;name\n"{cell}";Ann\n')
    result = kinegrade("roster", path)
    assert result.exit_code == 2
    assert f'roster.csv:2: student id "{cell}" is not what was typed' in result.stderr


def test_ids_that_a_workbook_shortened_are_refused(tmp_path: Path) -> None:
    path = write_sheet(tmp_path, [["id", "name"], [2021000000000001234, "Ann"]])
    with pytest.raises(TableError, match="expected all its digits"):
        Roster.read(path)


def test_repaired_ids_that_meet_are_refused_with_both_lines(tmp_path: Path) -> None:
    result = kinegrade("roster", write(tmp_path, "id,name\n12.0,Ann\n12,Ben\n"))
    assert result.exit_code == 2
    assert 'student id "12" stands on lines 2 and 3' in result.stderr


def test_a_few_ids_without_zeros_are_a_complaint(tmp_path: Path) -> None:
    lines = "".join(f"00123{place},Ann\n" for place in range(10, 19))
    result = kinegrade("roster", write(tmp_path, f"id,name\n{lines}12377,Ben\n"))
    assert result.exit_code == 1
    assert '1 id has fewer than the usual 7 digits: "12377" on line 11' in result.stderr


def test_what_a_cell_means_must_be_known(tmp_path: Path) -> None:
    text = "id,name,language,extra time\n1,Ann,tlh,lots\n2,Ben,Deutsch,1/4\n3,Cy,,no\n"
    result = kinegrade("roster", write(tmp_path, text))
    assert result.exit_code == 2
    assert result.stderr.splitlines() == [
        'error: roster.csv:2: "tlh" is no language of papers - expected one of de, en, zh, which '
        "this version of kinegrade knows - correct it, or do without the column: "
        "--column language=",
        'error: roster.csv:2: extra time "lots" is not understood - expected a number with its '
        "unit, such as 25 % or 30 min, or nothing - correct it, or do without the column: "
        "--column extra-time=",
        'error: roster.csv:3: extra time "1/4" is not understood - expected a number with its '
        "unit, such as 25 % or 30 min, or nothing - correct it, or do without the column: "
        "--column extra-time=",
    ]


def test_two_students_do_not_sit_on_one_seat(tmp_path: Path) -> None:
    text = "id,name,room,seat\n1,Ann,H1,3\n2,Ben,H2,3\n3,Cy,H1,3\n"
    result = kinegrade("roster", write(tmp_path, text))
    assert result.exit_code == 2
    assert "roster.csv:4: seat 3 in room H1 is that of line 2 already" in result.stderr


def test_merged_cells_leave_gaps_that_are_named(tmp_path: Path) -> None:
    text = "id,name,room\n1,Ann,H1\n2,Ben,\n"
    result = kinegrade("roster", write(tmp_path, text))
    assert result.exit_code == 1
    assert "room: nothing for 1 student, 2 - line 3; in a spreadsheet" in result.stderr


def test_a_cell_that_is_empty_is_not_taken_for_merged(tmp_path: Path) -> None:
    text = "id,name,room\n1,Ann,H1\n2,Ben,H1\n3,Cy,\n4,Dee,H2\n"
    result = kinegrade("roster", write(tmp_path, text))
    assert result.exit_code == 1
    assert result.stderr.endswith("room: nothing for 1 student, 3 - line 4\n")


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "is empty"),
        (b"\n\n,,\n", "is empty"),
        (b"student,name\n", "has no students"),
        (b"%PDF-1.7", "expected a CSV file"),
        (b"student,name\n\x00\x01\x02\x03\x04\x05\x06,x\n" * 3, "expected a CSV file"),
    ],
)
def test_what_is_no_roster_is_refused_in_one_line(
    tmp_path: Path, content: bytes, said: str
) -> None:
    result = kinegrade("roster", write(tmp_path, content))
    assert result.exit_code == 2
    (line,) = result.stderr.splitlines()
    assert said in line


def test_formulas_in_unused_columns_are_no_complaints(tmp_path: Path) -> None:
    lines = [["id", "name", "sum"], ["1", "Ann", "=1+1"], ["2", "=A2", 2]]
    result = kinegrade("roster", write_sheet(tmp_path, lines))
    assert result.exit_code == 1
    assert "sum" not in result.stderr
    assert "roster.xlsx:3: name" in result.stderr


def test_a_roster_of_five_megabytes_is_read_in_seconds(tmp_path: Path) -> None:
    lines = "".join(f"{place:07},Ann {'x' * 90},G{place % 9}\n" for place in range(52_000))
    path = write(tmp_path, f"title\n\nid,name,group\n{lines}")
    assert path.stat().st_size > 5_000_000
    begin = perf_counter()
    assert len(Roster.read(path).students) == 52_000
    assert perf_counter() - begin < 20


def test_a_line_of_totals_is_a_complaint(tmp_path: Path) -> None:
    lines = "".join(f"s{place},Ann\n" for place in range(10, 19))
    result = kinegrade("roster", write(tmp_path, f"id,name\n{lines}Total,9\n"))
    assert result.exit_code == 1
    assert '"Total" on line 11 has no digit, as nearly all other ids have' in result.stderr


def test_ids_that_are_names_are_no_complaint(tmp_path: Path) -> None:
    result = kinegrade("roster", write(tmp_path, "id,name\nann,Ann\nben,Ben\nzoe2,Zoe\n"))
    assert result.exit_code == 0
