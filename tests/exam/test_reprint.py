"""`kinegrade paper`: one paper again, byte for byte, from the folder alone."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import Result

from tests.printed_text import read_pages
from tests.small_class import contents, kinegrade, write_class

ROOT = Path(__file__).parents[1]
OLD = ROOT / "data" / "exam-of-0.1"
BANK = """title = {{ en = "Quiz", zh = "小测" }}
course = "Mechanics"
{options}
[[questions]]
template = "slider-crank"
[[questions]]
tag = "acceleration"
[[questions]]
template = "crank.toml"
draw = {{ h = [1], r = "1 .. 5 step 1", omega = "1 .. 20 step 1" }}
"""

SHORT = """title = "Quiz"
course = "Mechanics"
[[questions]]
template = "crank.toml"
draw = { h = [1], r = "1 .. 5 step 1", omega = "1 .. 20 step 1" }
"""

ALONE = """
import atexit, sys
from kinegrade.__main__ import start
atexit.register(lambda: print(*sys.modules, file=sys.stderr))
start()
"""
# Programs and rooms of marks, worked solutions, other sheets and the writing of files
SUPERFLUOUS = re.compile(
    r"(sympy|mpmath|hypothesis|openpyxl|pikepdf|jinja2|pylatex|distributed|asyncio"
    r"|kinegrade[.](grading|marks_folder[.]folder|reports|lms|practice|proof|cycles"
    r"|students[.](mistaking[.]mistakes|separation)"
    r"|worked[.](case|document|formulas|words[.]naming)|description[.](subject|description)"
    r"|exam[.](folder[.](columns|key_decoding|key_stream|stated_keys|printed_orders)"
    r"|bank[.]own_questions|generating)"
    r"|press[.](word|latex|html|archive_page|cycle_page|typst[.](key|gallery|solution))"
    r"|problem[.](statement_faults"
    r"|template[.](library[.]stepwise|meaning[.]consistency))"
    r"|files[.](tables|output|temporary|csv_writing"
    r"|placing[.](?!readings|standing|droppings))))([.]|$)"
)


def write(folder: Path, count: int = 3, options: str = "") -> Path:
    """A class of that many, the last of whom has an odd name."""
    write_class(folder)
    (folder / "bank.toml").write_text(BANK.format(options=options), encoding="utf-8")
    rows = [f"s{number},Student {number}\n" for number in range(count - 1)]
    text = f"student,name\n{''.join(rows)}a/b,王伟\n"
    (folder / "roster.csv").write_text(text, encoding="utf-8")
    return folder


def generate(folder: Path, *options: str) -> Path:
    files = folder / "bank.toml", folder / "roster.csv"
    words = () if "--seed" in options else ("--reproducible", "spring")
    result = kinegrade("generate", *files, "-o", folder / "EXAM", "--solutions", *words, *options)
    assert result.exit_code == 0, result.stderr
    return folder / "EXAM"


def again(exam: Path, student: str, *options: str | Path) -> bytes:
    """The bytes that `kinegrade paper` prints."""
    result = kinegrade("paper", exam, student, *options)
    assert (result.exit_code, result.stderr) == (0, "")
    return result.stdout_bytes


def files(exam: Path) -> dict[str, str]:
    """The file stem of each student."""
    head = json.loads((exam / "exam.json").read_text(encoding="utf-8"))
    return {each["student"]: Path(each["file"]).stem for each in head["students"]}


def require_same(exam: Path, *students: str) -> None:
    """The papers and solutions of these students are printed again byte for byte."""
    stems = files(exam)
    assert students
    for student in students:
        assert again(exam, student) == (exam / "papers" / f"{stems[student]}.pdf").read_bytes()
        solution = (exam / "solutions" / f"{stems[student]}.pdf").read_bytes()
        assert again(exam, student, "--solution") == solution


def words(pdf: bytes) -> str:
    return " ".join(read_pages(pdf))


def refusal(*arguments: str | Path) -> str:
    result = kinegrade("paper", *arguments)
    assert (result.exit_code, result.stdout) == (2, "")
    (line,) = result.stderr.splitlines()
    return line


@pytest.fixture(scope="module")
def exam(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return generate(write(tmp_path_factory.mktemp("reprint")))


@pytest.mark.sampled(4, by="options", first=1)
@pytest.mark.parametrize(
    ("count", "bank", "options"),
    [
        (1, "", ()),
        (2, "shuffle = true", ("--paper-size", "letter", "--lang", "zh")),
        (2, "versions = 2", ("--method", "pole")),
        (1, 'engine = "latex"', ("--paper-size", "letter", "--lang", "zh")),
        (2, "", ("--seed", "random", "--share-with-group")),
    ],
)
def test_a_paper_is_printed_again_byte_for_byte(
    tmp_path: Path, count: int, bank: str, options: tuple[str, ...]
) -> None:
    exam = generate(write(tmp_path, count, bank), *options)
    require_same(exam, *files(exam))


@pytest.mark.left(beside="test_a_paper_is_printed_again_byte_for_byte")
def test_a_paper_is_printed_again_whatever_the_processes(tmp_path: Path, small_parts: int) -> None:
    folder = write(tmp_path, 2 * small_parts)
    (folder / "bank.toml").write_text(SHORT, encoding="utf-8")
    require_same(generate(folder, "--jobs", "2"), "s0", "s4", "a/b")


def test_a_paper_comes_from_the_folder_alone(exam: Path, tmp_path: Path) -> None:
    shutil.copytree(exam, tmp_path / "EXAM")
    for name in ("papers", "solutions"):
        shutil.rmtree(tmp_path / "EXAM" / name)
    assert again(tmp_path / "EXAM", "s0") == (exam / "papers" / "s0.pdf").read_bytes()


def test_a_paper_alone_loads_what_it_needs(exam: Path) -> None:
    words = ("-c", ALONE, "paper", exam, "s0", "-o", "-")
    ran = subprocess.run([sys.executable, *map(str, words)], capture_output=True, check=True)
    loaded = ran.stderr.decode().split()
    assert [name for name in loaded if SUPERFLUOUS.match(name)] == []
    assert ran.stdout == (exam / "papers" / "s0.pdf").read_bytes()


def test_a_paper_is_written_to_a_file_and_replaced_only_by_force(
    exam: Path, tmp_path: Path
) -> None:
    file = tmp_path / "s1.pdf"
    assert again(exam, "s1", "-o", file) == b""
    paper = (exam / "papers" / "s1.pdf").read_bytes()
    assert file.read_bytes() == paper
    file.write_bytes(b"mine")
    assert "already exists - expected a new file - add --force" in refusal(exam, "s1", "-o", file)
    assert file.read_bytes() == b"mine"
    assert again(exam, "s1", "-o", file, "--force") == b""
    assert file.read_bytes() == paper


def test_a_paper_of_the_folder_is_not_overwritten(exam: Path) -> None:
    before = contents(exam)
    line = refusal(exam, "s1", "-o", exam / "papers" / "s0.pdf", "--force")
    assert "is a part of the EXAM folder EXAM" in line
    assert contents(exam) == before


def test_an_id_is_found_as_rosters_compare_them(exam: Path) -> None:
    assert again(exam, " ｓ０ ") == (exam / "papers" / "s0.pdf").read_bytes()


def test_a_student_who_has_no_paper_is_refused_with_those_who_have(exam: Path) -> None:
    assert refusal(exam, "s10").endswith(
        'exam.json: no student "s10" - expected the id of a student who has a paper - '
        'did you mean "s1"? (known here: a/b, s0, s1)'
    )


def test_other_folders_are_refused(exam: Path, tmp_path: Path) -> None:
    assert "exam.json: cannot be read" in refusal(tmp_path, "s0")
    marks = tmp_path / "MARKS"
    assert kinegrade("grade", exam, exam / "answers.csv", "-o", marks).exit_code in (0, 1)
    assert "you gave MARKS where EXAM is expected" in refusal(marks, "s0")


@pytest.fixture
def changed(exam: Path, tmp_path: Path) -> Path:
    """A copy of the exam, to be changed."""
    return Path(shutil.copytree(exam, tmp_path / "EXAM"))


def replaced(file: Path, pattern: str, new: str) -> None:
    text = file.read_text(encoding="utf-8")
    other = re.sub(pattern, new, text, count=1)
    assert other != text
    file.write_text(other, encoding="utf-8")


def test_a_key_that_says_otherwise_is_refused(changed: Path) -> None:
    replaced(changed / "key.jsonl", r'"decimal": ?"-?\d', '"decimal":"123')
    lines = kinegrade("paper", changed, "s0").stderr.splitlines()
    assert any('student "s0", q1: ' in line and " by the key, but " in line for line in lines), (
        lines
    )
    assert [line for line in lines if not line.startswith("error: ")] == []


def test_a_template_that_says_otherwise_is_refused(changed: Path) -> None:
    replaced(changed / "templates" / "crank.toml", r'quantity = "([^"]*)"', r'quantity = "2*(\1)"')
    lines = kinegrade("paper", changed, "s0").stderr.splitlines()
    assert len(lines) == 1  # not as a decimal and as a double again
    assert [line for line in lines if 'key.jsonl: student "s0", q3: v_x is ' not in line] == []


@pytest.mark.parametrize(
    ("file", "pattern", "new", "said"),
    [
        ("exam.json", r'"paper": "\w', '"paper": "!', "the code is "),
        ("key.jsonl", r'"paper": ?', '"version":"Z","paper":', "the version is Z by the key, none"),
        (
            "key.jsonl",
            r'"paper": ?',
            '"printed":["q1","q3"],"paper":',
            "the questions as printed are q1, q3 by the key, q1, q2, q3 by bank.toml",
        ),
        ("exam.json", '"a4"', '"a3"', "exam.json: is broken (Invalid enum value 'a3'"),
        ("exam.json", '"typst"', '"word"', "exam.json: is broken (Invalid enum value 'word'"),
    ],
)
def test_a_folder_that_contradicts_itself_is_refused(
    changed: Path, file: str, pattern: str, new: str, said: str
) -> None:
    replaced(changed / file, pattern, new)
    assert said in refusal(changed, "s0")


def test_a_folder_of_format_1_is_printed() -> None:
    paper, solution = (words(again(OLD, "0012", *more)) for more in ((), ("--solution",)))
    head = json.loads((OLD / "exam.json").read_text(encoding="utf-8"))
    code = next(each["paper"] for each in head["students"] if each["student"] == "0012")
    assert code in paper
    assert code in solution
    assert "Resit" in paper


def test_a_name_that_no_font_prints_is_complained_of(tmp_path: Path) -> None:
    folder = write(tmp_path)
    (folder / "roster.csv").write_text("student,name\ns0,\U00012000\n", encoding="utf-8")
    result: Result = kinegrade(
        "generate", folder / "bank.toml", folder / "roster.csv", "-o", folder / "EXAM"
    )
    assert result.exit_code == 1
    reprinted = kinegrade("paper", folder / "EXAM", "s0")
    assert reprinted.exit_code == 1
    assert reprinted.stdout_bytes == (folder / "EXAM" / "papers" / "s0.pdf").read_bytes()
    (complaint,) = reprinted.stderr.splitlines()
    assert complaint in result.stderr.splitlines()


def test_a_dash_means_standard_output(small_class: Path, tmp_path: Path) -> None:
    exam = small_class / "EXAM"
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(tmp_path)
        assert again(exam, "007", "-o", "-") == (exam / "papers" / "007.pdf").read_bytes()
    assert list(tmp_path.iterdir()) == []
