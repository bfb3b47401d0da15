"""Quizzes for Canvas: what is read back is what the exam says, and nothing else gets in."""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from tempfile import TemporaryDirectory
from xml.etree.ElementTree import Element, fromstring

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.errors import ExportError
from kinegrade.exam.quiz.document import Quiz, QuizAsk, QuizPaper
from kinegrade.lms.quiz.qti12.package import write
from tests.golden_files import Hold
from tests.lms.quiz import a_quiz
from tests.lms.quiz.packages import bare, files_of, listing, misplaced
from tests.said import all_said

# the part of the standard's DTD that is used, with Canvas's own <points_per_item> where the DTD
# allows anything
MODELS = {
    "questestinterop": "assessment ",
    "assessment": "qtimetadata section ",
    "qtimetadata": "(qtimetadatafield )+",
    "qtimetadatafield": "fieldlabel fieldentry ",
    "fieldlabel": "#",
    "fieldentry": "#",
    "section": "(selection_ordering )?(item |section )*",
    "selection_ordering": "selection ",
    "selection": "selection_number selection_extension ",
    "selection_number": "#",
    "selection_extension": "points_per_item ",
    "points_per_item": "#",
    "item": "itemmetadata presentation resprocessing (itemfeedback )*",
    "itemmetadata": "qtimetadata ",
    "presentation": "material response_str ",
    "material": "mattext ",
    "mattext": "#",
    "response_str": "render_fib ",
    "render_fib": "response_label ",
    "response_label": "",
    "resprocessing": "outcomes (respcondition )+",
    "outcomes": "decvar ",
    "decvar": "",
    "respcondition": "conditionvar (setvar )?(displayfeedback )?",
    "conditionvar": "or |vargte varlte |other ",
    "or": "varequal and ",
    "and": "vargte varlte ",
    "other": "",
    "varequal": "#",
    "vargte": "#",
    "varlte": "#",
    "setvar": "#",
    "displayfeedback": "",
    "itemfeedback": "flow_mat ",
    "flow_mat": "material ",
}
ATTRIBUTES = {
    "assessment": "ident! title!",
    "section": "ident! title",
    "item": "ident! title!",
    "mattext": "texttype!",
    "response_str": "ident! rcardinality!",
    "render_fib": "fibtype!",
    "response_label": "ident!",
    "decvar": "maxvalue minvalue varname! vartype!",
    "respcondition": "continue!",
    "setvar": "action! varname!",
    "varequal": "respident!",
    "vargte": "respident!",
    "varlte": "respident!",
    "itemfeedback": "ident!",
    "displayfeedback": "feedbacktype! linkrefid!",
}
EXACT = ("v_D", "v_E", "a_C", "phi")  # whose numbers a double holds with all their digits


def quizzes(package: Path) -> list[Element]:
    """The assessments of a package."""
    return [bare(text) for text in files_of(package).values() if "<questestinterop" in text]


def items(package: Path) -> dict[str, Element]:
    """All items by their identifiers."""
    return {item.get("ident", ""): item for quiz in quizzes(package) for item in quiz.iter("item")}


def intervals(item: Element) -> list[tuple[Fraction | None, Fraction, Fraction]]:
    """What an item takes as right, read as Canvas reads it: the exact answer if there is one, and
    the bounds.
    """
    found = []
    for condition in item.iter("respcondition"):
        if condition.find("setvar") is not None:
            value = condition.find(".//varequal")
            low, high = (
                Fraction(node.text or "")
                for tag in ("vargte", "varlte")
                for node in condition.iter(tag)
            )
            found.append((None if value is None else Fraction(value.text or ""), low, high))
    return found


def one_ask(ask: QuizAsk) -> Quiz:
    """A quiz of nothing but this ask."""
    return Quiz(
        "en", "", "Test", [QuizPaper("P", "1", "Bo", (a_quiz.question("P", "q1", (ask,)),))]
    )


@pytest.fixture
def package(tmp_path: Path) -> Path:
    write(a_quiz.quiz(), tmp_path / "quiz.zip")
    return tmp_path / "quiz.zip"


@pytest.mark.parametrize(
    "quiz", [a_quiz.quiz("en"), a_quiz.quiz("zh"), a_quiz.pooled("en"), a_quiz.pooled("zh")]
)
def test_every_element_stands_where_the_standard_lets_it(quiz: Quiz, tmp_path: Path) -> None:
    write(quiz, tmp_path / "quiz.zip")
    assert [
        fault
        for root in quizzes(tmp_path / "quiz.zip")
        for fault in misplaced(root, MODELS, ATTRIBUTES)
    ] == []


