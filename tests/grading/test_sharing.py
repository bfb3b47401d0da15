"""Answers that fit another paper: planted ones are found, honest classes show nothing, and nobody
is accused.
"""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Iterable, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import chain
from pathlib import Path
from random import Random

import msgspec
import numpy as np
import pytest
from click.testing import CliRunner, Result

from benchmarks.large_class import write_class
from kinegrade.cli.sharing import sharing as command
from kinegrade.errors import ExamError
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.folder.keys import Key
from kinegrade.exam.keyed_exam import read_whole
from kinegrade.grading.fast.bounds import tabulate_rules
from kinegrade.grading.poisson import find_tail
from kinegrade.language import ENGLISH
from kinegrade.language.catalogue import open_catalogue
from kinegrade.marks_folder.rows import MarkedAnswer
from kinegrade.numbers.tolerance import ONE_PER_CENT, Tolerance
from kinegrade.reports.sharing.fits import Windows, find_windows
from kinegrade.reports.sharing.report import HEADER, describe_sharing, write_sharing_csv
from kinegrade.reports.sharing.search import Pair, Search
from kinegrade.reports.sharing.sharing import MOST, Sharing, find_pairs
from tests.grading.marked_folder import mark_class
from tests.grading.sitting_class import SittingClass, honest_slips, sitting_class

_NO_POINTS = Fraction(0), Fraction(3)
HALF = ("q1.v", "q1.a", "q2.v", "q3.omega", "q3.a", "q4.a")


def say(sharing: Sharing) -> str:
    """What is said on the terminal, in English."""
    return "\n".join(map(open_catalogue(ENGLISH).write, describe_sharing(sharing)))


def planted(
    sitting: SittingClass, *sharers: tuple[int, int], columns: tuple[str, ...] = HALF
) -> list[Pair]:
    """The pairs told where everybody errs honestly and the first of each pair writes what is right
    for the second.
    """
    slips, copies = honest_slips(sitting, 7), dict(sharers)
    return list(
        find_pairs(
            sitting.exam,
            sitting.answers(
                lambda place: {
                    **slips(place),
                    **(sitting.copied(copies[place], *columns) if place in copies else {}),
                }
            ),
        ).reported
    )


def named(pairs: Iterable[Pair]) -> set[tuple[str, str]]:
    return {(pair.student.student, pair.other.student) for pair in pairs}


def test_sharers_are_found_in_their_direction_with_what_is_expected_beside_it() -> None:
    sitting = sitting_class(200, 1)
    told = planted(sitting, (5, 17), (40, 3), (41, 3))
    assert named(told) == {("s5", "s17"), ("s40", "s3"), ("s41", "s3")}
    for pair in told:
        assert {answer.column for answer in pair.answers} >= set(HALF)
        assert [
            answer for answer in pair.answers if answer.column in HALF and not answer.as_key
        ] == []
        assert 0 < pair.as_key_expected < pair.expected < len(pair.answers) / 2
        assert pair.chance < 0.01
    assert [pair.chance for pair in told] == sorted(pair.chance for pair in told)


def test_the_mistakes_of_another_paper_are_copied_too() -> None:
    sitting = sitting_class(100, 2)
    doubled = {ask.column: 2 * sitting.key(9, ask.column) for ask in sitting.exam.asks}
    (pair,) = find_pairs(
        sitting.exam, sitting.answers(lambda place: doubled if place == 4 else {})
    ).reported
    assert (pair.student.student, pair.other.student, len(pair.answers)) == (
        "s4",
        "s9",
        len(doubled),
    )
    assert sum(answer.as_key for answer in pair.answers) < 3


@pytest.mark.parametrize("seed", range(10))
def test_an_honest_class_shows_nothing(seed: int) -> None:
    sitting = sitting_class(100, seed)
    found = find_pairs(sitting.exam, sitting.answers(honest_slips(sitting, seed)))
    assert (found.reported, found.found, found.pairs) == ((), 0, 100 * 99)


