"""`kinegrade solutions`: worked solutions of an exam that exists, as `generate --solutions` would
have written them.
"""

from __future__ import annotations

import os
import shutil
import stat
from collections.abc import Callable
from pathlib import Path

import pytest
from pypdf import PdfReader

from tests.small_class import contents, generate, kinegrade, write_class

Damage = Callable[[Path], None]
SHORT = """title = "Quiz"
course = "Mechanics"

[[questions]]
template = "crank.toml"
draw = { h = [0], r = [1, 2, 3], omega = [2, 3, 4] }
asks = { v_y = 1 }
"""


@pytest.fixture(scope="module")
def solved(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    """The files of the small exam when it is generated with worked solutions."""
    folder = write_class(tmp_path_factory.mktemp("solved"))
    assert generate(folder, "EXAM", "--solutions").exit_code == 0
    return contents(folder / "EXAM")


@pytest.fixture
def exam(small_class: Path, tmp_path: Path) -> Path:
    """The same exam without them."""
    return Path(shutil.copytree(small_class / "EXAM", tmp_path / "EXAM"))


def write_one(folder: Path) -> Path:
    """The small class with one student."""
    write_class(folder)
    (folder / "roster.csv").write_text("student,name\n007,Ann\n", encoding="utf-8")
    return folder


@pytest.fixture(scope="module")
def plain(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The class of one student and its EXAM without worked solutions."""
    folder = write_one(tmp_path_factory.mktemp("plain"))
    assert generate(folder).exit_code == 0
    return folder


@pytest.fixture
def single(plain: Path, tmp_path: Path) -> Path:
    """A copy of that exam, the files of its class beside it."""
    return Path(shutil.copytree(plain, tmp_path / "single")) / "EXAM"


@pytest.fixture(scope="module")
def typeset(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """One paper of one question that LaTeX sets, with its worked solution."""
    folder = write_one(tmp_path_factory.mktemp("typeset"))
    (folder / "bank.toml").write_text(SHORT, encoding="utf-8")
    assert generate(folder, "EXAM", "--solutions", "--engine", "latex").exit_code == 0
    return folder


def refusal(exam: Path, *options: str) -> str:
    """The one line of a refusal, after which the folder is as it was."""
    before = contents(exam)
    result = kinegrade("solutions", exam, *options)
    assert (result.exit_code, result.stdout) == (2, "")
    assert contents(exam) == before
    assert [entry.name for entry in exam.parent.iterdir()] == ["EXAM"]
    (line,) = result.stderr.splitlines()
    return line


def test_all_are_those_of_generate_byte_for_byte(solved: dict[str, bytes], exam: Path) -> None:
    result = kinegrade("solutions", exam)
    assert (result.exit_code, result.stdout) == (0, "")
    assert "EXAM: the worked solutions of 4 papers; kinegrade feedback " in result.stderr
    assert contents(exam) == solved


def test_those_of_spare_papers_are_among_them(tmp_path: Path) -> None:
    folder = write_one(tmp_path)
    (folder / "bank.toml").write_text(SHORT, encoding="utf-8")
    for name, *options in (("SOLVED", "--solutions"), ("EXAM",)):
        assert generate(folder, name, "--spare", "2", *options).exit_code == 0
    exam = folder / "EXAM"
    shutil.copytree(exam, folder / "SINGLY")
    result = kinegrade("solutions", exam)
    assert "EXAM: the worked solutions of 3 papers; kinegrade feedback " in result.stderr
    assert contents(exam) == contents(folder / "SOLVED")
    for name in ("spare-2", "007", "spare-1"):
        assert kinegrade("solutions", folder / "SINGLY", name).exit_code == 0
    assert contents(folder / "SINGLY") == contents(folder / "SOLVED")
    again = kinegrade("solutions", folder / "SINGLY", "spare-1")
    assert "solutions of 1 student already (spare-1)" in again.stderr


@pytest.mark.left(beside="test_all_are_those_of_generate_byte_for_byte")
def test_several_processes_write_the_same(tmp_path: Path, small_parts: int) -> None:
    folder = write_class(tmp_path)
    rows = [f"s{number},Student {number}\n" for number in range(2 * small_parts)]
    (folder / "roster.csv").write_text(f"student,name\n{''.join(rows)}", encoding="utf-8")
    (folder / "bank.toml").write_text(SHORT, encoding="utf-8")
    assert generate(folder, "ONE", "--no-papers").exit_code == 0
    shutil.copytree(folder / "ONE", folder / "TWO")
    assert kinegrade("solutions", folder / "ONE", "--jobs", "1").exit_code == 0
    assert kinegrade("solutions", folder / "TWO", "--jobs", "2").exit_code == 0
    assert contents(folder / "TWO") == contents(folder / "ONE")


@pytest.mark.sampled(2, by="options")
@pytest.mark.parametrize(
    "options", [("--lang", "zh", "--paper-size", "letter"), ("--method", "pole", "--cycle")]
)
def test_they_are_printed_as_the_papers_were(tmp_path: Path, options: tuple[str, ...]) -> None:
    folder = write_one(tmp_path)
    assert generate(folder, "WITH", "--solutions", *options).exit_code == 0
    assert generate(folder, "LATER", *options).exit_code == 0
    assert kinegrade("solutions", folder / "LATER").exit_code == 0
    assert contents(folder / "LATER") == contents(folder / "WITH")


@pytest.mark.left(beside="test_all_are_those_of_generate_byte_for_byte")
@pytest.mark.needs_tex
def test_latex_prints_them_as_it_did_the_papers(typeset: Path, tmp_path: Path) -> None:
    shutil.copytree(typeset, tmp_path, dirs_exist_ok=True)
    assert generate(tmp_path, "LATER", "--engine", "latex").exit_code == 0
    assert kinegrade("solutions", tmp_path / "LATER").exit_code == 0
    assert contents(tmp_path / "LATER") == contents(typeset / "EXAM")


@pytest.mark.sampled(2, by="manner")
@pytest.mark.parametrize("manner", [("--method", "pole"), ("--cycle",)])
def test_a_manner_of_its_own_is_kept_for_what_is_printed_again(
    single: Path, manner: tuple[str, ...]
) -> None:
    assert generate(single.parent, "WITH", "--solutions", *manner).exit_code == 0
    assert kinegrade("solutions", single, *manner).exit_code == 0
    assert contents(single) == contents(single.parent / "WITH")


@pytest.mark.left(beside="test_they_are_printed_as_the_papers_were")
def test_the_bank_may_ask_for_graphs_over_the_cycle(tmp_path: Path) -> None:
    folder = write_one(tmp_path)
    bank = folder / "bank.toml"
    bank.write_text(f"cycle = true\n{bank.read_text(encoding='utf-8')}", encoding="utf-8")
    assert generate(folder, "WITH", "--solutions").exit_code == 0
    assert generate(folder, "LATER").exit_code == 0
    assert kinegrade("solutions", folder / "LATER").exit_code == 0
    assert contents(folder / "LATER") == contents(folder / "WITH")
    solution = tmp_path / "007.pdf"
    again = kinegrade("paper", folder / "WITH", "007", "--solution", "-o", solution)
    assert again.exit_code == 0, again.stderr
    assert solution.read_bytes() == (folder / "WITH" / "solutions" / "007.pdf").read_bytes()
    pages = (page.extract_text() for page in PdfReader(solution).pages)
    assert any("Over the whole cycle" in text for text in pages), pages


def test_a_language_for_all_takes_the_place_of_that_of_the_papers(single: Path) -> None:
    chinese, name = single.parent / "CHINESE", "solutions/007.pdf"
    assert generate(single.parent, chinese.name, "--solutions", "--lang", "zh").exit_code == 0
    assert kinegrade("solutions", single, "--lang", "zh").exit_code == 0
    assert (single / name).read_bytes() == (chinese / name).read_bytes()


def test_a_language_that_the_exam_lacks_is_refused(exam: Path) -> None:
    result = kinegrade("solutions", exam, "--lang", "de")
    assert (result.exit_code, (exam / "solutions").exists()) == (2, False)
    assert 'bank: no text in "de" (title, course) - expected' in result.stderr


def test_those_of_one_student_are_the_same_and_the_rest_may_follow(
    solved: dict[str, bytes], exam: Path
) -> None:
    before = contents(exam)
    assert kinegrade("solutions", exam, "a/b", " ００７ ", "007").exit_code == 0
    after = contents(exam)
    names = {"solutions/007.pdf", "solutions/a%2Fb.pdf"}
    assert after.keys() - before.keys() == {*names, "solutions.pdf"}
    assert {name: after[name] for name in before} == before
    assert {name: after[name] for name in names} == {name: solved[name] for name in names}
    single = [len(PdfReader(exam / name).pages) for name in sorted(names)]
    pages = len(PdfReader(exam / "solutions.pdf").pages)
    assert pages == sum(count + count % 2 for count in single)
    assert kinegrade("solutions", exam, "0012", "=2").exit_code == 0
    assert contents(exam) == solved


def test_students_who_have_no_paper_are_refused_with_the_nearest(exam: Path) -> None:
    assert refusal(exam, "0013").endswith(
        'exam.json: no student "0013" - expected the id of a student who has a paper - '
        'did you mean "0012"? (known here: 0012, 007, =2, a/b)'
    )
    result = kinegrade("solutions", exam, "0013", "007", "nobody")
    assert [line.split(": ")[2] for line in result.stderr.splitlines()] == [
        'no student "0013" - expected the id of a student who has a paper - did you mean "0012"? '
        "(known here",
        'no student "nobody" - expected the id of a student who has a paper - known here',
    ]


def test_nothing_is_overwritten_in_silence(solved: dict[str, bytes], exam: Path) -> None:
    assert kinegrade("solutions", exam, "007").exit_code == 0
    (exam / "solutions" / "007.pdf").write_bytes(
        (exam / "solutions" / "007.pdf").read_bytes() + b"% mine"
    )
    assert refusal(exam).endswith(
        "EXAM/solutions: has the worked solutions of 1 student already (007) - expected students "
        "who have none - name the students who have none, or add --force to replace them"
    )
    assert "has the worked solutions of 1 student already (007)" in refusal(exam, "007", "0012")
    assert kinegrade("solutions", exam, "0012").exit_code == 0
    assert kinegrade("solutions", exam, "--force").exit_code == 0
    assert contents(exam) == solved


def test_one_student_gets_no_other_method_than_the_rest(exam: Path) -> None:
    assert refusal(exam, "007", "--method", "pole").endswith(
        "--method: is not the one of the exam's other worked solutions - expected one method for "
        "the whole class - name no students, or leave it out"
    )
    assert refusal(exam, "007", "--cycle").endswith(
        "--cycle: the exam's other worked solutions have no graphs over the cycle - expected graphs "
        "for the whole class - name no students, or leave it out"
    )


@pytest.mark.left(beside="test_nothing_is_overwritten_in_silence")
@pytest.mark.needs_tex
def test_an_edited_source_is_not_overwritten(typeset: Path, tmp_path: Path) -> None:
    exam = Path(shutil.copytree(typeset / "EXAM", tmp_path / "EXAM"))
    source = exam / "tex" / "solutions" / "007.tex"
    source.write_text(source.read_text(encoding="utf-8") + "% mine\n", encoding="utf-8")
    before = contents(exam)
    result = kinegrade("solutions", exam, "--force")
    assert result.exit_code == 2
    assert "EXAM: holds tex/solutions/007.tex, edited or added since" in result.stderr
    assert contents(exam) == before


def test_answers_typed_into_the_exam_stay(exam: Path) -> None:
    sheet = exam / "answers.csv"
    sheet.write_text(sheet.read_text(encoding="utf-8-sig") + "x,y,1\n", encoding="utf-8")
    typed = sheet.read_bytes()
    assert kinegrade("solutions", exam, "007").exit_code == 0
    assert sheet.read_bytes() == typed


@pytest.mark.skipif(os.name != "posix", reason="modes of POSIX")
def test_they_are_as_closed_to_others_as_the_exam(exam: Path) -> None:
    exam.chmod(0o750)
    assert kinegrade("solutions", exam, "007").exit_code == 0
    found = (exam, exam / "solutions", exam / "solutions" / "007.pdf", exam / "solutions.pdf")
    assert [stat.S_IMODE(each.stat().st_mode) for each in found] == [0o750, 0o750, 0o640, 0o640]


def _lose_templates(exam: Path) -> None:
    shutil.rmtree(exam / "templates")


def _lose_bank(exam: Path) -> None:
    (exam / "bank.toml").unlink()


def _change_template(exam: Path) -> None:
    template = exam / "templates" / "crank.toml"
    text = template.read_text(encoding="utf-8")
    template.write_text(text.replace('quantity = "y(', 'quantity = "2*y('), encoding="utf-8")


def _lose_line(exam: Path) -> None:
    lines = (exam / "key.jsonl").read_bytes().splitlines(keepends=True)
    (exam / "key.jsonl").write_bytes(b"".join(lines[1:]))


@pytest.mark.parametrize(
    ("damage", "said"),
    [
        (_lose_templates, 'no template "slider-crank"'),
        (_lose_bank, "bank.toml: cannot be read"),
        (_lose_line, 'key.jsonl: no line for student "007" - expected one - restore'),
        (_change_template, 'key.jsonl: student "007", q2: v_y is '),
    ],
)
def test_a_damaged_exam_is_refused(exam: Path, damage: Damage, said: str, tmp_path: Path) -> None:
    damage(exam)
    before = contents(tmp_path)
    result = kinegrade("solutions", exam)
    assert (result.exit_code, result.stdout) == (2, "")
    lines = result.stderr.splitlines()
    assert [line for line in lines if not line.startswith("error: ")] == []
    assert said in lines[0]
    assert contents(tmp_path) == before


def test_late_students_get_theirs_where_the_others_have_them(single: Path) -> None:
    late = single.parent / "late.csv"
    late.write_text("student,name\nlate,Li\n", encoding="utf-8")
    assert kinegrade("solutions", single).exit_code == 0
    files = single.parent / "bank.toml", single.parent / "roster.csv", "-o", single, "--add", late
    assert kinegrade("generate", *files).exit_code == 0
    assert (single / "solutions" / "late.pdf").is_file()


def test_feedback_hands_them_out(single: Path) -> None:
    marks, out = single.parent / "MARKS", single.parent / "FEEDBACK"
    assert kinegrade("grade", single, single / "answers.csv", "-o", marks).exit_code == 0
    wanted = ("feedback", single, marks, "-o", out, "--format", "md", "--solutions")
    refused = kinegrade(*wanted)
    assert refused.exit_code == 2
    assert "write them with kinegrade solutions EXAM, or leave them out" in refused.stderr
    assert kinegrade("solutions", single).exit_code == 0
    assert kinegrade(*wanted).exit_code == 0
    (solution,) = (out / "sheets").glob("*-solution.pdf")
    assert solution.read_bytes() == (single / "solutions" / "007.pdf").read_bytes()
