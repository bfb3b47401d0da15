"""An honest tolerance is one paper's own: the paper states it row by row, its key keeps it, and
whatever is made of the exam later goes by the key.
"""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import replace

from kinegrade.exam.bank.bank import read_bank
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.folder.exam_secret import FromWords
from kinegrade.exam.printing.pages import lay_out_paper
from kinegrade.exam.quiz.quiz import read_quiz
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.roster.students import Student
from kinegrade.exam.setting.dealing import deal_exam
from kinegrade.exam.setting.setting import SetAsk
from kinegrade.language import Language
from kinegrade.press.latex.paper import write_paper_body
from kinegrade.press.sheet import Paper
from kinegrade.press.typst.paper import write_paper_source
from kinegrade.press.word.paper import write_paper_tree
from tests.printed_text import read_pages
from tests.problem.crank import crank_text
from tests.small_class import VANISHING, asks_of, contents, key_lines, kinegrade, table

BANK = """title = { en = "Quiz", zh = "小测", de = "Test" }
course = { en = "Mechanics", zh = "力学", de = "Mechanik" }
tolerance = "honest"
carry = 5
[[questions]]
template = "slider-crank"
asks = { v_B = 3, omega_AB = 2 }
[[questions]]
template = "slider-crank"
tolerance = { relative = "2 %", absolute = 0.5, honest = true }
asks = { a_B = 2 }
"""
ZERO = """[[questions]]
template = "crank.toml"
draw = { h = [0], r = [1, 2, 3], omega = [2, 3, 4] }
asks = { v_x = 1, v_y = { points = 2, tolerance = { absolute = 0.25 } } }
"""
SHARE = r"(?:1|1[.,]5|2|3|4|5) %"
WIDE = 0.05  # a share that another version may have found
Ask = dict[str, Any]