def test_one_misread_number_is_no_hint() -> None:
    """Whoever misreads a number of one question gives all the answers of the paper that has it."""
    assert planted(sitting_class(200, 1), (5, 17), columns=("q1.v", "q1.omega", "q1.a")) == []


def test_right_blank_explained_and_zero_answers_are_never_counted() -> None:
    sitting = sitting_class(100, 3)
    answers = list(sitting.answers(lambda place: sitting.copied(8, *HALF) if place == 2 else {}))
    assert len(find_pairs(sitting.exam, answers).reported) == 1
    for verdict in ("right", "blank", "mistake", "accepted", "unreadable", "wrong unit", "void"):
        assert not find_pairs(
            sitting.exam, [msgspec.structs.replace(answer, verdict=verdict) for answer in answers]
        ).reported
    for text in ("", "0.000", "1e999"):
        assert not find_pairs(
            sitting.exam, [msgspec.structs.replace(answer, read_as=text) for answer in answers]
        ).reported


def test_equal_papers_are_no_hint_and_the_report_says_so() -> None:
    sitting = sitting_class(100, 4, paper=lambda place: place % 4)
    found = find_pairs(
        sitting.exam, sitting.answers(lambda place: sitting.copied(9, *HALF) if place == 4 else {})
    )
    assert (found.reported, found.papers) == ((), 4)
    assert (
        "100 students had 4 different papers: answers passed on between identical papers leave no trace"
        in say(found)
    )


def test_the_level_is_that_of_the_whole_class() -> None:
    sitting = sitting_class(100, 5)
    answers = list(
        sitting.answers(
            lambda place: sitting.copied(9, "q1.v", "q1.a", "q2.v") if place == 4 else {}
        )
    )
    (pair,) = find_pairs(sitting.exam, answers, 1).reported[:1]
    mean = pair.as_key_expected
    assert pair.chance == pytest.approx(
        min(1, 2 * 100 * 99 * min(find_tail(3, mean), find_tail(3, pair.expected)))
    )
    assert find_pairs(sitting.exam, answers, pair.chance / 2).reported == ()


