"""Papers of an exam have the same number of pages, and none of these is white: what is left of a
page is room for working.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import cycle
from pathlib import Path

import pytest
from msgspec import structs
from pypdf import PdfReader

from kinegrade.exam.bank.bank import read_bank
from kinegrade.exam.folder.exam_secret import FromWords
from kinegrade.exam.generating.page_counts import list_longer_papers
from kinegrade.exam.printing import class_printing
from kinegrade.exam.printing.pages import lay_out_paper
from kinegrade.exam.printing.printing import Extras, PressOrder, PrintRun
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.roster.students import Student
from kinegrade.exam.setting.dealing import deal_exam
from kinegrade.press.binding.part import count_pages
from kinegrade.press.protocol import Engine, Press
from kinegrade.press.sheet import Paper, PaperSize
from kinegrade.problem.template.library.library import find_shipped, list_names
from tests.exam.engines import ENGINES, pair_with_engines
from tests.exam.printed_pages import MOST_WHITE, list_faults, measure_white
from tests.press.papers import CHINESE, ENGLISH
from tests.said import said
from tests.small_class import BANK, generate, kinegrade, write_class

BANKS = list_names(find_shipped("banks"))


def pages_of(exam: Path) -> dict[str, int]:
    """How many pages each paper has."""
    return {file.stem: len(PdfReader(file).pages) for file in (exam / "papers").glob("*.pdf")}


def write_uneven_class(folder: Path) -> Path:
    """A class whose papers, each with its own order, differ in length."""
    write_class(folder)
    frame, *questions = BANK.split("[[questions]]")
    declared = (
        f'[[questions]]\nspace = "{room} mm"{question}'
        for room, question in zip((20, 60, 60), questions, strict=True)
    )
    text = "".join(("shuffle = true\n", frame, *declared))
    (folder / "bank.toml").write_text(text, encoding="utf-8")
    return folder


@pytest.mark.sampled(4, by="bank")  # "printed pages" of `make prove` prints all
@pytest.mark.parametrize(("bank", "language"), [*zip(BANKS, cycle(("en", "zh")), strict=False)])
def test_papers_of_a_shipped_bank_are_alike_long_and_filled(
    tmp_path: Path, bank: str, language: str
) -> None:
    (tmp_path / "roster.csv").write_text("student,name\n1,Ann\n2,Bob\n3,张喆\n", encoding="utf-8")
    words = ("--reproducible", "spring", "--lang", language)
    result = kinegrade("generate", bank, tmp_path / "roster.csv", "-o", tmp_path / "EXAM", *words)
    assert result.exit_code == 0, result.stderr
    assert list_faults(tmp_path / "EXAM") == []


@pytest.mark.left(beside="test_papers_of_a_shipped_bank_are_alike_long_and_filled")
@pytest.mark.needs_tex
def test_so_are_those_that_latex_sets(tmp_path: Path) -> None:
    write_uneven_class(tmp_path)
    words = ("--engine", "latex", "--paper-size", "letter", "--lang", "zh")
    assert generate(tmp_path, "EXAM", *words).exit_code == 0
    assert list_faults(tmp_path / "EXAM") == []


@pytest.mark.sampled(2, by="engine")
@pytest.mark.parametrize("engine", ENGINES)
def test_a_paper_is_filled_up_with_pages_for_working(engine: Engine, tmp_path: Path) -> None:
    cases: tuple[tuple[PaperSize, Paper, str], ...] = (
        ("a4", CHINESE, "演算用纸"),
        ("letter", ENGLISH, "Space for working"),
    )
    for size, paper, words in cases:
        press = PressOrder(engine, size).press()
        file = tmp_path / "more.pdf"
        file.write_bytes(press.papers({"more": replace(paper, pages=3)})["more"].pdf)
        shown = [words in page.extract_text() for page in PdfReader(file).pages]
        assert shown == [False, True, True]
        assert max(measure_white(file)) <= MOST_WHITE


@pytest.mark.sampled(2, by="engine")
@pytest.mark.parametrize("engine", ENGINES)
def test_a_paper_that_is_long_enough_stays_byte_for_byte(engine: Engine) -> None:
    press = PressOrder(engine, "a4").press()
    whole = press.papers({"one": ENGLISH})["one"].pdf
    for pages in (0, 1):
        assert press.papers({"one": replace(ENGLISH, pages=pages)})["one"].pdf == whole


@pytest.mark.sampled(6, by="size")  # each size, and each engine
@pytest.mark.parametrize(("size", "engine"), pair_with_engines("a4", "letter"))
def test_room_is_left_between_statement_and_answers(engine: Engine, size: PaperSize) -> None:
    press: Press = PressOrder(engine, size).press()
    question = ENGLISH.questions[0]

    def count(space: float) -> int:
        questions = tuple(replace(question, space=space) for _ in range(2))
        return count_pages(press.papers({"one": replace(ENGLISH, questions=questions)})["one"].pdf)

    assert (count(0.0), count(120.0)) == (1, 2)
    assert count(200.0) <= 3  # more than a page holds is what it holds


def test_papers_of_different_lengths_are_filled_up(tmp_path: Path) -> None:
    write_uneven_class(tmp_path)
    result = generate(tmp_path)
    assert result.exit_code == 0, result.stderr
    assert len(set(pages_of(tmp_path / "EXAM").values())) == 1
    shown = ["Space for working" in page.extract_text() for page in
             PdfReader(tmp_path / "EXAM" / "papers.pdf").pages]  # fmt: skip
    assert True in shown


def test_papers_printed_apart_are_filled_up_too(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_uneven_class(tmp_path)
    assert generate(tmp_path, "TOGETHER").exit_code == 0
    monkeypatch.setattr(class_printing, "CHUNK", 1)
    monkeypatch.setattr(class_printing, "MOST", 1)
    assert generate(tmp_path, "APART").exit_code == 0
    for name in ("papers.pdf", "exam.json", "key.jsonl", "papers/007.pdf", "papers/0012.pdf"):
        together = (tmp_path / "TOGETHER" / name).read_bytes()
        assert (tmp_path / "APART" / name).read_bytes() == together


def test_a_late_paper_is_as_long_and_each_is_printed_again_byte_for_byte(tmp_path: Path) -> None:
    write_uneven_class(tmp_path)
    exam = tmp_path / "EXAM"
    assert generate(tmp_path).exit_code == 0
    (tmp_path / "late.csv").write_text("student,name\n99,Bob\n100,Eve\n", encoding="utf-8")
    files = (tmp_path / "bank.toml", tmp_path / "roster.csv", "-o", exam, "--allow-odd-ids")
    result = kinegrade("generate", *files, "--add", tmp_path / "late.csv")
    assert result.exit_code == 0, result.stderr
    assert len(pages_of(exam)) == 6
    assert len(set(pages_of(exam).values())) == 1
    for student in ("007", "0012", "99", "100"):
        again = kinegrade("paper", exam, student).stdout_bytes
        assert again == (exam / "papers" / f"{student}.pdf").read_bytes()


def test_a_late_paper_that_is_longer_is_a_complaint(tmp_path: Path) -> None:
    run = PrintRun(
        read_bank(write_class(tmp_path) / "bank.toml"), "en", PressOrder("typst", "a4"), Extras()
    )
    students = (Student("007", "Ann", "", "007"), Student("0012", "Zoë", "", "0012"))
    complaints = list_longer_papers(structs.replace(run, pages=4), students, (5, 4))
    assert list(map(said, complaints)) == ["007: the paper has 5 pages, those of the others 4"]
    assert list(list_longer_papers(structs.replace(run, pages=0), students, (5, 4))) == []


@pytest.mark.parametrize(
    ("space", "question", "expected"),
    [
        ("", "", [0, 0, 0]),
        ('space = "6 cm"', "", [60, 60, 60]),
        ('space = "6cm"', 'space = "25 mm"', [60, 60, 25]),
        ("", 'space = "1.5 in"', [0, 0, 38.1]),
    ],
)
def test_a_bank_declares_room_for_working(
    tmp_path: Path, space: str, question: str, expected: list[float]
) -> None:
    text = f"{space}\n{(BANK)}{question}\n"
    (write_class(tmp_path) / "bank.toml").write_text(text, encoding="utf-8")
    bank = read_bank(tmp_path / "bank.toml")
    dealt = deal_exam(bank, Roster((Student("007", "Ann", "", "007"),), ()), FromWords("spring"))
    sheets = lay_out_paper(bank, next(dealt.papers()), "en").questions
    assert [sheet.space for sheet in sheets] == pytest.approx(expected)


@pytest.mark.parametrize(
    ("stated", "found"),
    [('"6"', '"6"'), ("6", "6"), ('"201 mm"', '"201 mm"'), ('"-1 cm"', '"-1 cm"'), ('""', '""')],
)
def test_room_that_is_none_is_refused_with_its_line(
    tmp_path: Path, stated: str, found: str
) -> None:
    file = write_class(tmp_path) / "bank.toml"
    file.write_text(f"space = {stated}\n{BANK}", encoding="utf-8")
    result = generate(tmp_path)
    assert result.exit_code == 2
    (line,) = result.stderr.splitlines()
    assert line.startswith(f"error: {file}:1: space: {found} - expected a")
