"""Versions A, B, C, and papers that each have their own order: what `kinegrade generate` writes,
and `grade` marks.
"""

from __future__ import annotations

import json
import re
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

from kinegrade.exam.bank.versions import choose_version, list_version_letters
from kinegrade.language import ENGLISH, Language
from kinegrade.problem.template.library.library import list_names, load_template
from tests.printed_text import read_text
from tests.small_class import contents, generate, key_lines, kinegrade, table

BANK = """title = { en = "Midterm", zh = "期中测验" }
course = "Mechanics"
%s
[[questions]]
template = "slider-crank"
asks = { v_B = 3, omega_AB = 2 }

[[questions]]
family = "trammel"
points = 10

[[questions]]
template = "bar-through-swivelling-sleeve"
asks = { omega_AB = 3 }
"""
CLASS = [f"s{number}" for number in range(7)]


def write_exam(folder: Path, options: str, students: list[str] = CLASS, *arguments: str) -> Path:
    (folder / "bank.toml").write_text(BANK % options, encoding="utf-8")
    (folder / "roster.csv").write_text(
        "student,name\n" + "".join(f"{who},N\n" for who in students), encoding="utf-8"
    )
    result = generate(folder, f"EXAM{len(list(folder.iterdir()))}", *arguments)
    assert result.exit_code == 0, result.stderr
    assert re.search(r"q2: drawn from the bank: \S*(trammel|rod-ground)", result.stderr)
    return max(folder.glob("EXAM*"), key=lambda path: int(path.name[4:]))


def record(exam: Path) -> dict[str, Any]:
    found: dict[str, Any] = json.loads((exam / "exam.json").read_text(encoding="utf-8"))
    return found


def text_of(file: Path) -> str:
    return "".join(read_text(file).split())


def headings(line: dict[str, Any], known: str, language: Language) -> list[str]:
    """Number and title of each question as they follow on the paper, that of the answer sheet where
    it is another.
    """
    templates = {
        question["question"]: load_template(question["template"]) for question in line["questions"]
    }
    return [
        "".join(f"{number}{templates[name].about.title.in_language(language)}".split())
        + (known.format(name[1:]) if name != f"q{number}" else "")
        for number, name in enumerate(line["printed"], start=1)
    ]


