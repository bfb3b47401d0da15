"""The press of LaTeX: whole files for each student, the same every time, and faults in the
instructor's words.
"""

from __future__ import annotations

import subprocess
from collections.abc import Mapping
from dataclasses import replace
from io import BytesIO
from pathlib import Path

import pikepdf
import pytest
from pypdf import PdfReader

from kinegrade.errors import TypesetError
from kinegrade.exam.folder.exam_secret import FromWords
from kinegrade.exam.printing.pages import lay_out_paper
from kinegrade.exam.printing.sample import make_sample_bank
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.roster.students import Student
from kinegrade.exam.setting.dealing import deal_exam
from kinegrade.figure.scene import Scene
from kinegrade.language import Language
from kinegrade.press.latex.press import LatexPress
from kinegrade.press.latex.xetex import make_pdf, run, write_style
from kinegrade.press.protocol import Press
from kinegrade.press.sheet import Paper
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.worked.document import Heading, Picture, Pictures, Prose
from tests.press.papers import CHINESE, CHINESE_QUESTION, ENGLISH, ENGLISH_QUESTION, key_book
from tests.press.solutions import (
    CHINESE_SOLUTION,
    ENGLISH_SOLUTION,
    long_equation,
    polygon_scene,
)
from tests.worked.telling import read_display

pytestmark = [pytest.mark.needs_tex, pytest.mark.xdist_group("latex")]

LANGUAGES: tuple[Language, ...] = ("en", "zh") * 4
EIGHTHS = [find_template_names()[first::8] for first in range(8)]
NAMES = [
    r"\input{/etc/passwd}",
    r"$%&#_{}~^\ ^^5c",
    r"\immediate\write18{touch x}",
    "O'Brien, \"Zoë\" <a> --- `b' [c] |d|",
    "Łukasz Żółć, Ştefan Ğül",
]
FAR_NAMES = [
    "Đặng Thị Hồng",
    "欧阳修远",
    "张喆 堃玥珺翀昇祎骉䶮",
    "Юлия",
    "Αγαπη",
    "\u202eabc\u200b",
]


def pages_of(pdf: bytes) -> list[str]:
    """The text of each page, blanks taken out (a PDF does not keep them faithfully)."""
    return ["".join((page.extract_text() or "").split()) for page in PdfReader(BytesIO(pdf)).pages]


def printed(papers: Mapping[str, Paper], press: LatexPress | None = None) -> dict[str, list[str]]:
    printouts = (press or LatexPress()).papers(papers)
    return {name: pages_of(printouts[name].pdf) for name in papers}


def seen(text: str) -> str:
    return "".join(text.replace("\u202e", "").replace("\u200b", "").split())


@pytest.mark.sampled(2, by="names", first=1)
@pytest.mark.parametrize("names", [NAMES, FAR_NAMES], ids=["Latin", "other"])
def test_names_are_printed_as_they_are_and_each_file_holds_one_student(names: list[str]) -> None:
    papers = {
        f"s{index}": replace(ENGLISH, name=name, code=f"CODE-{index}")
        for index, name in enumerate(names)
    }
    for index, ((page,), name) in enumerate(zip(printed(papers).values(), names, strict=True)):
        assert seen(name) in page
        assert [other for other in range(len(names)) if f"CODE-{other}" in page] == [index]


def test_plain_text_never_becomes_a_command() -> None:
    code = r"\jobname#1%\x00" + "\0\n\\par"
    hostile = replace(
        ENGLISH, course=code, title=code, date=code, student=code, name=code, code=code
    )
    ((page,),) = printed({"s": hostile}).values()
    # Student, course and code also run on the page
    assert page.count(seen(code.replace("\0", ""))) == 7


@pytest.mark.left(beside="test_a_character_without_a_font_in_a_name_is_printed_as_its_code_point")
def test_an_id_that_no_font_prints_is_printed_as_code_points() -> None:
    ((page,),) = printed({"s": replace(ENGLISH, student="0😀7")}).values()
    assert "0[U+1F600]7" in page