def test_every_number_that_a_double_holds_is_the_exams(package: Path) -> None:
    asks, found = a_quiz.all_asks(), items(package)
    for name in EXACT:
        ask = asks[name]
        value, low, high = intervals(found[f"exam-P1-{'q2' if name == 'phi' else 'q1'}-{name}"])[0]
        assert high == ask.high
        assert abs(low - (ask.low if value is None else lowered(ask))) < abs(high) / 10**16
        assert value == (None if name == "v_E" else ask.value)


@pytest.mark.parametrize(("place", "name"), [("q1", "v_B"), ("q2", "k")])
def test_numbers_without_end_lose_nothing_that_is_right_and_less_than_a_double_can_tell(
    package: Path, place: str, name: str
) -> None:
    ask = a_quiz.all_asks()[name]
    ((value, low, high),) = intervals(items(package)[f"exam-P1-{place}-{name}"])
    assert value is not None
    for read, meant in ((value, ask.value), (low, lowered(ask)), (high, ask.high)):
        assert abs(read - meant) < abs(meant) / 10**16
    assert low <= ask.low <= ask.high <= high


def test_margins_are_even_wherever_an_exact_answer_stands(package: Path) -> None:
    """Classic takes the upper margin, New Quizzes the lower one, which is a hair wider."""
    for item in items(package).values():
        for value, low, high in intervals(item):
            size = max(abs(low), abs(high))
            assert value is None or 0 < (value - low) - (high - value) < size / 10**11


def lowered(ask: QuizAsk) -> Fraction:
    """The lower bound that stands beside an exact answer: a hair lower than the exam's."""
    return ask.low - max(abs(ask.low), abs(ask.high)) / 10**12


def right_in_new_quizzes(read: tuple[Fraction | None, Fraction, Fraction], typed: Fraction) -> bool:
    """As New Quizzes mark: with a margin that is the answer less the lower bound, all in
    doubles.
    """
    value, low, high = read
    if value is None:
        return float(low) <= float(typed) <= float(high)
    return abs(float(typed) - float(value)) <= float(value) - float(low)


def right_in_classic_quizzes(
    read: tuple[Fraction | None, Fraction, Fraction], typed: Fraction
) -> bool:
    """As Classic Quizzes mark: four decimals of what was typed, and the margin above, in exact
    decimals.
    """
    value, low, high = read
    kept = round(typed, 4)
    return low <= kept <= high if value is None else abs(kept - value) <= high - value


@given(st.integers(100, 10**7), st.integers(1, 5))
def test_no_edge_of_a_tolerance_is_lost_in_either_of_canvas_quizzes(
    digits: int, percent: int
) -> None:
    value = Fraction(digits, 100)
    ask = a_quiz.relative("v_B", value, Fraction(percent, 100))
    with TemporaryDirectory() as folder:
        write(one_ask(ask), Path(folder) / "quiz.zip")
        (read,) = intervals(items(Path(folder) / "quiz.zip")["exam-P-q1-v_B"])
    for right in (right_in_new_quizzes, right_in_classic_quizzes):
        assert right(read, ask.low)
        assert right(read, ask.high)
        assert not right(read, ask.low - Fraction(1, 10**4))
        assert not right(read, ask.high + Fraction(1, 10**4))


def test_own_papers_are_hidden_until_they_are_assigned_and_pools_are_not(
    package: Path, tmp_path: Path
) -> None:
    write(a_quiz.pooled(), tmp_path / "pool.zip")
    for place, hidden in ((package, "true"), (tmp_path / "pool.zip", "false")):
        metas = [text for name, text in files_of(place).items() if name.endswith("_meta.xml")]
        assert metas
        assert {bare(text).findtext("only_visible_to_overrides") for text in metas} == {hidden}


def test_no_bound_reads_as_a_precision_answer(package: Path) -> None:
    assert "<vargt " not in listing(package)


def test_an_angle_is_right_with_whole_turns_added(package: Path) -> None:
    found = intervals(items(package)["exam-P1-q2-phi"])
    assert [(value, round(high - low, 6)) for value, low, high in found] == [
        (30, 1),
        (-330, 1),
        (390, 1),
        (-690, 1),
    ]


def test_an_answer_too_small_for_four_decimals_is_asked_for_in_a_finer_unit(package: Path) -> None:
    item = items(package)["exam-P1-q2-v_F"]
    ask = replace(a_quiz.TINY, low=Fraction("4.2075"), high=Fraction("4.2925"))
    assert intervals(item) == [(Fraction("4.25"), lowered(ask), ask.high)]
    text = item.findtext(".//mattext") or ""
    assert "? mm/s (2 points)" in text
    assert "Mind the unit: mm/s here, not m/s." in text