@pytest.fixture(scope="module")
def versions(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_exam(tmp_path_factory.mktemp("versions"), "versions = 3")


@pytest.fixture(scope="module")
def shuffled(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_exam(tmp_path_factory.mktemp("shuffled"), "shuffle = true")


def test_versions_are_dealt_evenly_and_have_the_same_numbers(versions: Path) -> None:
    lines = key_lines(versions)
    assert sorted(Counter(line["version"] for line in lines).values()) == [2, 2, 3]
    papers = {line["version"]: line["questions"] for line in lines}
    assert sorted(papers) == record(versions)["versions"] == ["A", "B", "C"]
    assert [line for line in lines if line["questions"] != papers[line["version"]]] == []
    for one, other in (("A", "B"), ("A", "C"), ("B", "C")):
        assert [
            (mine, yours)
            for mine, yours in zip(papers[one], papers[other], strict=True)
            if mine["parameters"] == yours["parameters"]
        ] == []


def test_the_letter_stands_in_the_code_and_on_the_paper(versions: Path) -> None:
    students = record(versions)["students"]
    assert len({student["paper"] for student in students}) == len(CLASS)
    for line, student in zip(key_lines(versions), students, strict=True):
        assert (line["student"], line["paper"], line["version"]) == (
            student["student"],
            student["paper"],
            student["version"],
        )
        assert re.fullmatch(f"{student['version']}-.{{4}}-.{{4}}", student["paper"])
        text = text_of(versions / student["file"])
        assert f"Midterm·Version{student['version']}" in text
        assert student["paper"] in text


def test_the_key_shows_each_version_once(versions: Path) -> None:
    text = text_of(versions / "key.pdf")
    assert [text.count(f"Version{letter}") for letter in "ABC"] == [1, 1, 1]
    title = load_template("bar-through-swivelling-sleeve").about.title.in_language(ENGLISH)
    assert text.count("".join(f"3{title}".split())) == 3


def test_the_same_seed_gives_the_same_bytes(versions: Path, shuffled: Path, tmp_path: Path) -> None:
    assert contents(write_exam(tmp_path, "versions = 3")) == contents(versions)
    assert contents(write_exam(tmp_path, "shuffle = true")) == contents(shuffled)


def test_every_template_used_is_kept_and_the_class_shares_one_sheet(versions: Path) -> None:
    questions = record(versions)["questions"]
    assert sorted(list_names(versions / "templates")) == sorted(
        question["template"] for question in questions
    )
    assert sum(ask["points"] for ask in questions[1]["asks"]) == questions[1]["points"] == 10
    columns = [
        f"{question['question']}.{ask['ask']}" for question in questions for ask in question["asks"]
    ]
    assert list(table(versions / "answers.csv")[0]) == ["student", "name", *columns]


def test_questions_stand_in_another_order_and_keep_the_names_of_their_columns(
    shuffled: Path,
) -> None:
    lines = key_lines(shuffled)
    assert len({tuple(line["printed"]) for line in lines}) >= 3
    for line in lines:
        assert [question["question"] for question in line["questions"]] == ["q1", "q2", "q3"]
        text = text_of(shuffled / "papers" / f"{line['student']}.pdf")
        found = [text.index(heading) for heading in headings(line, "(no.{}intheanswersheet)", "en")]
        assert sorted(found) == found
        assert text.count("intheanswersheet") == sum(
            name != f"q{number}" for number, name in enumerate(line["printed"], start=1)
        )


def test_headings_in_chinese(tmp_path: Path, shuffled: Path) -> None:
    exam = write_exam(tmp_path, "shuffle = true\nversions = 2", CLASS[:2], "--lang", "zh")
    for line in key_lines(exam):
        text = text_of(exam / "papers" / f"{line['student']}.pdf")
        assert f"期中测验·{line['version']}卷" in text
        assert [
            heading for heading in headings(line, "（登分表第{}题）", "zh") if heading not in text
        ] == []


@pytest.mark.parametrize("options", ["versions = 3", "shuffle = true"])
def test_the_class_is_marked_by_its_own_papers(
    options: str, versions: Path, shuffled: Path, tmp_path: Path
) -> None:
    exam = versions if options == "versions = 3" else shuffled
    rows = []
    for line in key_lines(exam):
        values = [
            repr(ask["value"])
            for question in line["questions"]
            for ask in question["asks"].values()
        ]
        rows.append(",".join([line["student"], "N", *values]))
    head = (exam / "answers.csv").read_text(encoding="utf-8-sig").splitlines()[0]
    (tmp_path / "answers.csv").write_text("\n".join([head, *rows]) + "\n", encoding="utf-8")
    assert (
        kinegrade("grade", exam, tmp_path / "answers.csv", "-o", tmp_path / "MARKS").exit_code == 0
    )
    assert {row["percent"] for row in table(tmp_path / "MARKS" / "grades.csv")} == {"100"}


def test_everybody_who_answered_another_version_is_told(versions: Path, tmp_path: Path) -> None:
    lines = key_lines(versions)
    right = {line["version"]: line["questions"] for line in lines}
    mixed_up = [line["student"] for line in lines if line["version"] == "A"]
    rows = []
    for line in lines:
        answered = right["B" if line["version"] == "A" else line["version"]]
        values = [repr(ask["value"]) for each in answered for ask in each["asks"].values()]
        rows.append(",".join([line["student"], "N", *values]))
    head = (versions / "answers.csv").read_text(encoding="utf-8-sig").splitlines()[0]
    (tmp_path / "answers.csv").write_text("\n".join([head, *rows]) + "\n", encoding="utf-8")
    marked = kinegrade("grade", versions, tmp_path / "answers.csv", "-o", tmp_path / "MARKS")
    assert marked.exit_code == 1
    problems = [row["problem"] for row in table(tmp_path / "MARKS" / "complaints.csv")]
    assert len(mixed_up) > 1
    for student in mixed_up:
        said = f'all numbers of student "{student}" are right on the paper of student '
        assert len([each for each in problems if each.startswith(said)]) == 1
    assert len(problems) == len(mixed_up)


def test_too_few_combinations_for_the_versions_are_dealt_round(tmp_path: Path) -> None:
    (tmp_path / "roster.csv").write_text(
        "student,name\n1,Ann\n2,Bo\n3,Cy\n4,Di\n", encoding="utf-8"
    )
    (tmp_path / "bank.toml").write_text(
        'title = "T"\ncourse = "C"\nversions = 3\n[[questions]]\ntemplate = "slider-crank"\n'
        "draw = { r = [1], k = [2], phi = [30], omega = [1], alpha = [1, 2] }",
        encoding="utf-8",
    )
    result = generate(tmp_path)
    assert result.exit_code == 1
    assert (
        "q1 (slider-crank): 2 of the 2 combinations of values are fit for 3 versions, so some have "
        "the same numbers"
    ) in result.stderr
    drawn = {
        line["version"]: line["questions"][0]["drawn"] for line in key_lines(tmp_path / "EXAM")
    }
    assert drawn["A"] == drawn["C"] != drawn["B"]


def test_every_round_of_the_deal_holds_each_version_once_in_an_order_of_its_own() -> None:
    letters = list_version_letters(4)
    dealt = [choose_version("spring", place, letters) for place in range(200)]
    turns = [tuple(dealt[start : start + 4]) for start in range(0, 200, 4)]
    assert letters == ("A", "B", "C", "D")
    assert [turn for turn in turns if sorted(turn) != list(letters)] == []
    assert len(set(turns)) > 10
    assert dealt != [choose_version("autumn", place, letters) for place in range(200)]


def test_a_shipped_bank_is_generated_by_its_name(tmp_path: Path) -> None:
    (tmp_path / "roster.csv").write_text("student,name\n1,Ann\n", encoding="utf-8")
    result = kinegrade(
        "generate",
        "velocity-quiz",
        tmp_path / "roster.csv",
        "-o",
        tmp_path / "EXAM",
        "--reproducible",
        "s",
    )
    assert result.exit_code == 0
    assert sum(question["points"] for question in record(tmp_path / "EXAM")["questions"]) == 30


def test_help_names_the_shipped_banks() -> None:
    from kinegrade.problem.template.library.library import find_shipped, list_names

    names = ", ".join(list_names(find_shipped("banks")))
    assert names in " ".join(kinegrade("generate", "--help").stdout.split())