@pytest.mark.sampled(2, by="paper", first=1)
@pytest.mark.parametrize(
    ("paper", "expected"),
    [
        (
            replace(ENGLISH, name="Zoë"),
            ["Midtermexamination", "7points", "A-0001", "page1of1", "clockwise"],
        ),
        (
            CHINESE,
            [
                "理论力学",
                "欧阳修远",
                "7分",
                "试卷编号A-0001",
                "第1页，共1页",
                "“图示瞬时”",
                "向右为正",
            ],
        ),
    ],
)
def test_the_page_says_everything_in_the_same_bytes_every_time(
    paper: Paper, expected: list[str]
) -> None:
    first = LatexPress().papers({"s": paper})
    (page,) = pages_of(first["s"].pdf)
    assert [text for text in expected if text not in page] == []
    assert LatexPress().papers({"s": paper}) == first


@pytest.mark.sampled(10, by="names")  # an eighth in each language
@pytest.mark.parametrize(("language", "names"), [*zip(LANGUAGES, EIGHTHS, strict=True)])
def test_a_sample_of_every_template_can_be_printed(
    language: Language, names: tuple[str, ...]
) -> None:
    papers = {name: sample(name, language) for name in names}
    printouts = LatexPress().papers(papers)
    assert list(printouts) == list(papers)
    for name in names[::5]:
        text = "".join(pages_of(printouts[name].pdf))
        assert [other for other in papers if papers[other].code in text] == [name]


def sample(name: str, language: Language) -> Paper:
    roster = Roster((Student(name, "Sample", "", name),), ())
    setting = deal_exam(make_sample_bank(load_template(name)), roster, FromWords("latex"))
    return lay_out_paper(setting.bank, next(setting.papers()), language)


def test_letter_paper_is_wider_than_a4() -> None:
    printouts = LatexPress("letter").papers({"s": replace(ENGLISH, name="Zoë")})
    [page] = PdfReader(BytesIO(printouts["s"].pdf)).pages
    assert round(float(page.mediabox.width)) == 612


def test_a_question_stays_on_one_page_unless_it_is_longer() -> None:
    tall = replace(ENGLISH_QUESTION, rows=ENGLISH_QUESTION.rows[:1] * 11)
    long = replace(
        ENGLISH_QUESTION, statement="\n\n".join(f"Sentence {index}." for index in range(120))
    )
    questions = tuple(replace(tall, number=number) for number in (1, 2, 3))
    paper = replace(ENGLISH, name="Zoë")
    papers = {
        "tall": replace(paper, questions=questions),
        "long": replace(paper, questions=(long,)),
    }
    pages = printed(papers)
    assert [page.count("Youranswer") for page in pages["tall"]] == [1, 1, 1]
    assert ["page1of3" in pages["tall"][0], "page3of3" in pages["tall"][2]] == [True, True]
    assert [
        index for index in range(120) if f"Sentence{index}." not in "".join(pages["long"])
    ] == []


def test_a_figure_takes_its_room_beside_and_below_the_text() -> None:
    figures = {
        name: Scene(width, 200.0, 1.0, ()) for name, width in (("beside", 60.0), ("below", 120.0))
    }
    papers = {
        name: replace(
            ENGLISH,
            name="Z",
            questions=(ENGLISH_QUESTION, replace(ENGLISH_QUESTION, figure=figure)),
        )
        for name, figure in figures.items()
    }
    assert [len(pages) for pages in printed(papers).values()] == [2, 2]


def test_a_character_without_a_font_in_a_name_is_printed_as_its_code_point() -> None:
    press = LatexPress()
    assert press.unprintable(["Zoë 😀", "한국", "张喆"]) == frozenset("😀한국")
    ((page,),) = printed({"s": replace(ENGLISH, name="Zoë 😀")}, press).values()
    assert "Zoë[U+1F600]" in page


def test_a_character_without_a_font_elsewhere_is_refused() -> None:
    question = replace(ENGLISH_QUESTION, statement="The crank 😀 turns.", template="crank")
    with pytest.raises(TypesetError) as refusal:
        LatexPress().papers({"s": replace(ENGLISH, questions=(question,))})
    assert refusal.value.problems == (
        "paper A-0001, q1 (crank): no font prints 😀 (U+1F600) - expected Latin, Greek, Cyrillic "
        "or Chinese - write it otherwise",
    )


