"""The class report: right figures, any number of students, one file that needs nothing else."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Literal

import numpy as np
import pytest

from kinegrade.errors import TableError
from kinegrade.exam.exam_wording import ExamWording
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.language import ENGLISH
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Message, Part
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.press.html.short_texts import write_prose_html, write_symbol_html
from kinegrade.reports.classes.page import class_report
from kinegrade.reports.classes.tally import ClassTally, tally
from tests.grading.marked_folder import RIGHT, Answers, Page, mark_class

WRONG = ("99", "99", "99")
HALF = ("1.732", "99", "-0.125")
PLAIN = ExamWording()
WORDING = ExamWording(
    {"q1": "Crank $OA$"},
    {"q1.v_B": "speed of $B$"},
    {"q1.v_B": "v_{B}"},
    {("q1", "r"): "r_{1}"},
    mistakes={"wrong-pole": "The pole lies elsewhere."},
)


def report(
    folder: Path, answers: Answers, language: Literal["en", "zh"] = "en", **more: object
) -> str:
    exam, marks = mark_class(folder, answers, **more)  # type: ignore[arg-type]
    return class_report(MarksFolder(marks), open_exam(exam), WORDING, language)


def say(key: str, **parts: Part) -> str:
    """An entry of the report in English."""
    return open_catalogue(ENGLISH).write(Message(f"report.{key}", **parts))


def tallied(exam: Path, marks: Path) -> ClassTally:
    return tally(MarksFolder(marks), open_exam(exam))


def in_turns(count: int, *rows: tuple[str, ...]) -> dict[str, tuple[str, ...]]:
    return {str(place): rows[place % len(rows)] for place in range(count)}


@pytest.mark.parametrize("language", ["en", "zh"])
@pytest.mark.parametrize("count", [0, 1, 2, 3])
def test_a_report_of_hardly_anybody_is_a_page(
    tmp_path: Path, count: int, language: Literal["en", "zh"]
) -> None:
    html = report(tmp_path, in_turns(count, RIGHT, WRONG) | {"absent": ()}, language)
    page = Page(html)
    words = open_catalogue(language)
    assert words.text("report.counted", answered=count, roster=count + 1) in page.text
    assert ("lang", words.text("language.tag")) in page.attributes
    assert (words.text("report.page.nobody") in page.text) == (count == 0)
    assert (words.text("report.page.few") in page.text) == (count > 0)
    assert (words.text("report.too-few", enough=30) in page.text) == (count > 0)
    assert not re.search(r"\b(?:nan|inf|None)\b", html)


def test_a_page_stands_by_itself(tmp_path: Path) -> None:
    text = report(
        tmp_path, in_turns(40, RIGHT, WRONG, HALF), parameters=lambda student: {"r": float(student)}
    )
    page = Page(text)
    assert page.tags.isdisjoint({"script", "link", "img", "iframe", "a", "object"})
    assert not [
        name for name, _ in page.attributes if name in ("src", "href") or name.startswith("on")
    ]
    assert not re.search(r"https?:|url\(|@import", text)


def test_the_same_marks_give_the_same_page(tmp_path: Path) -> None:
    exam, marks = mark_class(
        tmp_path, in_turns(31, RIGHT, WRONG), parameters=lambda student: {"r": float(student)}
    )
    assert class_report(MarksFolder(marks), open_exam(exam), WORDING, "zh") == class_report(
        MarksFolder(marks), open_exam(exam), WORDING, "zh"
    )


def test_who_answered_nothing_is_named_and_not_counted(tmp_path: Path) -> None:
    counts = tallied(*mark_class(tmp_path, {"1": RIGHT, "2": (), "3": ("", " - ", ""), "4": WRONG}))
    assert [each.student for each in counts.answered] == ["1", "4"]
    assert [each.student for each in counts.silent] == ["2", "3"]
    assert counts.percents == [100, 0]
    assert np.array_equal(counts.points, [[4, 3, 2.5], [0, 0, 0]])
    assert counts.share("q1").tolist() == [1, 0]


def test_every_answer_that_lost_points_has_one_reason(tmp_path: Path) -> None:
    rows = [
        ("-1.732", "5", "oops"),
        ("17.32", "1 m/s", ""),
        ("0", "0", "-0.25"),
        ("1.8", "0", "1"),
        RIGHT,
    ]
    exam, marks = mark_class(tmp_path, in_turns(len(rows), *rows))
    counts = tallied(exam, marks)
    assert counts.losses["q1.v_B"] == {
        "opposite": 1,
        "power of ten": 1,
        "unexplained": 1,
        "close": 1,
    }
    assert counts.losses["q1.omega_AB"] == {"unexplained": 1, "wrong unit": 1}
    assert counts.losses["q2.a_B"] == {"unreadable": 1, "blank": 1, "twice": 1, "unexplained": 1}
    short = [answer for answer in MarksFolder(marks).answers() if answer.points < answer.out_of]
    assert sum(reasons.total() for reasons in counts.losses.values()) == len(short)
    assert sum(verdicts.total() for verdicts in counts.verdicts.values()) == 3 * len(rows)


def test_mistakes_that_the_marks_name_are_counted_by_their_sentences(tmp_path: Path) -> None:
    exam, marks = mark_class(tmp_path, in_turns(3, WRONG))
    text = (marks / "marks.csv").read_text(encoding="utf-8")
    named = re.sub(r"(q1,v_B,.*),wrong,0,4,.*", r"\1,mistake,1,4,wrong,wrong-pole,", text)
    (marks / "marks.csv").write_text(named.replace("wrong-pole", "brand-new", 1), encoding="utf-8")
    assert tallied(exam, marks).losses["q1.v_B"] == {"wrong-pole": 2, "brand-new": 1}
    page = Page(class_report(MarksFolder(marks), open_exam(exam), WORDING, "en"))
    assert "The pole lies elsewhere." in page.text
    assert "brand-new" in page.text
    assert "known mistake\u00a03" in page.text


def test_an_ask_in_which_strong_papers_do_worse_is_pointed_out(tmp_path: Path) -> None:
    against = {"1": ("1.732", "0", "9"), "2": ("9", "9", "-0.125")}
    page = Page(report(tmp_path, in_turns(40, *against.values())))
    assert say("negative") in page.text
    assert say("page.few") not in page.text


@pytest.mark.parametrize(
    ("count", "said", "interval"),
    [(8, "low-by-chance", "−0.70 to 0.70"), (80, "flat", "−0.22 to 0.22")],
)
def test_a_low_discrimination_is_judged_by_its_confidence(
    tmp_path: Path, count: int, said: str, interval: str
) -> None:
    rows = [(*first, last) for first in (("1.732", "0"), ("9", "9")) for last in ("-0.125", "9")]
    page = Page(report(tmp_path, in_turns(count, *rows)))
    judged = {key: say(key) in page.text for key in ("low-by-chance", "flat", "negative")}
    assert judged == {key: key == said for key in judged}
    assert interval in page.text


def test_an_ask_that_everybody_got_is_easy_and_one_that_nobody_got_is_hard(tmp_path: Path) -> None:
    page = Page(report(tmp_path, in_turns(5, ("1.732", "9", "-0.125"), ("1.732", "9", "9"))))
    assert (page.text.count("easy"), page.text.count(" hard")) == (
        1 + ENGLISH_EASY,
        1 + ENGLISH_HARD,
    )


ENGLISH_EASY = say("page.definition-facility").count("easy")
ENGLISH_HARD = say("page.hardness").count(" hard")


def test_a_harder_version_is_told_from_chance(tmp_path: Path) -> None:
    def version(student: str) -> str:
        return "AB"[int(student) % 2]

    unfair = Page(report(tmp_path / "1", in_turns(40, RIGHT, HALF), version=version))
    assert say("versions-differ") in unfair.text
    assert "p = < 0.001" in unfair.text or "p = 0.00" in unfair.text
    fair = Page(report(tmp_path / "2", in_turns(40, RIGHT, RIGHT, HALF, HALF), version=version))
    assert say("versions-alike") in fair.text
    few = Page(report(tmp_path / "3", in_turns(12, RIGHT, HALF), version=version))
    assert say("too-few", enough=30) in few.text
    assert "Kruskal-Wallis: H" not in few.text


def test_drawn_numbers_are_a_hint_only_where_they_stand_out(tmp_path: Path) -> None:
    cells = {str(place): RIGHT if place < 20 else WRONG for place in range(40)}
    clear = Page(
        report(tmp_path / "1", cells, parameters=lambda student: {"r": float(student), "k": 2.0})
    )
    assert say("trends", numbers=1, conclusion="") in clear.text
    assert say("trend-found") in clear.text
    random = Page(
        report(tmp_path / "2", cells, parameters=lambda student: {"r": int(student) * 7 % 5})
    )
    assert say("no-trend") in random.text
    same = Page(report(tmp_path / "3", cells))
    assert say("same-papers") in same.text


@pytest.mark.parametrize("language", ["en", "zh"])
def test_nothing_from_a_file_becomes_a_tag(tmp_path: Path, language: Literal["en", "zh"]) -> None:
    hostile = (
        "<script>alert(1)</script>",
        "<img src=x onerror=alert(1)>",
        '"><svg onload=alert(1)>',
    )
    answers = in_turns(3, RIGHT, hostile) | {"<b>absent</b>": ()}
    page = Page(report(tmp_path, answers, language))
    assert page.tags.isdisjoint({"script", "img", "b"})
    assert not [name for name, _ in page.attributes if name.startswith("on")]
    assert [typed for typed in hostile if typed not in page.text] == []


def test_complaints_are_listed_up_to_a_limit(tmp_path: Path) -> None:
    page = Page(report(tmp_path, in_turns(201, ("?", "", ""))))
    assert say("more-complaints", most=200, all=201, file="complaints.csv") in page.text
    none = Page(report(tmp_path / "2", in_turns(3, RIGHT)))
    assert say("page.no-complaints") in none.text
    assert say("page.no-losses") in none.text


def test_marks_of_students_with_different_asks_are_refused(tmp_path: Path) -> None:
    exam, marks = mark_class(tmp_path, in_turns(3, RIGHT))
    lines = (marks / "marks.csv").read_text(encoding="utf-8").splitlines()
    (marks / "marks.csv").write_text("\n".join(lines[:-1]) + "\n", encoding="utf-8")
    with pytest.raises(
        TableError, match='the lines of student "2" do not fit grades.csv or the others - expected'
    ):
        class_report(MarksFolder(marks), open_exam(exam), PLAIN, "en")


@pytest.mark.parametrize(
    ("latex", "html"),
    [
        (r"45^\circ", "<math><mn>45</mn><mi>°</mi></math>"),
        (r"\frac{a}{<b>", r"\frac{a}{&lt;b&gt;"),
        ("a_", "a_"),
        ("}}a", "}}a"),
    ],
)
def test_a_symbol_is_set_as_math_and_what_is_none_stays_text(latex: str, html: str) -> None:
    assert write_symbol_html(latex) == html


def test_prose_that_cannot_be_read_is_left_as_it_is() -> None:
    assert write_prose_html("costs $5 <b>") == "costs $5 &lt;b&gt;"
    assert write_prose_html(r"$\foo$ & more") == r"$\foo$ &amp; more"


def test_prose_is_written_as_on_paper() -> None:
    assert write_prose_html("the **slider's** *pin* &amp; $v$") == (
        "the <strong>slider’s</strong> <em>pin</em> &amp; <math><mi>v</mi></math>"
    )
