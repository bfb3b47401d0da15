"""Worked solutions come out as pages: everything is on them, nothing sticks out, no heading stands
alone.
"""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from dataclasses import replace
from io import BytesIO
from pathlib import Path
from struct import unpack
from unicodedata import normalize
from zlib import decompress

import pytest
import typst
from pypdf import PdfReader

from kinegrade.errors import TypesetError
from kinegrade.press.sheet import PaperSize, SolutionSheet
from kinegrade.press.typst.compiler import make_compiler
from kinegrade.press.typst.solution import SolutionLayouts
from kinegrade.worked.document import (
    Block,
    Heading,
    Picture,
    Pictures,
    Prose,
    TermTable,
)
from tests.press.solutions import CHINESE_SOLUTION, ENGLISH_SOLUTION, long_equation, polygon_scene
from tests.worked.telling import read_display, read_term

Print = Callable[..., list[str]]
TERMS = " + ".join(
    rf"\omega_{{{index}}}^2\cdot O_{{{index}}}B\cos {index}^{{\circ}}" for index in range(24)
)
LONG = f"x &= {TERMS} = 3"
UNBREAKABLE = r"\sqrt{" + " + ".join(rf"{index}\sqrt{{{index}}}" for index in range(100, 130)) + "}"


def worked(*blocks: Block, sheet: SolutionSheet = ENGLISH_SOLUTION) -> SolutionSheet:
    """The sheet with one question that has these blocks."""
    return replace(sheet, questions=(replace(sheet.questions[0], blocks=blocks),))


@pytest.fixture(scope="module")
def compiler() -> typst.Compiler:
    return make_compiler()


@pytest.fixture(scope="module")
def pages(compiler: typst.Compiler) -> Print:
    """The text of each page, blanks taken out, letters of math as plain ones."""

    def read(sheet: SolutionSheet, size: PaperSize = "a4") -> list[str]:
        pdf = compiler.compile(
            SolutionLayouts(sheet, size).write().encode(), format="pdf", pdf_standards=["a-2b"]
        )
        return [
            "".join(normalize("NFKC", page.extract_text()).split())
            for page in PdfReader(BytesIO(pdf)).pages
        ]

    return read


def inked_columns(image: bytes) -> tuple[int, int, int]:
    """The first and the last column of a PNG page (8 bits, RGBA) that are not white, and the number
    of columns.
    """
    width, height = unpack(">II", image[16:24])
    chunks, at = [], 8
    while at < len(image):
        length, kind = unpack(">I4s", image[at : at + 8])
        chunks += [image[at + 8 : at + 8 + length]] if kind == b"IDAT" else []
        at += length + 12
    raw, before, darkest = (
        decompress(b"".join(chunks)),
        bytearray(4 * width),
        bytearray(b"\xff" * 4 * width),
    )
    for start in range(0, height * (4 * width + 1), 4 * width + 1):
        before = unfiltered(raw[start], raw[start + 1 : start + 1 + 4 * width], before)
        darkest = bytearray(map(min, darkest, before))
    dark = [column for column in range(width) if min(darkest[4 * column : 4 * column + 3]) < 200]
    return min(dark), max(dark), width


