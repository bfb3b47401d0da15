"""QTI 2.1 packages: an item answers as the exam would, for every ask, tolerance, turn and known
mistake.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from xml.etree.ElementTree import Element

import pytest

from kinegrade.errors import ExportError
from kinegrade.exam.quiz.document import Quiz, QuizPaper
from kinegrade.lms.quiz.qti21.package import write
from tests.golden_files import Hold
from tests.lms.quiz import a_quiz
from tests.lms.quiz.packages import bare, files_of, listing, misplaced
from tests.said import all_said

FLOW = "(p |h4 |h5 |table |ol |ul )*"
INLINE = "#(strong |em |sup |img |textEntryInteraction )*"
ITEM_MODELS = {
    "assessmentItem": "(responseDeclaration )*(outcomeDeclaration )*itemBody responseProcessing "
    "(modalFeedback )*",
    "responseDeclaration": "correctResponse ",
    "correctResponse": "value ",
    "value": "#",
    "outcomeDeclaration": "(defaultValue )?",
    "defaultValue": "value ",
    "itemBody": FLOW,
    "modalFeedback": FLOW,
    "p": INLINE,
    "h4": INLINE,
    "h5": INLINE,
    "li": INLINE,
    "th": INLINE,
    "td": INLINE,
    "strong": INLINE,
    "em": INLINE,
    "sup": INLINE,
    "img": "",
    "textEntryInteraction": "",
    "ol": "(li )*",
    "ul": "(li )*",
    "table": "tbody ",
    "tbody": "(tr )+",
    "tr": "(th |td )+",
    "responseProcessing": "(responseCondition |setOutcomeValue )+",
    "responseCondition": "responseIf (responseElseIf )*(responseElse )?",
    "responseIf": "(equal |or )(setOutcomeValue )*",
    "responseElseIf": "(equal |or )(setOutcomeValue )*",
    "or": "(equal )+",
    "equal": "variable baseValue ",
    "variable": "",
    "baseValue": "#",
    "setOutcomeValue": "(baseValue |sum |multiple )",
    "sum": "(variable )+",
    "multiple": "(variable |baseValue )*",
}
ITEM_ATTRIBUTES = {
    "assessmentItem": "identifier! title! adaptive! timeDependent!",
    "responseDeclaration": "identifier! cardinality! baseType!",
    "outcomeDeclaration": "identifier! cardinality! baseType! normalMaximum",
    "modalFeedback": "outcomeIdentifier! identifier! showHide!",
    "img": "src! alt! width height",
    "th": "scope",
    "textEntryInteraction": "responseIdentifier! expectedLength",
    "equal": "toleranceMode! tolerance",
    "variable": "identifier!",
    "baseValue": "baseType!",
    "setOutcomeValue": "identifier!",
}
TEST_MODELS = {
    "assessmentTest": "outcomeDeclaration testPart outcomeProcessing ",
    "outcomeDeclaration": "",
    "testPart": "(assessmentSection )+",
    "assessmentSection": "(selection )?(assessmentItemRef )+",
    "selection": "",
    "assessmentItemRef": "",
    "outcomeProcessing": "setOutcomeValue ",
    "setOutcomeValue": "sum ",
    "sum": "testVariables ",
    "testVariables": "",
}
TEST_ATTRIBUTES = {
    "assessmentTest": "identifier! title!",
    "outcomeDeclaration": "identifier! cardinality! baseType!",
    "testPart": "identifier! navigationMode! submissionMode!",
    "assessmentSection": "identifier! title! visible!",
    "selection": "select!",
    "assessmentItemRef": "identifier! href!",
    "setOutcomeValue": "identifier!",
    "testVariables": "variableIdentifier!",
}
FIRST = "items/exam-P1-q1.xml"
SECOND = "items/exam-P1-q2.xml"


@pytest.fixture(scope="module")
def package(tmp_path_factory: pytest.TempPathFactory) -> Path:
    place = tmp_path_factory.mktemp("qti21") / "quiz.zip"
    write(a_quiz.quiz(), place)
    return place


def item(package: Path, name: str) -> Element:
    """An item of the package."""
    return bare(files_of(package)[name])


def right(test: Element, answer: Fraction | None) -> bool:
    """What the standard says of `equal` and `or`: closed intervals, and no answer equals
    nothing.
    """
    if test.tag == "or":
        return any(right(part, answer) for part in test)
    value = Fraction(test.findtext("baseValue") or "")
    below, above = map(Fraction, test.get("tolerance", "0 0").split())
    assert (test.get("toleranceMode") == "exact") == ("tolerance" not in test.attrib)
    return answer is not None and value - below <= answer <= value + above


def marked(root: Element, answers: Mapping[str, Fraction]) -> tuple[Fraction, set[str]]:
    """The score and the feedback that an item gives, worked out as a player of the standard
    would.
    """
    points: dict[str, Fraction] = {}
    shown: set[str] = set()

    def follow(rules: list[Element]) -> None:
        for rule in rules:
            if rule.tag == "responseCondition":
                for branch in rule:
                    variable = branch.find(".//variable")
                    if variable is not None and right(
                        branch[0], answers.get(variable.get("identifier", ""))
                    ):
                        follow(list(branch)[1:])
                        break
            elif rule.get("identifier") == "FEEDBACK":
                shown.add(rule.findtext(".//baseValue") or "")
            elif rule.get("identifier") != "SCORE":
                points[rule.get("identifier", "")] = Fraction(rule.findtext("baseValue") or "")

    processing = root.find("responseProcessing")
    follow(list(processing) if processing is not None else [])
    return sum(points.values(), Fraction(0)), shown


@pytest.mark.parametrize("quiz", [a_quiz.quiz("en"), a_quiz.pooled("zh")])
def test_every_element_stands_where_the_standard_lets_it(quiz: Quiz, tmp_path: Path) -> None:
    write(quiz, tmp_path / "quiz.zip")
    for name, text in files_of(tmp_path / "quiz.zip").items():
        if name.startswith("items/"):
            assert list(misplaced(bare(text), ITEM_MODELS, ITEM_ATTRIBUTES)) == []
        if name.startswith("tests/"):
            assert list(misplaced(bare(text), TEST_MODELS, TEST_ATTRIBUTES)) == []


def test_identifiers_are_xml_names_and_stand_once(package: Path) -> None:
    for name in (FIRST, SECOND):
        root = item(package, name)
        declared = [node.get("identifier", "") for node in root if "Declaration" in node.tag]
        assert [
            one
            for one in (*declared, root.get("identifier", ""))
            if not re.fullmatch(r"[A-Za-z_][\w.-]*", one)
        ] == []
        assert len(set(declared)) == len(declared)
        boxes = [node.get("responseIdentifier") for node in root.iter("textEntryInteraction")]
        assert boxes == [one for one in declared if one.startswith("RESPONSE_")]


@pytest.mark.parametrize(
    ("name", "place", "ask"),
    [
        (FIRST, 2, a_quiz.ACCELERATION),
        (FIRST, 3, a_quiz.ZERO),
        (FIRST, 4, a_quiz.UNEVEN),
        (SECOND, 1, a_quiz.ANGLE),
        (SECOND, 3, a_quiz.TINY),
    ],
)
def test_the_ends_of_what_is_right_are_right_and_what_is_beyond_is_not(
    package: Path, name: str, place: int, ask: a_quiz.QuizAsk
) -> None:
    root, box, beyond = item(package, name), f"RESPONSE_{place}", (ask.high - ask.low) / 10**12
    assert [marked(root, {box: answer})[0] for answer in (ask.low, ask.value, ask.high)] == [
        ask.row.points
    ] * 3
    assert [marked(root, {box: answer})[0] for answer in (ask.low - beyond, ask.high + beyond)] == [
        0,
        0,
    ]


@pytest.mark.parametrize(
    ("name", "place", "ask"), [(FIRST, 1, a_quiz.SPEED), (SECOND, 2, a_quiz.RATIO)]
)
def test_numbers_without_end_are_right_to_the_last_digit_of_a_double(
    package: Path, name: str, place: int, ask: a_quiz.QuizAsk
) -> None:
    root, box, hair = item(package, name), f"RESPONSE_{place}", abs(ask.value) / 10**15
    assert [marked(root, {box: answer})[0] for answer in (ask.low, ask.high)] == [
        ask.row.points
    ] * 2
    assert [marked(root, {box: answer})[0] for answer in (ask.low - hair, ask.high + hair)] == [
        0,
        0,
    ]


def test_points_add_up_and_an_empty_box_earns_none(package: Path) -> None:
    root = item(package, FIRST)
    asks = a_quiz.papers()[0].questions[0].asks
    answers = {f"RESPONSE_{place}": ask.value for place, ask in enumerate(asks, start=1)}
    assert marked(root, answers) == (Fraction("8.5"), {"SOLUTION"})
    assert marked(root, {}) == (0, {"SOLUTION"})
    limits = {
        node.get("identifier"): node.get("normalMaximum")
        for node in root.iter("outcomeDeclaration")
    }
    assert limits["SCORE"] == limits["MAXSCORE"] == "8.5"


def test_a_known_mistake_earns_its_share_and_its_sentence_is_shown(package: Path) -> None:
    root = item(package, FIRST)
    assert marked(root, {"RESPONSE_2": Fraction("-6.9")}) == (1, {"MISTAKE_2_1", "SOLUTION"})
    assert marked(root, {"RESPONSE_2": Fraction("12.345")}) == (0, {"MISTAKE_2_2", "SOLUTION"})
    shown = {
        node.get("identifier"): "".join(node.itertext()).strip()
        for node in root.iter("modalFeedback")
    }
    assert shown["MISTAKE_2_1"] == "Coriolis term < left out & more ]]>"


def test_mistakes_that_lead_to_the_same_number_are_told_together(tmp_path: Path) -> None:
    twin = replace(
        a_quiz.CORIOLIS, identifier="twin", credit=Fraction(1, 4), sentence="another way there"
    )
    ask = replace(a_quiz.ACCELERATION, mistakes=(twin, a_quiz.CORIOLIS))
    paper = QuizPaper("P", "1", "Bo", (a_quiz.question("P", "q1", (ask,)),))
    write(Quiz("en", "", "Test", [paper]), tmp_path / "quiz.zip")
    root = item(tmp_path / "quiz.zip", "items/exam-P-q1.xml")
    assert marked(root, {"RESPONSE_1": Fraction(-7)}) == (1, {"MISTAKE_1_1", "MISTAKE_1_2"})
    assert [told.text for told in root.iterfind("modalFeedback/p")] == [
        "another way there",
        a_quiz.CORIOLIS.sentence,
    ]


def test_a_number_that_two_mistakes_lead_to_earns_the_better_share(tmp_path: Path) -> None:
    near = replace(
        a_quiz.CORIOLIS,
        identifier="near",
        credit=Fraction(1, 4),
        value=Fraction("-6.9"),
        low=Fraction(-7),
        high=Fraction("-6.8"),
    )
    ask = replace(a_quiz.ACCELERATION, mistakes=(near, a_quiz.CORIOLIS))
    paper = QuizPaper("P", "1", "Bo", (a_quiz.question("P", "q1", (ask,)),))
    write(Quiz("en", "", "Test", [paper]), tmp_path / "quiz.zip")
    root = item(tmp_path / "quiz.zip", "items/exam-P-q1.xml")
    told = {
        text: marked(root, {"RESPONSE_1": Fraction(text)})
        for text in ("-6.81", "-6.9", "-7", "-7.1")
    }
    assert told == {
        "-6.81": (Fraction(1, 2), {"MISTAKE_1_1"}),
        "-6.9": (1, {"MISTAKE_1_1", "MISTAKE_1_2"}),
        "-7": (1, {"MISTAKE_1_1", "MISTAKE_1_2"}),
        "-7.1": (1, {"MISTAKE_1_2"}),
    }


def test_an_angle_may_have_whole_turns_more_or_less(package: Path) -> None:
    root = item(package, SECOND)
    found = {
        answer: marked(root, {"RESPONSE_1": Fraction(answer)})[0]
        for answer in (30, -330, 210, 390, 750)
    }
    assert found == {30: 2, -330: 2, 210: 0, 390: 2, 750: 0}
    assert "within two turns of zero" in "".join(root.itertext())


def test_texts_are_text_and_the_figure_is_beside_the_items(package: Path) -> None:
    root = item(package, FIRST)
    assert "<script>alert(1)</script>" in "".join(root.itertext())
    picture = root.find(".//img")
    assert picture is not None
    assert picture.get("src", "").replace("../", "") in files_of(package)
    assert item(package, SECOND).find(".//img") is None


def test_the_manifest_names_every_file_and_nothing_else(package: Path) -> None:
    files = files_of(package)
    root = bare(files["imsmanifest.xml"])
    assert sorted(node.get("href", "") for node in root.iter("file")) == sorted(
        set(files) - {"imsmanifest.xml"}
    )
    kinds = {node.get("identifier"): node.get("type") for node in root.iter("resource")}
    uses = [node.get("identifierref") for node in root.iter("dependency")]
    assert {kinds[use] for use in uses} == {"imsqti_item_xmlv2p1"}
    assert list(kinds.values()).count("imsqti_test_xmlv2p1") == 2


def test_variants_are_drawn_one_of_each_question(tmp_path: Path) -> None:
    write(a_quiz.pooled(), tmp_path / "pool.zip")
    (test,) = (
        bare(text)
        for name, text in files_of(tmp_path / "pool.zip").items()
        if name.startswith("tests/")
    )
    drawn = [
        (len(section.findall("assessmentItemRef")), section.find("selection") is not None)
        for section in test.iter("assessmentSection")
    ]
    assert drawn == [(2, True), (1, False)]


def test_texts_that_cannot_be_shown_are_refused_and_nothing_is_written(tmp_path: Path) -> None:
    broken = a_quiz.question("P", "q1", (a_quiz.SPEED,), statement="# heading")
    with pytest.raises(ExportError, match="q1, statement: a heading cannot be printed"):
        write(Quiz("en", "", "Test", [QuizPaper("P", "1", "Bo", (broken,))]), tmp_path / "quiz.zip")
    assert list(tmp_path.iterdir()) == []


def test_what_a_person_has_to_know_is_said(tmp_path: Path) -> None:
    assert [
        line.split(" - ")[0] for line in all_said(write(a_quiz.quiz(), tmp_path / "quiz.zip"))
    ] == [
        r"qti21: formulas are LaTeX between \( and \)",
        "qti21: Canvas turns these questions into texts to be matched and drops the tolerance",
        "qti21: every paper is a test of its own, with its code in the titles",
    ]


@pytest.mark.parametrize("form", ["quiz", "pooled"])
def test_the_package(form: str, hold: Hold, tmp_path: Path) -> None:
    write(getattr(a_quiz, form)("zh" if form == "pooled" else "en"), tmp_path / "quiz.zip")
    hold(f"lms/quiz-qti21-{form}.txt", listing(tmp_path / "quiz.zip"))
