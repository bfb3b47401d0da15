"""Responses of Moodle quizzes: the files Moodle itself wrote in three languages, and every shape
they may have.
"""

from __future__ import annotations

import csv
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.errors import TableError
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.lms.responses.answer_table import read_responses
from kinegrade.lms.responses.cloze import Wording, part_count, parts, wording
from tests.lms.response_files import SAMPLES, cells, csv_text, responses, told, write_asks
from tests.said import said

LANGUAGES = ("en", "de", "zh_cn")
SAMPLE_ASKS = {"q1": ("omega_3",), "q2": ("v_B",), "q3": ("a_B",), "q4": ("v", "a", "dir")}
SAMPLE_STUDENTS = {f"000{number}": f"W{number}@Example.invalid" for number in (1, 2, 4)}
SAMPLE_ROWS = [
    ("0001", "-12.345", "1500 mm/s", "0", "1.234", "-56.7", "CCW"),
    ("0002", "-12.345 rad/s", "1,5", "=1+1", "1.3", "-56,7", "CW"),
    ("0004", "-1.2345x10^1", "", "", "1.234", "", ""),
]
WORDINGS = [
    Wording("part ", ":"),
    Wording("Teil ", ":"),
    Wording("子问题 ", "："),
    Wording("partie ", " :"),
    Wording("パート ", ":"),
]
HEADER = (
    "Last name",
    "First name",
    "ID number",
    "Status",
    "Started",
    "Completed",
    "Duration",
    "Grade/10.00",
)
NAMES = ("Response 1", "Response 2")


def attempt(
    student: str, *typed: str, grade: str = "5.00", duration: str = "2 mins"
) -> tuple[str, ...]:
    return ("Wang", "Wei", student, "Finished", "1 May", "1 May", duration, grade, *typed)


def cloze(*typed: str) -> str:
    return "; ".join(f"part {number}: {text}" for number, text in enumerate(typed, 1))


def sample(folder: Path, language: str, kept: tuple[int, ...]) -> Path:
    """A sample of which only these columns of each question are left, as if the others had not been
    ticked.
    """
    with (SAMPLES / f"{language}-responses.csv").open(encoding="utf-8-sig", newline="") as file:
        rows = list(csv.reader(file))
    short = [
        row[:8] + [row[8 + 3 * slot + column] for slot in range(4) for column in kept]
        for row in rows
    ]
    path = folder / "sample.csv"
    path.write_text(csv_text(*short), encoding="utf-8-sig")
    return path


@pytest.mark.parametrize("language", LANGUAGES)
def test_what_moodle_wrote_is_read_as_it_was_typed(tmp_path: Path, language: str) -> None:
    exam = write_asks(tmp_path, SAMPLE_ASKS, SAMPLE_STUDENTS)
    read = read_responses(SAMPLES / f"{language}-responses.csv", open_exam(exam))
    assert read.source == "moodle"
    assert cells(read) == [
        ("student", "q1.omega_3", "q2.v_B", "q3.a_B", "q4.v", "q4.a", "q4.dir"),
        *SAMPLE_ROWS,
    ]
    assert [row.line for row in read.table.rows] == [3, 4, 5]
    assert told(read) == [(2, "no attempt, or one without answers", "not graded")]
    assert (
        said(read.assumed[0])
        == f"{language}-responses.csv: taken for the responses of a Moodle quiz"
    )


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("kept", [(1,), (0, 1), (1, 2)])
def test_text_and_right_answer_need_not_be_there(
    tmp_path: Path, language: str, kept: tuple[int, ...]
) -> None:
    exam = write_asks(tmp_path, SAMPLE_ASKS, SAMPLE_STUDENTS)
    read = read_responses(sample(tmp_path, language, kept), open_exam(exam))
    assert [row.cells for row in read.table.rows] == SAMPLE_ROWS


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("kept", [(0,), (2,), (0, 2)])
def test_a_download_without_responses_is_refused(
    tmp_path: Path, language: str, kept: tuple[int, ...]
) -> None:
    exam = write_asks(tmp_path, SAMPLE_ASKS, SAMPLE_STUDENTS)
    with pytest.raises(
        TableError, match=r"but no responses - expected a column of them - download the quiz's"
    ):
        read_responses(sample(tmp_path, language, kept), open_exam(exam))


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_report_of_grades_is_told_from_that_of_responses(tmp_path: Path, language: str) -> None:
    exam = write_asks(tmp_path, SAMPLE_ASKS, SAMPLE_STUDENTS)
    with pytest.raises(
        TableError, match="is Moodle's grades report, without responses - expected the quiz's"
    ):
        read_responses(SAMPLES / f"{language}-grades.csv", open_exam(exam))