def unfiltered(kind: int, line: bytes, above: bytearray) -> bytearray:
    """A line of a PNG from its differences to its left and upper neighbours."""
    found = bytearray(line)
    for index in range(len(line)) if kind else ():
        left, corner = (found[index - 4], above[index - 4]) if index >= 4 else (0, 0)
        up = above[index]
        nearest = min((left, up, corner), key=lambda value: abs(left + up - corner - value))
        found[index] = (line[index] + (0, left, up, (left + up) // 2, nearest)[kind]) & 255
    return found


@pytest.mark.parametrize(
    ("sheet", "expected"),
    [
        (
            ENGLISH_SOLUTION,
            [
                "Workedsolutions",
                "K7Q2-9FHM",
                "Question1Slider-crank",
                "magnitude",
                "direction",
                "Velocitypolygon",
                "1.33333",
                "totheright",
                "page1of",
            ],
        ),
        (
            CHINESE_SOLUTION,
            [
                "期中考试题解",
                "第1题(登分表第3题)",
                "大小",
                "方向",
                "速度多边形",
                "向右",
                "共1页",
            ],
        ),
    ],
)
def test_the_pages_say_everything(pages: Print, sheet: SolutionSheet, expected: list[str]) -> None:
    text = "".join(pages(sheet))
    assert [part for part in expected if part not in text] == []


@pytest.mark.parametrize("size", ["a4", "letter"])
@pytest.mark.parametrize("terms", range(2, 10))
def test_an_equation_of_many_terms_is_whole(pages: Print, terms: int, size: PaperSize) -> None:
    text = "".join(pages(worked(long_equation(terms)), size))
    assert text.count("fromBtoO1") == len([index for index in range(terms) if index % 5 == 2])
    assert "magnitude" in text


def test_nothing_sticks_out_of_the_page(compiler: typst.Compiler) -> None:
    sheet = worked(
        *map(long_equation, range(2, 10)),
        read_display((LONG, f"y &= {UNBREAKABLE}")),
        read_display((f"{LONG} &= 1",)),
        read_display((rf"\omega_{{AB}} &= \boxed{{{UNBREAKABLE}}}",)),
        Pictures((Picture(polygon_scene(), "a caption " * 30),) * 5),
    )
    images = compiler.compile(SolutionLayouts(sheet).write().encode(), format="png", ppi=36)
    assert len(images) >= 2
    for left, right, width in map(inked_columns, images):
        assert left >= 16 / 210 * width
        assert right <= 194 / 210 * width


def test_the_unit_of_a_caption_stands_on_one_line(compiler: typst.Compiler) -> None:
    captions = ("a" * length + " 1 mm corresponds to 0.1 m/s" for length in range(1, 30))
    drawn = (Pictures((Picture(polygon_scene(), caption),)) for caption in captions)
    source = SolutionLayouts(worked(*drawn)).write()
    pdf = compiler.compile(source.encode(), format="pdf")
    assert isinstance(pdf, bytes)
    text = "\n".join(page.extract_text() for page in PdfReader(BytesIO(pdf)).pages)
    assert text.count("0.1 m/s") == 29


def test_chinese_before_a_long_formula_is_not_drawn_out_over_the_line(
    compiler: typst.Compiler, tmp_path: Path
) -> None:
    long = r"$\sqrt{(x_{E} - x_{D})^{2} + (y_{E} - y_{D})^{2} + (x_{B} - x_{C})^{2}}$"
    prose = (Prose("由线轴上的接触点" + "算" * length + f" {long} 可知。") for length in range(30))
    source = SolutionLayouts(worked(*prose, sheet=CHINESE_SOLUTION)).write()
    pdf = tmp_path / "solution.pdf"
    compiler.compile(source.encode(), format="pdf", output=pdf)
    read = subprocess.run(["pdftotext", pdf, "-"], capture_output=True, text=True, check=True)
    drawn_out = "由 线"
    assert drawn_out not in read.stdout
    assert "由线轴上的接触点" in read.stdout


def test_a_long_line_goes_on_in_further_rows(compiler: typst.Compiler) -> None:
    pdf = compiler.compile(
        SolutionLayouts(worked(read_display((LONG,)))).write().encode(), format="pdf"
    )
    rows: set[int] = set()
    PdfReader(BytesIO(pdf)).pages[0].extract_text(
        visitor_text=lambda text, now, at, font, size: (
            rows.add(round(now[5])) if "cos" in text else None
        )
    )
    assert len(rows) >= 4


def test_a_heading_is_never_the_last_thing_on_a_page(pages: Print) -> None:
    for lines in range(40, 46):
        filler = tuple(Prose(f"Line {index}.") for index in range(lines - 10))
        steps = (
            Heading("The chapter", 1),
            Heading("The step", 2),
            long_equation(3),
            Prose("Projected:"),
            read_display(("a &= b",)),
        )
        for page in pages(worked(*filler, *steps)):
            assert (
                ("Thechapter" in page)
                == ("magnitude" in page)
                == ("Projected:" in page)
                == ("a=b" in page)
            )


def test_same_input_same_source() -> None:
    assert SolutionLayouts(CHINESE_SOLUTION).write() == SolutionLayouts(CHINESE_SOLUTION).write()


def test_plain_text_never_becomes_code(pages: Print) -> None:
    code = '#read("x")$y$'
    fields = ("course", "title", "date", "student", "name", "code")
    text = "".join(pages(replace(ENGLISH_SOLUTION, **dict.fromkeys(fields, code))))
    assert text.count(code) >= 9


def test_all_faults_are_told_at_once_with_their_question() -> None:
    bad = worked(
        Heading("<b>", 1),
        Prose(r"$\foo$"),
        TermTable((read_term("", "v", "`?`", "# x"),)),
        Pictures((Picture(polygon_scene(), r"$\fee$"),)),
    )
    with pytest.raises(TypesetError) as refusal:
        SolutionLayouts(bad).write()
    problems = refusal.value.problems
    assert {problem.split(":")[0] for problem in problems} == {"q1, solution"}
    for word in (
        "raw HTML",
        r"\foo",
        "code",
        r"\fee",
    ):
        assert any(word in problem for problem in problems), problems