@pytest.mark.parametrize(
    ("unit", "value", "finer", "factor"),
    [
        ("m", "0.0021", "mm", 1000),
        ("cm", "0.0011", "mm", 10),
        ("km", "0.0000020", "mm", 10**6),
        ("m/s^2", "0.0008", "mm/s^2", 1000),
    ],
)
def test_units_change_by_whole_powers_of_ten(
    unit: str, value: str, finer: str, factor: int, tmp_path: Path
) -> None:
    ask = a_quiz.relative("x", Fraction(value), unit=unit)
    write(one_ask(ask), tmp_path / "quiz.zip")
    ((found, low, high),) = intervals(items(tmp_path / "quiz.zip")["exam-P-q1-x"])
    assert (found, low, high) == (ask.value * factor, lowered(ask) * factor, ask.high * factor)
    shown, meant = (one.replace("^2", "&lt;sup&gt;2&lt;/sup&gt;") for one in (finer, unit))
    text = listing(tmp_path / "quiz.zip")
    assert f"? {shown} (2 points)" in text
    assert f"Mind the unit: {shown} here, not {meant}." in text


def test_an_answer_whose_unit_has_no_finer_one_is_refused_with_all_others(tmp_path: Path) -> None:
    area = a_quiz.alter(a_quiz.LOST, identifier="area", symbol="A", unit="m^2")
    questions = tuple(
        a_quiz.question("P", f"q{number}", (ask,))
        for number, ask in enumerate((a_quiz.LOST, area), 1)
    )
    quiz = Quiz("en", "", "Test", [QuizPaper("P", "1", "Bo", questions)])
    with pytest.raises(ExportError) as refusal:
        write(quiz, tmp_path / "quiz.zip")
    first, second = refusal.value.problems
    assert first == (
        "exam-P-q1: ω_AB = 0.00004 rad/s, right from 0.0000392 to 0.0000408, is no longer right "
        "with the "
        "four decimals that Canvas keeps - expected an answer that is - set the exam with lms = "
        '"canvas" in the bank, which refuses such draws, or allow a wider tolerance'
    )
    assert second.startswith("exam-P-q2: A = 0.00004 m^2, ")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("low", "high", "taken"),
    [
        ("0.2235", "0.2245", True),
        ("0.22435", "0.22455", True),
        ("0.2244", "0.2245", True),
        ("0.22441", "0.22456", True),
        ("0.22441", "0.22449", False),
    ],
)
def test_an_answer_is_taken_where_its_four_decimals_are_right(
    low: str, high: str, taken: bool, tmp_path: Path
) -> None:
    ask = replace(a_quiz.LOST, value=Fraction("0.224488"), low=Fraction(low), high=Fraction(high))
    if taken:
        write(one_ask(ask), tmp_path / "quiz.zip")
        assert f">{high}</varlte>" in listing(tmp_path / "quiz.zip")
    else:
        with pytest.raises(ExportError, match="is no longer right with the four decimals"):
            write(one_ask(ask), tmp_path / "quiz.zip")


def test_answers_that_may_be_lost_at_an_edge_are_named(tmp_path: Path) -> None:
    ask = a_quiz.relative("omega", Fraction("0.0055"), unit="rad/s", share=Fraction(1, 100))
    assert all_said(write(one_ask(ask), tmp_path / "quiz.zip"))[0] == (
        "qti12: Canvas keeps four decimals, too few for q1.omega on some papers: an answer near "
        "the limit of the tolerance may be marked the other way there - mark with kinegrade "
        "grade, from the students' responses"
    )


def test_hundreds_of_refusals_are_told_by_the_first_and_a_count(tmp_path: Path) -> None:
    papers = [
        QuizPaper(str(i), str(i), "", (a_quiz.question(str(i), "q1", (a_quiz.LOST,)),))
        for i in range(100)
    ]
    with pytest.raises(ExportError) as refusal:
        write(Quiz("en", "", "Test", papers), tmp_path / "quiz.zip")
    assert len(refusal.value.problems) == 41
    assert refusal.value.problems[-1] == "quiz: and 60 more"


def test_whole_numbers_may_be_asked_for_exactly(tmp_path: Path) -> None:
    write(
        one_ask(a_quiz.ask("n", Fraction(3), Fraction(3), Fraction(3), unit="1")),
        tmp_path / "quiz.zip",
    )
    assert intervals(items(tmp_path / "quiz.zip")["exam-P-q1-n"]) == [(3, 3, 3)]


def test_texts_are_text_and_figures_are_files_of_the_package(package: Path) -> None:
    files = files_of(package)
    item = items(package)["exam-P1-q1-v_B"]
    shown = fromstring(f"<div>{item.findtext('.//mattext')}</div>")
    assert "<script>alert(1)</script>" in "".join(shown.itertext())
    assert {node.tag for node in shown.iter()} <= {
        "div",
        "p",
        "strong",
        "ol",
        "li",
        "img",
        "sup",
        "details",
        "summary",
    }
    picture = shown.find(".//img")
    assert picture is not None
    assert picture.get("src", "").removeprefix("$IMS-CC-FILEBASE$/") in files
    assert picture.get("alt") == "q1 in words & numbers"
    assert (
        bare(files["exam-P1-q1-v_B-paper/assessment_meta.xml"]).findtext("points_possible")
        == "13.5"
    )