def test_each_ask_may_be_a_question_of_its_own(tmp_path: Path) -> None:
    names = ("Réponse 1", "Réponse 2", "Réponse 3")
    read = responses(tmp_path, csv_text((*HEADER, *names), attempt("0012346", "3 m/s", "-", "=4")))
    assert cells(read)[1:] == [("0012346", "3 m/s", "", "=4")]


def test_slots_numbered_otherwise_are_found_too(tmp_path: Path) -> None:
    names = ("Question i", "Response i", "Question ii", "Response ii")
    text = "Find the speed of the slider B and the angular velocity"
    read = responses(
        tmp_path, csv_text((*HEADER, *names), attempt("S9", text, cloze("1", "2"), text, "3"))
    )
    assert cells(read)[1:] == [("S9", "1", "2", "3")]


def test_attempts_are_rows_in_the_order_of_the_file(tmp_path: Path) -> None:
    rows = [attempt("S9", cloze("1", "2"), "3"), attempt("S9", cloze("4", "5"), "6")]
    assert cells(responses(tmp_path, csv_text((*HEADER, *NAMES), *rows)))[1:] == [
        ("S9", "1", "2", "3"),
        ("S9", "4", "5", "6"),
    ]


def test_an_unfinished_attempt_counts_only_when_asked_for(tmp_path: Path) -> None:
    content = csv_text(
        (*HEADER, *NAMES),
        attempt("S9", cloze("1", "2"), "-", grade="-", duration="-"),
        attempt("0012346", cloze("1", "2"), "3"),
    )
    read = responses(tmp_path, content)
    assert [row.cells[0] for row in read.table.rows] == ["0012346"]
    assert told(read) == [
        (
            2,
            "the attempt has no grade: it is not finished",
            "not graded, unless unfinished attempts are included (--unfinished): close the "
            "attempt in Moodle first, then download again",
        )
    ]
    assert "part 1: 1; part 2: 2" in read.answers.left_out[0].complaint.content
    assert [row.cells[0] for row in responses(tmp_path, content, attempts="all").table.rows] == [
        "S9",
        "0012346",
    ]


def test_an_attempt_in_progress_is_to_be_closed_in_moodle_first(tmp_path: Path) -> None:
    open_still = ("Wang", "Wei", "S9", "In progress", "1 May", "-", "-", "-", "-", "-")
    content = csv_text((*HEADER, *NAMES), open_still, attempt("0012346", cloze("1", "2"), "3"))
    read = responses(tmp_path, content)
    assert told(read) == [
        (
            2,
            'the attempt was not submitted ("In progress"), and Moodle exports nothing of it',
            "not graded: close the attempt in Moodle first where it is in progress, then download "
            "again",
        )
    ]


def test_an_abandoned_attempt_is_not_called_one_in_progress(tmp_path: Path) -> None:
    abandoned = ("Wang", "Wei", "S9", "Never submitted", "1 May", "-", "-", "-", "-", "-")
    content = csv_text((*HEADER, *NAMES), abandoned, attempt("0012346", cloze("1", "2"), "3"))
    assert told(responses(tmp_path, content))[0][1].startswith(
        'the attempt was not submitted ("Never submitted")'
    )


def test_a_row_of_averages_is_nobody(tmp_path: Path) -> None:
    average = ("Overall average", *[""] * 6, "6.47", "", "")
    read = responses(
        tmp_path, csv_text((*HEADER, *NAMES), attempt("S9", cloze("1", "2"), "3"), average)
    )
    assert told(read) == [(3, "no student: a row of averages", "not graded")]


def test_parts_that_cannot_be_told_apart_are_told_and_not_guessed(tmp_path: Path) -> None:
    rows = [
        attempt("S9", cloze("1; part 2: 9", "2"), "3"),
        attempt("0012345", "1.5", "3"),
        attempt("0012346", cloze("1", "2"), "3"),
        attempt("0012346", cloze("1; part 3: 9", "2"), "3"),
    ]
    names = ("Response 1", "Right answer 1", "Response 2", "Right answer 2")
    whole = [(*row[:9], cloze("1", "2"), row[9], "3") for row in rows]
    read = responses(tmp_path, csv_text((*HEADER, *names), *whole))
    assert [row.cells for row in read.table.rows] == [
        ("S9", "", "", "3"),
        ("0012345", "", "", "3"),
        ("0012346", "1", "2", "3"),
        ("0012346", "1; part 3: 9", "2", "3"),
    ]
    assert told(read) == [
        (
            line,
            "2 parts were expected, and which is which is unclear",
            "q1.v_B, q1.omega_AB count as blank; correct them by hand",
        )
        for line in (2, 3)
    ]
    assert [each.content for each in read.table.complaints] == [
        "part 1: 1; part 2: 9; part 2: 2",
        "1.5",
    ]


