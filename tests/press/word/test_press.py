"""Papers for Word and for a browser: everything is in them, formulas are formulas, and no text
becomes code.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from html.parser import HTMLParser
from io import BytesIO
from types import SimpleNamespace
from xml.etree import ElementTree
from zipfile import ZipFile

import pytest

from kinegrade.description.said import Description
from kinegrade.errors import TypesetError
from kinegrade.language.math.tokens import COMMANDS
from kinegrade.press.program_run import ProgramRun
from kinegrade.press.sheet import Paper
from kinegrade.press.word import pandoc
from kinegrade.press.word.paper import write_paper_tree
from kinegrade.press.word.press import PandocPress
from tests.press.papers import CHINESE, CHINESE_QUESTION, ENGLISH, ENGLISH_QUESTION
from tests.press.solutions import polygon_scene
from tests.press.tables import find_table_faults, read_html_tables, read_word_tables

W = "{http://schemas.openxmlformats.org/wordprocessingml/2006/main}"
M = "{http://schemas.openxmlformats.org/officeDocument/2006/math}"
HOSTILE = '<script>alert(1)</script> $x$ *a* [b](c) \\input{/etc/passwd} {=html} & "q" ```'
TAKES = {
    "left": r"\left( a \right)",
    "right": "a",
    "begin": r"\begin{cases} a & b \\ c & d \end{cases}",
    "end": "a",
    "frac": r"\frac{a}{b}",
    "dfrac": r"\dfrac{a}{b}",
    "tfrac": r"\tfrac{a}{b}",
}
WITH_ARGUMENT = (
    "mathrm mathbf mathit boldsymbol bm vec bar hat tilde dot ddot overline underbrace "
    "overrightarrow boxed sqrt"
)
NO_PANDOC = "pandoc not found - expected the optional extra - pip install 'kinegrade[word]'"


@pytest.fixture(scope="module")
def press() -> PandocPress:
    return PandocPress()


def parts(docx: bytes) -> Callable[[str], ElementTree.Element]:
    """Reads a part of a Word document by its name."""
    archive = ZipFile(BytesIO(docx))
    return lambda name: ElementTree.fromstring(archive.read(name))


def words(element: ElementTree.Element) -> str:
    """The text of an element, blanks taken out."""
    return "".join("".join(element.itertext()).split())


def with_figure(paper: Paper) -> Paper:
    """The paper with a figure in its first question, and a second question named otherwise than its
    number.
    """
    first = replace(
        paper.questions[0], figure=polygon_scene(), described=Description("Gear & rod", ())
    )
    return replace(
        paper,
        questions=(
            first,
            replace(first, number=2, identifier="q5", points=Fraction(1), figure=None),
        ),
    )


class Page(HTMLParser):
    """What stands in an HTML file: its tags with attributes, and its text."""

    def __init__(self, html: bytes) -> None:
        super().__init__()
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.text = ""
        self.feed(html.decode())

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))

    def handle_data(self, data: str) -> None:
        self.text += data

    def named(self, tag: str) -> list[dict[str, str | None]]:
        return [attributes for name, attributes in self.tags if name == tag]


@pytest.mark.parametrize(
    ("paper", "expected"),
    [
        (
            ENGLISH,
            [
                "TheoreticalMechanics·14November2025",
                "Midtermexamination",
                "NameStudentPaperĐặngThịHồng00123456A-0001",
                "Question12Total",
                "Outof718",
                "1Slider-crank",
                "·7points",
                "(no.5intheanswersheet)·1point",
                "counter-clockwisepositive",
                "rad/s",
                "/4",
                "Source:Example3",
            ],
        ),
        (
            CHINESE,
            [
                "理论力学",
                "期中考试",
                "欧阳修远",
                "曲柄滑块机构",
                "·7分",
                "（登分表第5题）·1分",
                "向右为正",
                "来源：例3",
                "转动。求“图示瞬时”",
            ],
        ),
    ],
)
def test_the_document_says_everything(
    press: PandocPress, paper: Paper, expected: list[str]
) -> None:
    docx = words(parts(press.docx(with_figure(paper)))("word/document.xml"))
    html = "".join(Page(press.html(with_figure(paper))).text.split())
    assert [text for text in expected if text not in docx or text not in html] == []


def test_word_has_equations_tables_headings_pictures_and_a_footer(press: PandocPress) -> None:
    part = parts(press.docx(with_figure(ENGLISH)))
    document = part("word/document.xml")
    styles = [style.get(f"{W}val") for style in document.iter(f"{W}pStyle")]
    assert (styles.count("Title"), styles.count("Heading1"), styles.count("AnswerBox")) == (1, 2, 4)
    assert len(list(document.iter(f"{W}tbl"))) == 4
    assert len(list(document.iter(f"{M}oMath"))) >= 20
    assert len([name for name in document.iter() if name.tag.endswith("}blip")]) == 1
    assert words(part("word/footer1.xml")) == "PaperA-000100123456page1of1"
    fonts = part("word/styles.xml").find(f".//{W}rFonts")
    assert fonts is not None
    assert fonts.get(f"{W}eastAsia") == "SimSun"
    known = {style.get(f"{W}styleId") for style in part("word/styles.xml").iter(f"{W}style")}
    assert set(styles) <= known


@pytest.mark.parametrize("paper", [ENGLISH, CHINESE])
def test_every_cell_of_a_table_has_a_header(press: PandocPress, paper: Paper) -> None:
    written = replace(paper, head=replace(paper.head, seat="", signature=True))
    for tables in (
        read_word_tables(press.docx(written)),
        read_html_tables(press.html(written).decode()),
    ):
        assert len(tables) == 4
        assert list(find_table_faults(tables)) == []


def test_a_figure_has_its_size_and_its_description(press: PandocPress) -> None:
    document = parts(press.docx(with_figure(ENGLISH)))("word/document.xml")
    (extent,) = [element for element in document.iter() if element.tag.endswith("}extent")]
    scene = polygon_scene()
    assert int(extent.get("cx", "0")) / 36000 == pytest.approx(scene.width, rel=0.01)
    assert int(extent.get("cy", "0")) / 36000 == pytest.approx(scene.height, rel=0.01)
    (picture,) = Page(press.html(with_figure(ENGLISH))).named("img")
    assert picture["alt"] == "Gear & rod"
    assert str(picture["src"]).startswith("data:image/svg+xml;base64,")


def test_the_paper_size_is_taken_over() -> None:
    size = parts(PandocPress("letter").docx(ENGLISH))("word/document.xml").find(f".//{W}pgSz")
    assert size is not None
    assert (size.get(f"{W}w"), size.get(f"{W}h")) == ("12240", "15840")
    assert b"size: letter" in PandocPress("letter").html(ENGLISH)


def test_html_stands_alone(press: PandocPress) -> None:
    page = Page(press.html(with_figure(CHINESE)))
    assert page.named("html") == [{"lang": "zh-CN"}]
    assert len(page.named("math")) >= 12
    assert not {name for name, _ in page.tags} & {"script", "link", "iframe", "object"}
    addresses = [
        value
        for _, attributes in page.tags
        for key, value in attributes.items()
        if key in ("src", "href")
    ]
    assert [address for address in addresses if not str(address).startswith("data:")] == []


def test_plain_text_stays_as_it_is(press: PandocPress) -> None:
    fields = ("course", "title", "date", "name", "student", "code")
    paper = replace(ENGLISH, **dict.fromkeys(fields, HOSTILE))
    page, shown = Page(press.html(paper)), "".join(HOSTILE.split())
    assert "script" not in {name for name, _ in page.tags}
    assert "".join(page.text.split()).count(shown) == 10
    part = parts(press.docx(paper))
    assert words(part("word/document.xml")).count(shown) == 6
    assert words(part("word/footer1.xml")).count(shown) == 2


def test_control_characters_become_blanks(press: PandocPress) -> None:
    part = parts(press.docx(replace(ENGLISH, name="a\x00b\x1bc", code="d\x00e")))
    assert "abc00123456de" in words(part("word/document.xml"))
    assert "Paperde" in words(part("word/footer1.xml"))


def test_every_formula_that_a_paper_may_hold_is_a_formula(press: PandocPress) -> None:
    formulas = [
        TAKES.get(
            name,
            rf"\{name}{{a}}" if name in f"{WITH_ARGUMENT} widehat".split() else rf"a \{name} b",
        )
        for name in sorted(COMMANDS)
    ]
    formulas += [r"0{,}5", r"5\,\text{m/s^2}", r"\unit{rad/s}", r"a\;\:\!\ b\%\{\}\|"]
    question = replace(
        ENGLISH_QUESTION, statement="\n".join(f"${formula}$" for formula in formulas)
    )
    paper = replace(ENGLISH, rules=(), questions=(question,))
    document = parts(press.docx(paper))("word/document.xml")
    assert len(list(document.iter(f"{M}oMath"))) == len(formulas) + 5
    assert "m/s²" in words(document)
    assert len(Page(press.html(paper)).named("math")) == len(formulas) + 5


def test_same_input_same_bytes(press: PandocPress) -> None:
    for kind in ("docx", "html"):
        assert press.also(with_figure(CHINESE), kind) == press.also(with_figure(CHINESE), kind)


def test_lists_and_letterings_are_kept(press: PandocPress) -> None:
    statement = "1. **first**\n2. *second*\n\n- a\n  b  \n  c\n\n" + r"$$x = 1$$" + "\n"
    page = Page(
        press.html(replace(ENGLISH, questions=(replace(ENGLISH_QUESTION, statement=statement),)))
    )
    assert [len(page.named(tag)) >= 1 for tag in ("ol", "ul", "em", "br")] == [True] * 4
    assert {"display": "block", "xmlns": "http://www.w3.org/1998/Math/MathML"} in page.named("math")


def test_many_questions_have_marks_in_several_tables(press: PandocPress) -> None:
    questions = tuple(
        replace(CHINESE_QUESTION, number=number, identifier=f"q{number}") for number in range(1, 31)
    )
    page = Page(press.html(replace(CHINESE, questions=questions)))
    assert [table["class"] for table in page.named("table")].count("marks") == 3


def test_all_faults_are_told_at_once_with_their_question() -> None:
    row = replace(ENGLISH_QUESTION.rows[0], symbol=r"\foo", meaning="`a`", sign="<i>")
    question = replace(ENGLISH_QUESTION, title="![a](b)", statement=r"$\bar{$", rows=(row,))
    with pytest.raises(TypesetError) as refusal:
        write_paper_tree(replace(ENGLISH, rules=("<b>",), questions=(question,)), {})
    wheres = [problem.split(":")[0] for problem in refusal.value.problems]
    assert wheres == [
        "rules",
        "q1, title",
        "q1, statement",
        "q1, meaning",
        "q1, sign",
        "q1, symbol",
    ]


def test_formulas_that_pandoc_cannot_read_are_refused(press: PandocPress) -> None:
    question = replace(ENGLISH_QUESTION, statement="$a & b$ and $x & y$")
    with pytest.raises(TypesetError) as refusal:
        press.html(replace(ENGLISH, questions=(question,)))
    assert refusal.value.problems == (
        "html: formula $a &b$: cannot be read - expected whole LaTeX math - fix it",
        "html: formula $x &y$: cannot be read - expected whole LaTeX math - fix it",
    )


def test_another_pandoc_is_told_with_its_own_words(
    press: PandocPress, monkeypatch: pytest.MonkeyPatch
) -> None:
    old = ProgramRun(64, b"", b"Unknown\noption --sandbox")
    monkeypatch.setattr(pandoc, "run_program", lambda *command, **options: old)
    with pytest.raises(TypesetError) as refusal:
        press.html(ENGLISH)
    assert str(refusal.value) == (
        "html: pandoc: Unknown option --sandbox - expected a document that it can write -"
        " try a pandoc of version 3"
    )


def test_another_kind_is_refused() -> None:
    with pytest.raises(TypesetError) as refusal:
        PandocPress().also(ENGLISH, "odt")
    assert (
        str(refusal.value)
        == "odt: not a kind of file that papers are written in - known here: docx, html"
    )


def test_without_pandoc_one_is_told_how_to_get_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pypandoc", None)
    with pytest.raises(TypesetError) as refusal:
        PandocPress().docx(ENGLISH)
    assert str(refusal.value) == f"docx: {NO_PANDOC}"
    gone = SimpleNamespace(get_pandoc_path=lambda: "/nowhere/pandoc")
    monkeypatch.setitem(sys.modules, "pypandoc", gone)
    with pytest.raises(TypesetError) as refusal:
        PandocPress().html(ENGLISH)
    assert str(refusal.value) == f"html: {NO_PANDOC}"


def test_a_pandoc_that_does_not_end_is_given_up(
    press: PandocPress, monkeypatch: pytest.MonkeyPatch
) -> None:
    def never(*command: object, **options: object) -> None:
        raise TimeoutError

    monkeypatch.setattr(pandoc, "run_program", never)
    with pytest.raises(
        TypesetError, match=r"^html: pandoc has not ended after 60 s - expected .* - try again$"
    ):
        press.html(ENGLISH)