@pytest.fixture(scope="module")
def generated(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("honest")
    (folder / "bank.toml").write_text(BANK + ZERO, encoding="utf-8")
    (folder / "crank.toml").write_text(crank_text(VANISHING), encoding="utf-8")
    (folder / "roster.csv").write_text("student,name\n007,Ann\n0012,Zoë\n", encoding="utf-8")
    (folder / "late.csv").write_text("student,name\n99,Bob\n", encoding="utf-8")
    files = folder / "bank.toml", folder / "roster.csv"
    words = ("--reproducible", "spring")
    result = kinegrade("generate", *files, "-o", folder / "EXAM", *words)
    assert result.exit_code == 0, result.stderr
    return folder


@pytest.fixture
def folder(generated: Path, tmp_path: Path) -> Path:
    """The class in a folder of its own."""
    return Path(shutil.copytree(generated, tmp_path / "class"))


def edit_key(exam: Path, question: int, ask: str, edit: Callable[[Ask], object]) -> None:
    """Change what the key of the first student says of an ask."""
    first, *others = key_lines(exam)
    edit(first["questions"][question]["asks"][ask])
    text = "".join(json.dumps(line) + "\n" for line in (first, *others))
    (exam / "key.jsonl").write_text(text, encoding="utf-8")


def widen(exam: Path) -> None:
    """As if another version had found that v_B takes 5 %."""
    edit_key(exam, 0, "v_B", lambda ask: ask["tolerance"].update(relative=WIDE))


def lay_out(folder: Path, language: Language) -> Paper:
    """A paper in that language, of which v_B and a_B take 3 %."""
    (folder / "bank.toml").write_text(BANK, encoding="utf-8")
    roster = Roster((Student("007", "Ann", "", "007"),), ())
    dealt = deal_exam(read_bank(folder / "bank.toml"), roster, FromWords("spring"))
    paper = next(dealt.papers())
    wider = tuple(
        replace(question, asks=tuple(map(widen_ask, question.asks))) for question in paper.questions
    )
    return lay_out_paper(dealt.bank, replace(paper, questions=wider), language)


def widen_ask(ask: SetAsk) -> SetAsk:
    share = Fraction(1, 100) if ask.ask.name == "omega_AB" else Fraction(3, 100)
    return replace(ask, tolerance=replace(ask.tolerance, relative=share))


def words(pdf: bytes) -> str:
    text = " ".join(read_pages(pdf))
    return re.sub(r"\s+", " ", text)


@pytest.mark.parametrize(
    ("language", "choice", "mark"),
    [("en", " or ", "."), ("zh", "或", "."), ("de", " oder ", "{,}")],
)
def test_each_row_states_its_tolerance(
    tmp_path: Path, language: Language, choice: str, mark: str
) -> None:
    paper = lay_out(tmp_path, language)
    v_B, omega_AB, a_B = (row.tolerance for question in paper.questions for row in question.rows)
    assert (v_B, omega_AB) == (("3 %",), ("1 %",))
    assert a_B[0] == rf"3 %{choice}$\pm0{mark}5\,\unit{{m/s^2}}$"


def test_a_row_of_a_zero_looks_like_others(generated: Path) -> None:
    key = asks_of(generated / "EXAM")["007", "q3.v_x"]
    assert key["value"] == 0
    paper = words((generated / "EXAM" / "papers" / "007.pdf").read_bytes())
    along = re.search(r"along x.*?along y", paper)
    assert along is not None
    assert re.search(rf"m/s {SHARE} /", along[0])


def test_what_holds_next_to_zero_is_the_least_share_of_the_bank(tmp_path: Path) -> None:
    """Rows may state a wider one, which honest rounding takes."""
    paper = lay_out(tmp_path, "en")
    assert paper.rules[-1].endswith(
        "Where larger terms cancel, so that the exact value is zero or less than 1 % of the "
        "largest of them, at least 1 % of that term is allowed."
    )


def test_every_layout_prints_the_rows_tolerance(tmp_path: Path) -> None:
    paper = lay_out(tmp_path, "en")
    typst, latex = write_paper_source(paper), write_paper_body(paper)
    tree = write_paper_tree(paper, {}).decode()
    assert len(re.findall("3 %", typst)) == 2
    assert len(re.findall(r"3(?:\\,|~|\s)*\\%", latex)) == 2
    assert tree.count("3 %") == 2


def test_a_paper_is_printed_again_byte_for_byte(generated: Path) -> None:
    again = kinegrade("paper", generated / "EXAM", "007").stdout_bytes
    assert again == (generated / "EXAM" / "papers" / "007.pdf").read_bytes()


def test_a_paper_printed_again_states_the_tolerance_that_its_key_keeps(folder: Path) -> None:
    widen(folder / "EXAM")
    for options in ((), ("--solution",)):
        result = kinegrade("paper", folder / "EXAM", "007", *options)
        assert (result.exit_code, result.stderr) == (0, "")
        if not options:
            assert re.search(r"m/s 5 % /", words(result.stdout_bytes))


@pytest.mark.parametrize(("off", "verdict"), [("0.0499", "right"), ("0.0501", "wrong")])
def test_marking_goes_by_the_tolerance_that_the_key_keeps(
    folder: Path, off: str, verdict: str
) -> None:
    exam, answers = folder / "EXAM", folder / "answers.csv"
    widen(exam)
    typed = Fraction(asks_of(exam)["007", "q1.v_B"]["decimal"]) * (1 + Fraction(off))
    answers.write_text(f"student,q1.v_B\n007,{float(typed):.12g}\n", encoding="utf-8")
    assert kinegrade("grade", exam, answers, "-o", folder / "MARKS").exit_code < 2
    marks = {row["ask"]: row["verdict"] for row in table(folder / "MARKS" / "marks.csv")[:2]}
    assert marks["v_B"] == verdict


def test_a_quiz_states_each_papers_own_tolerance(folder: Path) -> None:
    widen(folder / "EXAM")
    first, second = read_quiz(open_exam(folder / "EXAM")).papers
    (v_B, _), (_, honest_zero) = first.questions[0].asks, first.questions[2].asks
    assert v_B.high - v_B.value == abs(v_B.value) * Fraction(str(WIDE))
    assert (
        "at most 5 % of that value. Where larger terms cancel, so that the exact value is zero or "
        in (first.questions[0].rule)
    )
    assert "at most 5 % of that value" not in second.questions[0].rule
    for paper in (first, second):
        rule = paper.questions[1].rule
        assert re.search(rf"at most {SHARE} of that value, or by at most \$0.5", rule)
        assert [question.digits for question in paper.questions] == [5, 5, 5]
    assert honest_zero.high - honest_zero.value == Fraction(1, 4)


def test_a_quiz_says_how_many_digits_to_carry(generated: Path) -> None:
    file = generated / "moodle.xml"
    assert kinegrade("quiz", generated / "EXAM", "--to", "moodle-xml", "-o", file).exit_code < 2
    text = file.read_text(encoding="utf-8")
    assert "Carry at least five significant digits in every value that you write down." in text


def test_late_students_change_no_tolerance_of_the_others(folder: Path) -> None:
    exam = folder / "EXAM"
    widen(exam)
    before = (exam / "key.jsonl").read_text(encoding="utf-8")
    papers = {name: data for name, data in contents(exam).items() if name.endswith("007.pdf")}
    files = folder / "bank.toml", folder / "roster.csv"
    result = kinegrade("generate", *files, "-o", exam, "--add", folder / "late.csv")
    assert result.exit_code == 0, result.stderr
    assert (exam / "key.jsonl").read_text(encoding="utf-8").startswith(before)
    assert papers.items() <= contents(exam).items()
    assert ("99", "q1.v_B") in asks_of(exam)


@pytest.mark.parametrize(
    ("place", "term", "value", "difference"),
    [
        # Narrower than the bank states
        ((0, "v_B"), "relative", 0.005, "v_B: tolerance is relative 0.005, .* relative 0.01, "),
        # Not what the mechanism's scale gives
        (
            (2, "v_x"),
            "absolute",
            0.0001,
            "v_x: tolerance is relative 0.0.*, absolute 0.0001 by the",
        ),
        # Not honest
        ((2, "v_y"), "absolute", 0.5, "v_y: tolerance is relative 0, absolute 0.5 by the key, "),
        ((0, "v_B"), "figures", 3, "v_B: tolerance is relative 0.0.*, figures 3 by the key, "),
        ((0, "v_B"), "relative", -1, '"relative" is -1 - expected zero or more'),
    ],
)
def test_no_other_tolerance_than_a_paper_could_have_is_taken(
    folder: Path, place: tuple[int, str], term: str, value: float, difference: str
) -> None:
    edit_key(folder / "EXAM", *place, lambda each: each["tolerance"].update({term: value}))
    result = kinegrade("paper", folder / "EXAM", "007")
    assert result.exit_code == 2
    (line,) = result.stderr.splitlines()
    assert re.search(rf"key\.jsonl: .*q{place[0] + 1}: {difference}", line), line


def test_a_quiz_does_not_tell_that_an_answer_is_zero_on_every_paper(generated: Path) -> None:
    for paper in read_quiz(open_exam(generated / "EXAM")).papers:
        (v_x, _), rule = paper.questions[2].asks, paper.questions[2].rule
        assert v_x.value == 0
        assert v_x.low < 0 < v_x.high
        stated = re.search(r"For \$v_\{x\}\$: (.*?) Where", rule)
        assert stated is not None
        assert re.fullmatch(rf"an answer .* by at most {SHARE} of that value\.", stated[1])


def test_a_quiz_of_asks_that_the_bank_does_not_have_is_refused(folder: Path) -> None:
    bank = folder / "EXAM" / "bank.toml"
    text = bank.read_text(encoding="utf-8")
    bank.write_text(text.replace("v_B = 3, omega_AB = 2", "v_B = 5"), encoding="utf-8")
    words = ("--to", "moodle-xml", "-o", folder / "quiz.xml")
    result = kinegrade("quiz", folder / "EXAM", *words)
    assert result.exit_code == 2
    assert re.search(r"key\.jsonl: .*007.*q1\.omega_AB is not in bank\.toml", result.stderr)


COUPLER = """title = "Quiz"
course = "Mechanics"
tolerance = "honest"
carry = 3
[[questions]]
template = "pole-four-bar-coupler"
"""


@pytest.fixture(scope="module")
def coupler(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Four papers on a mechanism at which rounding to three figures matters."""
    folder = tmp_path_factory.mktemp("coupler")
    (folder / "bank.toml").write_text(COUPLER, encoding="utf-8")
    rows = "".join(f"s{number},Student\n" for number in range(4))
    (folder / "roster.csv").write_text(f"student,name\n{rows}", encoding="utf-8")
    files = folder / "bank.toml", folder / "roster.csv"
    words = ("--reproducible", "spring")
    result = kinegrade("generate", *files, "-o", folder / "EXAM", *words)
    assert result.exit_code == 0, result.stderr
    return folder


def test_each_row_states_the_share_that_the_key_keeps(coupler: Path) -> None:
    for line in key_lines(coupler / "EXAM"):
        paper = words((coupler / "EXAM" / "papers" / f"{line['student']}.pdf").read_bytes())
        (question,) = line["questions"]
        kept = [float(ask["tolerance"]["relative"]) for ask in question["asks"].values()]
        stated = [float(share) / 100 for share in re.findall(r"([\d.]+) % /", paper)]
        assert stated == pytest.approx(kept)
        assert set(stated) <= {0.01, 0.015, 0.02, 0.03, 0.04, 0.05, 0.06, 0.08, 0.1}


@pytest.mark.parametrize(("part", "right"), [("0.999", True), ("1.001", False)])
def test_an_answer_is_right_as_far_as_its_row_allows(
    coupler: Path, tmp_path: Path, part: str, right: bool
) -> None:
    typed: dict[str, list[str]] = {}
    for (student, _), ask in asks_of(coupler / "EXAM").items():
        exact = Fraction(ask["decimal"])
        share = Fraction(str(ask["tolerance"]["relative"]))
        room = max(abs(exact) * share, Fraction(str(ask["tolerance"]["absolute"])))
        typed.setdefault(student, []).append(f"{float(exact + room * Fraction(part)):.12g}")
    columns = [name for student, name in asks_of(coupler / "EXAM") if student == "s0"]
    rows = "".join(f"{student},{','.join(cells)}\n" for student, cells in typed.items())
    answers = tmp_path / "answers.csv"
    answers.write_text(f"student,{','.join(columns)}\n{rows}", encoding="utf-8")
    policy = tmp_path / "policy.toml"
    policy.write_text("credit = { follow-through = 0 }\n", encoding="utf-8")
    words = ("--policy", policy, "-o", tmp_path / "MARKS")
    assert kinegrade("grade", coupler / "EXAM", answers, *words).exit_code < 2
    found = table(tmp_path / "MARKS" / "marks.csv")
    assert {row["verdict"] == "right" for row in found} == {right}