def test_no_more_pairs_are_told_than_a_person_can_look_at(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("kinegrade.reports.sharing.sharing.MOST", 5)
    sitting = sitting_class(60, 6)
    found = find_pairs(
        sitting.exam, sitting.answers(lambda place: sitting.copied(0, *HALF) if place else {})
    )
    assert (found.found, len(found.reported)) == (59, 5)
    assert f"The file has the {MOST} most striking ones." in say(replace(found, found=MOST + 1))


@pytest.mark.parametrize("level", [0.0001, 0.01, 0.5])
@pytest.mark.parametrize("seed", range(4))
def test_students_who_can_be_in_no_pair_are_left_out_of_the_search(
    seed: int, level: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    sitting, random = sitting_class(150, seed), Random(seed)
    columns = [ask.column for ask in sitting.exam.asks]
    slips = honest_slips(sitting, seed)
    copies = {
        place: sitting.copied(random.randrange(150), *random.sample(columns, random.randint(1, 8)))
        for place in range(0, 150, 3)
    }
    answers = [*sitting.answers(lambda place: {**slips(place), **copies.get(place, {})})]
    found = find_pairs(sitting.exam, answers, level)
    monkeypatch.setattr(Search, "_may_tell", lambda _, students, kind: students >= 0)
    assert find_pairs(sitting.exam, answers, level) == found
    assert found.found


def test_a_class_is_searched_by_the_columns_of_its_key_as_by_the_key(tmp_path: Path) -> None:
    write_class(tmp_path, 200, 0.0)
    exam = open_exam(tmp_path / "EXAM")
    examinees = read_whole(exam).examinees
    copied = {place: {**examinees[place + 1].keys} for place in range(0, 40, 4)}
    answers = [
        MarkedAnswer(
            examinee.student, ask.question, ask.ask, text, text, ask.unit, verdict, *_NO_POINTS, ""
        )
        for place, examinee in enumerate(examinees)
        for ask in exam.asks
        for key in [copied.get(place, examinee.keys)[ask.column]]
        for text in [f"{float(key.value):.6g}"]
        for verdict in ["wrong" if place in copied else "right"]
    ]
    by_columns = find_pairs(exam, answers)
    assert by_columns == find_pairs(read_whole(exam), answers)
    assert named(by_columns.reported) == {
        (examinees[place].student, examinees[place + 1].student) for place in copied
    }


def test_a_class_of_two_thousand_in_seconds() -> None:
    sitting = sitting_class(2000, 8)
    everything = tuple(ask.column for ask in sitting.exam.asks)
    assert named(planted(sitting, (3, 1999), (1500, 20), columns=everything)) == {
        ("s3", "s1999"),
        ("s1500", "s20"),
    }


def windows_of(keys: Sequence[Key]) -> Windows:
    """What is right by the keys of one ask, a paper for each."""
    values = np.array([float(key.value) for key in keys])
    rules = tabulate_rules([tuple(key.rule for key in keys)])
    return find_windows(np.arange(len(keys)), values, rules, float(keys[0].period or 0))


def test_what_fits_is_what_would_be_right_there() -> None:
    keys = [
        Key(Fraction(2), ONE_PER_CENT),
        Key(Fraction("2.034"), Tolerance(figures=3)),
        Key(Fraction("0.4"), Tolerance(Fraction(1, 100), Fraction(1, 2))),
        Key(Fraction(0), ONE_PER_CENT),
    ]
    found = windows_of(keys)
    assert [
        found.papers(number) for number in (2.0199, 2.0201, 2.0251, 2.0349, 2.0351, 0.4, 0.0)
    ] == [{0}, set(), {1}, {1}, set(), set(), set()]


def test_angles_are_compared_without_full_turns() -> None:
    keys = [Key(Fraction(value), ONE_PER_CENT, Fraction(360)) for value in (359, -90, 20)]
    found = windows_of(keys)
    assert [found.papers(number) for number in (1.0, -1.0, 270.0, -450.0, 740.1)] == [
        {0},
        {0},
        {1},
        {1},
        {2},
    ]


def test_marks_of_another_exam_are_refused() -> None:
    sitting, larger = sitting_class(3, 1), sitting_class(4, 1)
    with pytest.raises(
        ExamError,
        match=r'^marks.csv: student "s3" is not in the exam - expected marks made from this',
    ):
        find_pairs(sitting.exam, larger.answers(lambda place: {}))


def test_marks_that_are_not_as_written_are_refused_with_all_faults_at_once() -> None:
    sitting = sitting_class(3, 1)
    first, second, *others = sitting.answers(lambda place: {})
    with pytest.raises(ExamError) as caught:
        find_pairs(
            sitting.exam,
            [
                msgspec.structs.replace(first, read_as="=1"),
                msgspec.structs.replace(second, ask="x"),
                *others,
            ],
        )
    assert caught.value.problems == (
        'marks.csv: student "s0", q1.v: "=1" stands where a number should - expected the file as '
        "kinegrade grade wrote "
        "it - grade again",
        'marks.csv: ask "q1.x" is not in the exam - expected marks made from this exam folder - '
        "name the folder by "
        "which they were made",
    )


def test_nobody_is_accused_and_no_cell_runs() -> None:
    sitting = sitting_class(60, 9, name=lambda place: f"=HYPERLINK({place})")
    found = find_pairs(
        sitting.exam, sitting.answers(lambda place: sitting.copied(1, *HALF) if place == 2 else {})
    )
    header, row = csv.reader(io.StringIO(write_sharing_csv(found, ENGLISH).decode("utf-8-sig")))
    told = dict(zip(header, row, strict=True))
    assert tuple(header) == HEADER
    assert (told["student"], told["name"], told["other"], told["other_name"]) == (
        "s2",
        "'=HYPERLINK(2)",
        "s1",
        "'=HYPERLINK(1)",
    )
    assert told["note"] == "worth a look; not evidence of anything by itself"
    assert (
        told["fit_the_other_paper"],
        told["right_there"],
        float(told["expected_by_chance"]) < 2,
    ) == ("6", "6", True)
    assert told["answers"].startswith("q1.v ")
    text = say(found)
    assert text.startswith(
        "1 pair is worth a look, of 3540: more of a student's wrong answers fit the other's paper"
    )
    assert "not evidence of anything by itself" in text
    for word in ("cheat", "copied", "suspect", "fraud", "guilty", "dishonest"):
        assert (
            word not in text.lower() + write_sharing_csv(found, ENGLISH).decode("utf-8-sig").lower()
        )


def test_an_id_is_a_key_and_stays_as_it_is() -> None:
    sitting = sitting_class(60, 9)
    found = find_pairs(
        sitting.exam, sitting.answers(lambda place: sitting.copied(1, *HALF) if place == 2 else {})
    )
    (pair,) = found.reported
    odd = replace(pair, student=pair.student._replace(student="=2"))
    _, row = csv.reader(
        io.StringIO(write_sharing_csv(replace(found, reported=(odd,)), ENGLISH).decode())
    )
    assert (row[0], row[2]) == ("=2", "s1")


def command_line(*arguments: object) -> Result:
    return CliRunner().invoke(command, list(map(str, arguments)))


def test_the_command_reads_the_folders_and_writes_the_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    exam, marks = mark_class(tmp_path, {f"s{place}": ("9.99", "5", "7") for place in range(4)})
    result = command_line(exam, marks, "-o", tmp_path / "sharing.csv")
    assert (result.exit_code, result.stdout) == (0, "")
    assert result.stderr.startswith(
        "No pair of students stands out, of 12, at the level of 1 % for the whole class."
    )
    assert (tmp_path / "sharing.csv").read_text(encoding="utf-8-sig") == f"{','.join(HEADER)}\n"
    monkeypatch.setenv("LC_ALL", "zh_CN.UTF-8")
    chinese = command_line(exam, marks, "-o", tmp_path / "again.csv")
    assert chinese.stderr.startswith("在 12 对学生中，按全班 1 % 的水平，没有哪一对突出。")
    monkeypatch.delenv("LC_ALL")
    again = command_line(exam, marks, "-o", tmp_path / "sharing.csv")
    assert (again.exit_code, "--force" in again.stderr) == (2, True)
    assert command_line(exam, marks, "-o", tmp_path / "x.csv", "--level", "0").exit_code == 2


def test_the_command_finds_who_shares(tmp_path: Path) -> None:
    exam, marks = mark_class(
        tmp_path, {f"s{place}": RIGHT_OF_ONE if place == 2 else () for place in range(40)}
    )
    keyed_apart(exam)
    result = command_line(exam, marks, "-o", tmp_path / "sharing.csv", "--level", "50")
    assert result.exit_code == 0, result.stderr
    rows = list(
        csv.DictReader(io.StringIO((tmp_path / "sharing.csv").read_text(encoding="utf-8-sig")))
    )
    assert [(row["student"], row["other"], row["fit_the_other_paper"]) for row in rows] == [
        ("s2", "s1", "3")
    ]


RIGHT_OF_ONE = ("17.3", "11", "-1.25")


def keyed_apart(exam: Path) -> None:
    """Every paper gets answers of its own; those of s1 are `RIGHT_OF_ONE`."""
    lines = [
        json.loads(line) for line in (exam / "key.jsonl").read_text(encoding="utf-8").splitlines()
    ]
    for place, line in enumerate(lines):
        asks = chain.from_iterable(question["asks"].values() for question in line["questions"])
        for ask, text in zip(asks, RIGHT_OF_ONE, strict=True):
            value = float(text) if place == 1 else 1000 + 37 * place
            ask.update(
                exact=None,
                value=value,
                decimal=repr(value),
                tolerance={"relative": 0.01, "absolute": 0},
            )
    (exam / "key.jsonl").write_text(
        "".join(f"{json.dumps(line)}\n" for line in lines), encoding="utf-8"
    )