@pytest.mark.parametrize("odd", ["1; 2", "part 2: 2; part 1: 1", "1.5"])
@pytest.mark.parametrize("others", [1, 2])
def test_one_odd_cell_leaves_all_others_as_they_were_typed(
    tmp_path: Path, odd: str, others: int
) -> None:
    good = [attempt("S9", cloze("1", "2"), "3"), attempt("0012345", cloze("4", "5"), "6")][:others]
    read = responses(tmp_path, csv_text((*HEADER, *NAMES), *good, attempt("0012346", odd, "9")))
    typed = [("S9", "1", "2", "3"), ("0012345", "4", "5", "6")][:others]
    assert [row.cells for row in read.table.rows] == [*typed, ("0012346", "", "", "9")]
    assert [(each.line, each.content) for each in read.table.complaints] == [(others + 2, odd)]


def test_a_question_nobody_answered_is_blank(tmp_path: Path) -> None:
    read = responses(tmp_path, csv_text((*HEADER, *NAMES), attempt("S9", "-", "3")))
    assert cells(read)[1:] == [("S9", "", "", "3")]


@pytest.mark.parametrize(
    "typed", [("1", "2"), (cloze("1", "2", "3"), "4"), ("1", cloze("2", "3")), ("1",), ("1",) * 4]
)
def test_another_quiz_is_refused_with_what_was_found(
    tmp_path: Path, typed: tuple[str, ...]
) -> None:
    names = tuple(f"Response {number}" for number in range(1, len(typed) + 1))
    with pytest.raises(
        TableError,
        match=rf"it has {len(typed)} questions? with [a-z ]+: [0-9, ]+ - the exam "
        r"has 3 asks in 2 questions \(q1: 2, q2: 1\) - download the responses",
    ):
        responses(tmp_path, csv_text((*HEADER, *names), attempt("S9", *typed)))


@pytest.mark.parametrize(
    ("header", "message"),
    [
        (
            (*HEADER, "Response 1", "Comment"),
            "after the grade comes Response 1, Comment - expected numbered columns",
        ),
        (
            HEADER,
            "after the grade comes nothing - expected numbered columns like Response 1, Response 2",
        ),
        (("student", "q1.v_B"), "has no grades like Grade/10.00 - expected the quiz's responses"),
    ],
)
def test_what_is_no_report_of_responses_is_refused(
    tmp_path: Path, header: tuple[str, ...], message: str
) -> None:
    with pytest.raises(TableError, match=message):
        responses(tmp_path, csv_text(header, attempt("S9")), "moodle")


TYPED = st.lists(st.text(max_size=30), min_size=1, max_size=4)


@given(words=st.sampled_from(WORDINGS), typed=TYPED, others=TYPED)
def test_every_part_comes_out_as_it_was_typed(
    words: Wording, typed: list[str], others: list[str]
) -> None:
    blank = "" if words.colon == "：" else " "

    def cell(texts: list[str]) -> str:
        return "; ".join(
            f"{words.mark(number)}{blank}{text}" for number, text in enumerate(texts, 1)
        )

    whole = cell(typed)
    count = len(typed)
    if wording([whole]) is None:  # never with words of Moodle
        pytest.fail(whole)
    assert wording([whole, cell(others)]) == words
    if all(whole.count(words.separator(number)) == 1 for number in range(2, count + 1)):
        assert parts(whole, words, count) == tuple(typed)
    else:
        assert parts(whole, words, count) is None


@given(
    typed=st.tuples(
        *[st.sampled_from(["; part 2: ", "; part 3:", "part 1: ", "1,5", ";", " "])] * 3
    )
)
def test_separators_that_were_typed_never_move_an_answer(typed: tuple[str, ...]) -> None:
    found = parts(cloze(*typed), WORDINGS[0], 3)
    assert found in (None, typed)
    assert (found is None) == any(
        separator in text for text in typed for separator in ("; part 2:", "; part 3:")
    )


def test_most_cells_say_of_how_many_parts_they_are() -> None:
    assert (
        part_count([cloze("1", "2"), cloze("1; part 3: 7", "2"), cloze("", "")], WORDINGS[0]) == 2
    )