def test_the_manifest_names_every_file_and_nothing_else(package: Path) -> None:
    files = files_of(package)
    named = re.findall(r'<file href="([^"]*)"', files["imsmanifest.xml"])
    assert sorted(named) == sorted(set(files) - {"imsmanifest.xml"})
    root = bare(files["imsmanifest.xml"])
    known = {node.get("identifier") for node in root.iter("resource")}
    assert len(known) == len(list(root.iter("resource")))
    assert {node.get("identifierref") for node in root.iter("dependency")} <= known


def test_the_solution_comes_once_with_the_last_ask_and_with_every_pooled_one(
    package: Path, tmp_path: Path
) -> None:
    solved = [
        name for name, item in items(package).items() if item.find("itemfeedback") is not None
    ]
    assert solved == ["exam-P1-q1-v_E"]
    write(a_quiz.pooled(), tmp_path / "pool.zip")
    solved = [
        name
        for name, item in items(tmp_path / "pool.zip").items()
        if item.find("itemfeedback") is not None
    ]
    assert solved == [f"exam-P1-q1-{name}" for name in ("v_B", "a_C", "v_D", "v_E")]


def test_pooled_questions_are_drawn_one_variant_for_every_ask(tmp_path: Path) -> None:
    complaints = all_said(write(a_quiz.pooled(), tmp_path / "pool.zip"))
    (quiz,) = quizzes(tmp_path / "pool.zip")
    groups = {group.get("title", ""): group for group in quiz.findall("assessment/section/section")}
    assert [len(group.findall("item")) for group in groups.values()] == [2, 2, 2, 2, 1, 1, 1]
    for group in groups.values():
        assert group.findtext("selection_ordering/selection/selection_number") == "1"
        worth = {
            entry.text
            for item in group.findall("item")
            for entry in item.iter("fieldentry")
            if re.fullmatch(r"[0-9.]+", entry.text or "")
        }
        assert worth == {group.findtext(".//points_per_item")}
    assert any(
        line.startswith("qti12: Canvas draws every question by itself") for line in complaints
    ), complaints


def test_variants_of_different_worth_are_refused(tmp_path: Path) -> None:
    dearer = a_quiz.alter(a_quiz.SPEED, points=Fraction(3))
    papers = [
        QuizPaper(code, "", "", (a_quiz.question(code, "q1", (ask,)),))
        for code, ask in (("P1", a_quiz.SPEED), ("P2", dearer))
    ]
    with pytest.raises(ExportError) as refusal:
        write(Quiz("en", "", "Test", papers), tmp_path / "pool.zip")
    assert refusal.value.problems == (
        "exam-P2-q1-v_B: is worth 3 points, and the first variant 5/2 - expected the same for "
        "all variants of an ask - fix the points in the bank",
    )


def test_what_was_left_out_and_what_is_to_be_done_is_said(tmp_path: Path) -> None:
    assert all_said(write(a_quiz.quiz(), tmp_path / "quiz.zip")) == [
        "qti12: Canvas gives a number all points or none - credit and comments for known "
        "mistakes were left out - give them with kinegrade grade, from the students' responses",
        "qti12: Canvas keeps four decimals - q2.v_F is asked for in mm/s instead of m/s, in the "
        "whole class, because that is too coarse for some answers",
        "qti12: every paper is a quiz of its own, which no student sees until it is assigned - "
        "assign each quiz to its students, and to no others, before you publish it",
    ]
    assert "CORIOLIS" not in listing(tmp_path / "quiz.zip").upper()


def test_texts_that_cannot_be_shown_are_refused_once_for_all_asks(tmp_path: Path) -> None:
    broken = a_quiz.question(
        "P", "q1", (a_quiz.SPEED, a_quiz.ZERO), statement="see [here](x) and $\\foo$"
    )
    with pytest.raises(ExportError) as refusal:
        write(Quiz("en", "", "Test", [QuizPaper("P", "1", "Bo", (broken,))]), tmp_path / "quiz.zip")
    assert [problem.split(" - ")[0] for problem in refusal.value.problems] == [
        "q1, statement: a link cannot be printed",
        "q1, statement: formula $\\foo$: unknown command \\foo",
    ]


@pytest.mark.parametrize("form", ["quiz", "pooled"])
def test_the_package_for_canvas(form: str, hold: Hold, tmp_path: Path) -> None:
    write(getattr(a_quiz, form)("zh" if form == "pooled" else "en"), tmp_path / "quiz.zip")
    hold(f"lms/quiz-qti12-{form}.txt", listing(tmp_path / "quiz.zip"))