def test_what_tex_refuses_is_named_by_paper_question_template_and_line() -> None:
    question = replace(
        ENGLISH_QUESTION, identifier="q2", statement=r"As $a & b$.", template="slider-crank"
    )
    papers = {
        "s": replace(ENGLISH, name="Zoë"),
        "t": replace(ENGLISH, code="K7Q2-9FHM", questions=(question,)),
    }
    with pytest.raises(TypesetError) as refusal:
        LatexPress().papers(papers)
    (problem,) = refusal.value.problems
    assert problem.startswith(
        "paper K7Q2-9FHM, q2 (slider-crank): TeX: Misplaced alignment tab character & in line "
    )
    assert "a &b" in problem
    assert problem.endswith(
        " - expected math that can be typeset - fix the formula in the template"
    )


def test_all_faults_of_all_papers_are_told_at_once() -> None:
    question = replace(ENGLISH_QUESTION, title="# a `b`", statement=r"$\foo$", figure=None)
    paper = replace(
        ENGLISH, rules=("<b>",), questions=(question, replace(question, identifier="q2"))
    )
    with pytest.raises(TypesetError) as refusal:
        LatexPress().papers({"s": paper, "t": replace(ENGLISH, questions=(question,))})
    wheres = [
        problem.split(":")[0].removeprefix("paper A-0001, ") for problem in refusal.value.problems
    ]
    assert wheres == [
        "rules",
        "q1, title",
        "q1, statement",
        "q2, title",
        "q2, statement",
    ]


def test_worked_solutions() -> None:
    broad = replace(ENGLISH_SOLUTION.questions[0], blocks=(long_equation(11),))
    sheets = {
        "en": ENGLISH_SOLUTION,
        "zh": CHINESE_SOLUTION,
        "long": replace(ENGLISH_SOLUTION, questions=(broad,)),
    }
    printouts = LatexPress().solutions(sheets)
    pages = {name: "".join(pages_of(printouts[name].pdf)) for name in sheets}
    assert [
        word
        for word in ("Workedsolutions", "magnitude", "direction", "1.33333", "page1of")
        if word not in pages["en"]
    ] == []
    assert [
        word for word in ("题解", "大小", "方向", "向右", "第1页") if word not in pages["zh"]
    ] == []
    assert pages["long"].count("magnitude") == 2


@pytest.mark.left(beside="test_a_paragraph_of_reasoning_leaves_no_line_alone_at_the_end_of_a_page")
def test_what_stays_together_is_on_one_page_wherever_that_ends() -> None:
    """The glue below a table and below an equation was a place for the page to end."""
    given = (Prose("Given:"), read_display([r"x &= 1", r"y &= 2"]))
    table = (long_equation(2), Pictures((Picture(polygon_scene(), "velocity polygon"),)))
    chapter = (Heading("Accelerations", 1), *given, Heading("The rod", 2), Prose("Thus."), *table)
    question = replace(ENGLISH_SOLUTION.questions[0], figure=None, statement="It turns.")
    sheets = {
        f"{count}": replace(
            ENGLISH_SOLUTION,
            questions=(replace(question, blocks=(*[read_display([r"z &= 0"])] * count, *chapter)),),
        )
        for count in range(12, 40)
    }
    printouts = LatexPress().solutions(sheets)
    for count in sheets:
        pages = pages_of(printouts[count].pdf)
        (whole,) = (page for page in pages if "magnitude" in page)
        words = ("Accelerations", "Therod", "velocitypolygon")
        assert [word for word in words if word not in whole] == [], count


