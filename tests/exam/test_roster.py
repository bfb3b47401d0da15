"""The class as registries export it: ids stay texts, and everybody gets a paper."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.errors import TableError
from kinegrade.exam.roster.roster import Roster, parse_roster
from kinegrade.exam.roster.students import Student, make_file_names
from tests.said import all_said, said


def roster(text: str) -> Roster:
    return parse_roster(text.encode(), "roster.csv")


@pytest.mark.parametrize(
    "header",
    [
        "student,name,email",
        "ID,Full Name,E-mail",
        "ID number,NAME,Email address",
        "学号,姓名,邮箱",
        "\ufeffStudent ID, name ,EMAIL",
    ],
)
def test_columns_are_known_by_their_usual_names(header: str) -> None:
    found = roster(f"{header}\n 007 ,王伟,w@x.cn\n")
    assert found == Roster((Student("007", "王伟", "w@x.cn", "007"),), ())


def test_a_column_that_can_only_hold_ids_wins_over_a_running_number() -> None:
    found = roster("ID,Matrikelnummer,Name\n1,007,Ann\n2,008,Ben\n")
    assert [each.student for each in found.students] == ["007", "008"]
    assert said(found.notes[-1]) == (
        'roster.csv: ids are those of "Matrikelnummer", not of "ID"; --column student=HEADER takes '
        "another column"
    )
    alike = roster("ID,Matrikelnummer,Name\n007,007,Ann\n008,008,Ben\n")
    assert "ids are those of" not in "".join(all_said(alike.notes))


def test_an_address_of_two_students_is_remarked() -> None:
    found = roster("student,name,email\n1,Ann,a@x\n2,Ben,A@x\n3,Cy,\n4,Di,\n")
    assert all_said(found.notes)[-1] == (
        'roster.csv: the e-mail address a@x is that of the students "1" and "2"'
    )


def test_columns_stand_in_any_order_and_others_are_ignored(tmp_path: Path) -> None:
    path = tmp_path / "roster.csv"
    path.write_text(
        'Section;Name;Student\nA;"Müller; Jürgen";0012\nA;Ann   Lee;13\n', encoding="utf-8"
    )
    assert [(each.student, each.name, each.email) for each in Roster.read(path).students] == [
        ("0012", "Müller; Jürgen", ""),
        ("13", "Ann Lee", ""),
    ]


def test_two_students_may_have_one_name_but_not_one_id() -> None:
    assert len(roster("student,name\n1,Ann\n2,Ann\n").students) == 2
    with pytest.raises(
        TableError, match='roster.csv: student id "007" stands on lines 2 and 4 - expected each id'
    ):
        roster("student,name\n007,Ann\n7,Bob\n００７,Cy\n")


def test_all_faults_are_reported_at_once() -> None:
    with pytest.raises(TableError) as caught:
        roster("student,name\n,Ann\n1,Bob\n1,Cy\n \u3000,Dan\n")
    assert caught.value.problems == (
        'roster.csv:2: no student id ("Ann") - expected one on every line - add it',
        'roster.csv:5: no student id ("Dan") - expected one on every line - add it',
        'roster.csv: student id "1" stands on lines 3 and 4 - expected each id once - correct or '
        "delete one",
    )


def test_missing_columns_are_named_with_what_is_there() -> None:
    with pytest.raises(TableError) as caught:
        roster("number,colour\n1,red\n")
    (problem,) = caught.value.problems
    assert problem.startswith('roster.csv: no column for "student", "name"')
    assert "the columns here are: number, colour" in problem


def test_a_roster_without_students_is_refused() -> None:
    with pytest.raises(TableError, match="roster.csv: has no students"):
        roster("student,name\n")


def test_a_student_without_a_name_gets_a_paper_and_a_complaint() -> None:
    found = roster("student,name\n007,\n")
    assert found.students[0].name == ""
    assert [str(complaint) for complaint in found.complaints] == [
        "roster.csv:2: name: no name - the paper carries the id alone"
    ]


@pytest.mark.parametrize(
    ("student", "stem"),
    [
        ("007", "007"),
        ("S1234-b_c.d", "S1234-b_c.d"),
        ("../x", "%2E.%2Fx"),
        ("a/b", "a%2Fb"),
        ("CON", "%43ON"),
        ("nul.txt", "%6Eul.txt"),
        ("a\0\n", "a%00%0A"),
        ("学1", "%E5%AD%A61"),
        ("~", "%7E"),
        ("50%", "50%25"),
    ],
)
def test_file_names_are_safe_and_plain_ids_stay_plain(student: str, stem: str) -> None:
    assert make_file_names([student]) == {student: stem}


def test_ids_that_differ_only_by_case_get_files_that_do_not() -> None:
    assert make_file_names(["abc", "ABC", "X"]) == {"abc": "abc", "ABC": "%41%42%43", "X": "X"}
    assert len({stem.lower() for stem in make_file_names(["con", "CON", "Con"]).values()}) == 3


def test_long_ids_get_short_files() -> None:
    stems = make_file_names(["x" * 500, "x" * 501, "X" * 500])
    assert len({stem.lower() for stem in stems.values()}) == 3
    assert max(map(len, stems.values())) <= 100


@given(
    st.sets(st.text(st.sampled_from("aA%cCoOnN.~-/2E é\0"), min_size=1, max_size=5), max_size=60)
)
def test_file_names_differ_on_every_file_system(students: set[str]) -> None:
    stems = make_file_names(students).values()
    assert len({stem.lower() for stem in stems}) == len(students)
    assert [
        stem for stem in stems if not stem.isascii() or set(stem) & set("/\\: \0") or stem[0] == "."
    ] == []


@pytest.mark.parametrize("student", ["=2", "+49", "-1", "@a", "=HYPERLINK(1)", "\uff1d2"])
def test_an_id_that_a_spreadsheet_would_run_is_refused(student: str) -> None:
    text = f"student,name\n1,Ann\n{student},Bob\n"
    with pytest.raises(TableError) as caught:
        roster(text)
    (problem,) = caught.value.problems
    assert problem.startswith(
        f'roster.csv:3: student id "{student}" (Bob) begins with {student[0]}'
    )
    assert problem.endswith("correct it, or add --allow-odd-ids")
    allowed = parse_roster(text.encode(), "roster.csv", odd_ids=True)
    assert [each.student for each in allowed.students] == ["1", student]


@pytest.mark.parametrize("student", ["2026-05-01", "1/5/2026", "01.05.2026"])
def test_an_id_that_reads_as_a_date_is_refused_unless_it_is_wanted(student: str) -> None:
    text = f"student,name\n3-4,Ann\n{student},Bob\n"
    with pytest.raises(TableError) as caught:
        roster(text)
    (problem,) = caught.value.problems
    assert problem.startswith(f'roster.csv:3: student id "{student}" (Bob) reads as a date')
    assert problem.endswith("enter it again, or add --allow-odd-ids")
    allowed = parse_roster(text.encode(), "roster.csv", odd_ids=True)
    assert [each.student for each in allowed.students] == ["3-4", student]


def test_ids_that_differ_by_zeros_alone_are_refused_unless_they_are_wanted() -> None:
    text = "student,name\n03100037,Ann\n5,Bob\n3100037,Ann\n"
    with pytest.raises(TableError) as caught:
        roster(text)
    assert caught.value.problems == (
        'roster.csv: student ids "03100037" and "3100037" on lines 2 and 4 differ by zeros in front '
        "alone, which spreadsheets drop - use one id for one person, or add --allow-odd-ids if they "
        "are several people",
    )
    assert len(parse_roster(text.encode(), "roster.csv", odd_ids=True).students) == 3


def test_odd_ids_are_refused_with_all_other_faults() -> None:
    with pytest.raises(TableError) as caught:
        roster("student,name\n,Ann\n=1,Bob\n@2,Cy\n")
    assert len(caught.value.problems) == 3
