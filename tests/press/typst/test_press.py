"""Papers and keys come out as PDF: whole, the same every time, and never with a box for a
character.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest
from pypdf import PdfReader

from kinegrade.errors import TypesetError
from kinegrade.figure.scene import Scene
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.tree import Row
from kinegrade.language.math.typst import equation as typst_equation
from kinegrade.language.math.typst.formula import write_typst_row
from kinegrade.press.binding.part import count_pages
from kinegrade.press.join import join_pages
from kinegrade.press.sheet import AnswerRow, Paper, PaperSize, SolutionSheet
from kinegrade.press.solutions.settings import LOOSE, USUAL
from kinegrade.press.typst.press import KEY_CHUNK, TypstPress
from kinegrade.press.typst.solution import SolutionLayouts
from kinegrade.worked.document import Heading, Prose
from tests.press.papers import CHINESE, CHINESE_QUESTION, ENGLISH, ENGLISH_QUESTION, key_book
from tests.press.solutions import ENGLISH_SOLUTION

NAMES = [
    '#read("/etc/passwd")',
    "$x$ *a* _b_ `c`",
    'O\'Brien, "Zoë"',
    r"\u{41} \\ \n",
    "@ref <label> [x] {y} // z /* u",
    "O'Neil Zoë",
    "Müller, Jürgen",
    "Đặng Thị Hồng",
    "欧阳修远",
    "张喆 堃玥珺翀昇祎骉䶮",
    "Łukasz Żółć, Ştefan Ğül, Ὀδυσσεύς, Юлия",
    "Maximiliane-Charlotte von Hohenzollern-Sigmaringen zu Würzburg",
]


@pytest.fixture(scope="module")
def press() -> TypstPress:
    return TypstPress()


def pages_of(pdf: bytes, folder: Path) -> list[str]:
    """The text of each page, blanks taken out (a PDF does not keep them faithfully)."""
    file = folder / "read.pdf"
    file.write_bytes(pdf)
    return ["".join(page.extract_text().split()) for page in PdfReader(file).pages]


@pytest.mark.parametrize("name", NAMES)
def test_a_name_is_printed_as_it_is(press: TypstPress, name: str, tmp_path: Path) -> None:
    pages = pages_of(press.paper(replace(ENGLISH, name=name)), tmp_path)
    assert "".join(name.split()) in pages[0]


def test_plain_text_never_becomes_code(press: TypstPress, tmp_path: Path) -> None:
    code = '#read("x")$y$'
    hostile = replace(ENGLISH, course=code, title=code, date=code, student=code, code=code)
    (page,) = pages_of(press.paper(hostile), tmp_path)
    assert page.count(code) == 6  # the student's number stands in the footer, too


@pytest.mark.parametrize(
    ("paper", "expected"),
    [
        (
            ENGLISH,
            [
                "Midtermexamination",
                "NameĐặngThịHồng",
                "Question1TotalOutof77Mark",
                "1Slider-crank",
                "7points",
                "counter-clockwisepositive",
                "PaperA-0001",
                "page1of1",
                "m/s",
            ],
        ),
        (
            CHINESE,
            [
                "理论力学",
                "题号1总分满分77得分",
                "1曲柄滑块机构",
                "7分",
                "试卷编号A-0001",
                "第1页，共1页",
                "“图示瞬时”",
                "向右为正",
            ],
        ),
    ],
)
def test_the_page_says_everything(
    press: TypstPress, paper: Paper, expected: list[str], tmp_path: Path
) -> None:
    (page,) = pages_of(press.paper(paper), tmp_path)
    assert [text for text in expected if text not in page] == []


def test_same_input_same_bytes(press: TypstPress) -> None:
    assert press.paper(CHINESE) == press.paper(CHINESE) == TypstPress().paper(CHINESE)
    assert press.key(key_book(1)) == press.key(key_book(1))


def test_letter_paper_is_wider_than_a4(tmp_path: Path) -> None:
    file = tmp_path / "letter.pdf"
    file.write_bytes(TypstPress("letter").paper(ENGLISH))
    assert PdfReader(file).pages[0].mediabox.width == 612


def test_a_question_stays_on_one_page(press: TypstPress, tmp_path: Path) -> None:
    tall = replace(ENGLISH_QUESTION, rows=ENGLISH_QUESTION.rows[:1] * 11)
    questions = tuple(replace(tall, number=number) for number in (1, 2, 3))
    pages = pages_of(press.paper(replace(ENGLISH, questions=questions)), tmp_path)
    assert [page.count("Youranswer") for page in pages] == [1, 1, 1]


def test_a_question_with_another_number_in_the_answer_sheet_says_which(
    press: TypstPress, tmp_path: Path
) -> None:
    question = replace(ENGLISH_QUESTION, identifier="q3")
    (page,) = pages_of(press.paper(replace(ENGLISH, questions=(question,))), tmp_path)
    assert "(no.3intheanswersheet)7points" in page
    (page,) = pages_of(press.paper(ENGLISH), tmp_path)
    assert "intheanswersheet" not in page


def test_every_page_tells_whose_it_is_and_whether_it_is_the_last(
    press: TypstPress, tmp_path: Path
) -> None:
    tall = replace(ENGLISH_QUESTION, rows=ENGLISH_QUESTION.rows[:1] * 11)
    pages = pages_of(
        press.paper(replace(ENGLISH, questions=(tall, replace(tall, number=2)))), tmp_path
    )
    assert [page for page in pages if not ("PaperA-0001" in page and "00123456" in page)] == []
    assert ["pleaseturnover" in page for page in pages] == [True, False]


def test_a_paper_of_many_questions_has_a_box_for_each_mark(
    press: TypstPress, tmp_path: Path
) -> None:
    questions = tuple(replace(ENGLISH_QUESTION, number=number, rows=()) for number in range(1, 21))
    pages = pages_of(press.paper(replace(ENGLISH, questions=questions)), tmp_path)
    numbers = "".join(map(str, range(1, 14)))
    assert f"Question{numbers}Outof{'7' * 13}Mark" in pages[0]
    assert "Question14151617181920TotalOutof7777777140Mark" in pages[0]


def right_margins(pdf: bytes, folder: Path) -> list[float]:
    """Millimetres between the start of the rightmost text of each page and the page's right
    edge.
    """
    file = folder / "read.pdf"
    file.write_bytes(pdf)
    margins = []
    for page in PdfReader(file).pages:
        ends: list[float] = []
        page.extract_text(
            visitor_text=lambda text, cm, tm, font, size, ends=ends: ends.append(cm[4] + tm[4])
        )
        margins.append((float(page.mediabox.width) - max(ends)) / 72 * 25.4)
    return margins


@pytest.mark.parametrize("size", ["a4", "letter"])
@pytest.mark.parametrize("paper", [ENGLISH, CHINESE])
def test_the_longest_texts_stay_between_the_margins(
    paper: Paper, size: PaperSize, tmp_path: Path
) -> None:
    long = AnswerRow(
        r"\angle(v_{A'B'}, v_{B'C'}) + \omega_{BC}/\omega_{AB}",
        "projection of the velocity " * 6,
        "mm/s^2",
        r"positive in the direction of $OM$ turned through $90^\circ$ counter-clockwise " * 2,
        Fraction(25, 3),
    )
    question = replace(
        paper.questions[0],
        title="Slider-crank mechanism with two rods " * 4,
        rows=(long,) * 2,
        figure=Scene(width=75.0, height=50.0, scale=1.0, primitives=()),
    )
    crowded = replace(
        paper, name=NAMES[-1] * 2, title="Kinematics of mechanisms " * 4, questions=(question,) * 3
    )
    assert min(right_margins(TypstPress(size).paper(crowded), tmp_path)) >= 19.9


def test_a_question_longer_than_a_page_goes_on_overleaf(press: TypstPress, tmp_path: Path) -> None:
    long = replace(
        ENGLISH_QUESTION, statement="\n\n".join(f"Sentence {index}." for index in range(120))
    )
    pages = pages_of(press.paper(replace(ENGLISH, questions=(long,))), tmp_path)
    assert len(pages) >= 3
    assert [index for index in range(120) if f"Sentence{index}." not in "".join(pages)] == []


@pytest.mark.parametrize("width", [60.0, 120.0])
def test_a_figure_takes_its_room(press: TypstPress, width: float) -> None:
    figure = Scene(width=width, height=200.0, scale=1.0, primitives=())
    with_figure = replace(CHINESE_QUESTION, figure=figure)
    pdf = press.paper(replace(CHINESE, questions=(CHINESE_QUESTION, with_figure)))
    assert count_pages(pdf) == 2


def test_a_character_without_a_font_in_a_name_is_printed_as_its_code_point(
    press: TypstPress, tmp_path: Path
) -> None:
    pages = pages_of(press.paper(replace(ENGLISH, name="Zoë 😀")), tmp_path)
    assert "Zoë[U+1F600]" in pages[0]
    assert press.unprintable(["Zoë 😀", "한국", "张喆"]) == frozenset("😀한국")


def test_a_character_without_a_font_elsewhere_is_refused(press: TypstPress) -> None:
    question = replace(ENGLISH_QUESTION, statement="The crank 😀 turns.")
    with pytest.raises(TypesetError) as refusal:
        press.paper(replace(ENGLISH, questions=(question,)))
    assert refusal.value.problems == (
        "paper A-0001, q1: no font prints 😀 (U+1F600) - expected Latin, Greek, Cyrillic or Chinese -"
        " write it otherwise",
    )
    with pytest.raises(TypesetError, match=r"^paper A-0001: no font prints 한 \(U\+D55C\)"):
        press.paper(replace(ENGLISH, course="한"))


def test_all_faults_of_a_paper_are_told_at_once(press: TypstPress) -> None:
    question = replace(ENGLISH_QUESTION, title="# a `b`", statement=r"$\foo$", figure=None)
    with pytest.raises(TypesetError) as refusal:
        press.paper(
            replace(
                ENGLISH, rules=("<b>",), questions=(question, replace(question, identifier="q2"))
            )
        )
    wheres = [problem.split(":")[0] for problem in refusal.value.problems]
    assert wheres == ["rules", "q1, title", "q1, statement", "q2, title", "q2, statement"]


def test_math_that_does_not_compile_is_named_by_its_question(
    press: TypstPress, monkeypatch: pytest.MonkeyPatch
) -> None:
    def write(row: Row) -> str:
        return "infinityy" if row == read_math(r"\infty y", "") else write_typst_row(row)

    monkeypatch.setattr(typst_equation, "write_typst_row", write)
    question = replace(ENGLISH_QUESTION, statement=r"$\infty y$")
    with pytest.raises(TypesetError) as refusal:
        press.paper(
            replace(ENGLISH, questions=(ENGLISH_QUESTION, replace(question, identifier="q2")))
        )
    assert refusal.value.problems == (
        "paper A-0001, q2: unknown variable: infinityy - expected math that can be typeset - fix "
        "the formulas",
    )


def test_page_images_are_png(press: TypstPress) -> None:
    images = press.page_images(replace(ENGLISH, name="😀"), ppi=30)
    assert [image[:4] for image in images] == [b"\x89PNG"]


def test_the_key_gives_exact_and_decimal_and_warns_on_each_page(
    press: TypstPress, tmp_path: Path
) -> None:
    book = key_book(KEY_CHUNK + 5)
    named = replace(book, papers=(replace(book.papers[0], name="😀"), *book.papers[1:]))
    pages = pages_of(press.key(named).pdf, tmp_path)
    assert [
        (number, page)
        for number, page in enumerate(pages, 1)
        if not ("INSTRUCTORONLY" in page and f"page{number}" in page)
    ] == []
    assert "[U+1F600]" in pages[0]
    for text in ("1.15470", "−0.957427", "[1.14315,1.16625]", "A-0000", "Given:", "0.25m"):
        assert text in pages[0]


def test_an_empty_key_is_one_page(press: TypstPress) -> None:
    assert count_pages(press.key(key_book(0)).pdf) == 1


def test_a_key_that_cannot_be_printed_says_why(press: TypstPress) -> None:
    with pytest.raises(TypesetError, match=r"^key: no font prints 한"):
        press.key(replace(key_book(1), course="한"))


def test_papers_are_joined_in_order(press: TypstPress, tmp_path: Path) -> None:
    papers = [press.paper(replace(ENGLISH, name=name)) for name in ("Bo", "Al")]
    whole = join_pages(papers)
    pages = pages_of(whole, tmp_path)
    assert ["Bo" in pages[0], "Al" in pages[1], len(pages)] == [True, True, 2]
    assert join_pages(papers) == whole


def steps(count: int) -> SolutionSheet:
    """Worked solutions of one question with so many steps."""
    said = (Heading("Step", 2), Prose("The point $A$ moves to the right along the guide."))
    question = ENGLISH_SOLUTION.questions[0]
    return replace(ENGLISH_SOLUTION, questions=(replace(question, blocks=said * count),))


def test_a_solution_is_set_tighter_where_that_saves_its_last_page(press: TypstPress) -> None:
    pages = [count_pages(press.solution(steps(count))) for count in (44, 48, 80)]
    assert pages == [1, 1, 2]


def test_a_solution_whose_last_page_would_not_be_half_full_is_set_looser(press: TypstPress) -> None:
    spreads = [SolutionLayouts(steps(count)).choose_spread() for count in (30, 48, 56, 60, 70)]
    assert spreads == [USUAL, USUAL, LOOSE, LOOSE, USUAL]
    assert count_pages(press.solution(steps(60))) == 2
    assert SolutionLayouts(replace(steps(56), large=True)).choose_spread() == USUAL


def test_lines_stand_close_together_where_a_few_of_them_would_have_a_page(
    press: TypstPress,
) -> None:
    spilled = [SolutionLayouts(steps(count)).may_spill() for count in (30, 56, 70)]
    assert spilled == [False, True, False]
    assert count_pages(press.solution(steps(56))) == 1


def test_pages_are_foreseen_where_the_last_is_well_begun(press: TypstPress) -> None:
    foreseen = {count: SolutionLayouts(steps(count)).foresee_pages() for count in range(40, 100, 6)}
    usual = {
        count: count_pages(press._compile(SolutionLayouts(steps(count)).write()))
        for count, pages in foreseen.items()
        if pages is not None
    }
    assert len(usual) > 3
    assert usual == {count: pages for count, pages in foreseen.items() if pages is not None}


def test_a_solution_far_from_a_page_fewer_is_typeset_once() -> None:
    assert SolutionLayouts(steps(48)).may_take_fewer(2)
    assert not SolutionLayouts(steps(60)).may_take_fewer(2)
    assert not SolutionLayouts(steps(80)).may_take_fewer(2)