def test_the_key_gives_exact_and_decimal_and_warns_on_each_page() -> None:
    book = key_book(30)
    named = replace(book, papers=(replace(book.papers[0], name="😀"), *book.papers[1:]))
    pages = pages_of(LatexPress().key(named).pdf)
    assert [
        (number, page)
        for number, page in enumerate(pages, 1)
        if not ("INSTRUCTORONLY" in page and f"page{number}" in page)
    ] == []
    for text in (
        "[U+1F600]",
        "1.15470",
        "−0.957427",
        "[1.14315,1.16625]",
        "A-0000",
        "Given:",
        "0.25m",
    ):
        assert text in pages[0]


def test_an_empty_key_is_one_page() -> None:
    assert len(pages_of(LatexPress().key(key_book(0)).pdf)) == 1


@pytest.mark.left(beside="test_the_page_says_everything_in_the_same_bytes_every_time")
def test_kept_sources_can_be_typeset_by_hand(tmp_path: Path) -> None:
    papers = {
        "zoe": replace(ENGLISH, name="Zoë"),
        "ou": replace(CHINESE, questions=(CHINESE_QUESTION,)),
    }
    printouts = LatexPress().papers(papers) | {"key": LatexPress().key(key_book(1))}
    for name, printout in printouts.items():
        assert set(printout.sources) == {"kinegrade.sty", f"{name}.tex"}
        for file, source in printout.sources.items():
            (tmp_path / file).write_bytes(source)
        first_line = printout.sources[f"{name}.tex"].decode().split("\n", 1)[0]
        command = first_line.rpartition("  ")[2].split()
        subprocess.run(
            [command[0], "-interaction=batchmode", command[1]],
            cwd=tmp_path,
            check=True,
            stdout=subprocess.DEVNULL,
        )
        assert pages_of((tmp_path / f"{name}.pdf").read_bytes()) == pages_of(printout.pdf)


def test_tex_has_no_shell_and_no_files_of_others(tmp_path: Path) -> None:
    secret = tmp_path / "secret.tex"
    secret.write_text("SECRET", encoding="utf-8")
    for index, attack in enumerate(
        (r"\immediate\write18{touch made}x", rf"\input{{{secret}}}", r"\input{.hidden}")
    ):
        folder = tmp_path / str(index)
        folder.mkdir()
        (folder / ".hidden.tex").write_text("SECRET", encoding="utf-8")
        source = rf"\documentclass{{article}}\begin{{document}}{attack}\end{{document}}"
        outcome = run(source, folder, 30)
        assert not (folder / "made").exists()
        assert outcome.fault or "SECRET" not in "".join(pages_of(make_pdf(folder)))


def test_a_run_without_end_is_ended(tmp_path: Path) -> None:
    source = r"\documentclass{article}\begin{document}\loop\iftrue\repeat\end{document}"
    with pytest.raises(
        TypesetError,
        match=r"^latex: xelatex did not end within 1 s - expected a few pages a second - ",
    ):
        run(source, tmp_path, 1)


def test_pages_that_were_never_typeset_are_no_pdf(tmp_path: Path) -> None:
    with pytest.raises(
        TypesetError,
        match=r"^latex: xdvipdfmx wrote no PDF \(.*pages.xdv.*\) - expected the pages that XeTeX",
    ):
        make_pdf(tmp_path, (1, 2))


def test_nothing_to_print_is_nothing_printed() -> None:
    assert LatexPress().papers({}) == {}


def test_it_is_a_press() -> None:
    press: Press = LatexPress()
    assert press.unprintable([]) == frozenset()


def test_files_state_their_title_and_their_language() -> None:
    papers = {"a": ENGLISH, "b": replace(CHINESE, title="运动学 Ω")}
    for name, printed in LatexPress().papers(papers).items():
        with pikepdf.open(BytesIO(printed.pdf)) as document:
            assert str(document.docinfo.Title) == papers[name].title
            assert str(document.Root.Lang) == {"en": "en", "zh": "zh-CN"}[papers[name].language]
            assert document.Root.ViewerPreferences.DisplayDocTitle is True


def test_a_paragraph_of_reasoning_leaves_no_line_alone_at_the_end_of_a_page() -> None:
    """The title of a step stood at the foot with the first line of its sentence, and half an empty
    page below it.
    """
    assert r"{\clubpenalty10000 \widowpenalty10000 #1\par}" in write_style()
