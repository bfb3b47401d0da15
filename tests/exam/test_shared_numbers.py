"""Numbers that are not everybody's own: the same for all, or repeated where there are too few."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import pytest
from click.testing import Result

from kinegrade.exam.bank.bank import read_bank
from kinegrade.exam.setting.widening import say_how_to_widen
from kinegrade.language import ENGLISH
from kinegrade.language.sentence import write_sentence
from tests.small_class import kinegrade

HEAD = """title = "Midterm"
course = "Mechanics"
"""
COMMON = """
[[questions]]
template = "slider-crank"
asks = { v_B = 3 }
same = true
"""
OWN = """
[[questions]]
template = "slider-crank"
asks = { omega_AB = 3 }
"""
FEW = """
[[questions]]
template = "slider-crank"
asks = { v_B = 3 }
draw = { k = [2, "sqrt(3)"], phi = 30, r = 0.2, omega = 3, alpha = "5" }
"""
NAMES = ("Ada", "Emilie", "Sofya", "Lise", "Emmy")


def write_roster(path: Path, first: int, count: int) -> Path:
    """A roster of so many students, with the ids from 1001 on."""
    rows = [f"{1001 + each},{NAMES[each]}" for each in range(first, first + count)]
    path.write_text("\n".join(["student,name", *rows, ""]), encoding="utf-8")
    return path


def set_exam(folder: Path, bank: str, *options: str, count: int = 4) -> Result:
    """What `generate` says of a bank for so many students."""
    (folder / "bank.toml").write_text(HEAD + bank, encoding="utf-8")
    roster = write_roster(folder / "roster.csv", 0, count)
    return kinegrade("generate", folder / "bank.toml", roster, "-o", folder / "EXAM", *options)


def read_draws(folder: Path, question: str = "q1") -> dict[str, str]:
    """What each student of an exam was dealt for a question, by id."""
    lines = (folder / "EXAM" / "key.jsonl").read_text(encoding="utf-8").splitlines()
    return {
        line["student"]: json.dumps(each["drawn"], sort_keys=True)
        for line in map(json.loads, lines)
        for each in line["questions"]
        if each["question"] == question
    }


@pytest.mark.parametrize("versions", ["", "versions = 2\n"])
def test_everybody_may_have_the_same_numbers(tmp_path: Path, versions: str) -> None:
    made = set_exam(tmp_path, versions + OWN + COMMON)
    assert (made.exit_code, "complaint" in made.stderr) == (0, False)
    assert "q2: everybody has the same numbers" in made.stderr.splitlines()
    assert len(set(read_draws(tmp_path, "q2").values())) == 1
    assert len(set(read_draws(tmp_path, "q1").values())) == (2 if versions else 4)


def test_a_late_student_has_the_numbers_of_the_others(tmp_path: Path) -> None:
    assert set_exam(tmp_path, OWN + COMMON).exit_code == 0
    before = read_draws(tmp_path, "q2")
    late = write_roster(tmp_path / "late.csv", 4, 1)
    files = tmp_path / "bank.toml", tmp_path / "roster.csv"
    added = kinegrade("generate", *files, "-o", tmp_path / "EXAM", "--add", late)
    assert added.exit_code == 0, added.stderr
    assert "q2: everybody has the same numbers" in added.stderr
    after = read_draws(tmp_path, "q2")
    assert after == {**before, "1005": before["1001"]}
    assert read_draws(tmp_path, "q1")["1005"] not in before.values()


def test_the_same_numbers_are_marked_and_exported(tmp_path: Path) -> None:
    assert set_exam(tmp_path, COMMON).exit_code == 0
    exam = tmp_path / "EXAM"
    line = json.loads((exam / "key.jsonl").read_text(encoding="utf-8").splitlines()[0])
    right = line["questions"][0]["asks"]["v_B"]["decimal"]
    answers = tmp_path / "answers.csv"
    rows = [f"{1001 + each},{right}" for each in range(4)]
    answers.write_text("\n".join(["student,q1.v_B", *rows, ""]), encoding="utf-8")
    marks = tmp_path / "MARKS"
    marked = kinegrade("grade", exam, answers, "-o", marks)
    assert marked.exit_code == 0, marked.stderr
    with (marks / "grades.csv").open(encoding="utf-8-sig", newline="") as file:
        assert [row["total"] for row in csv.DictReader(file)] == ["3"] * 4
    shared = kinegrade("sharing", exam, marks, "-o", tmp_path / "sharing.csv")
    assert shared.exit_code == 0, shared.stderr
    assert len((tmp_path / "sharing.csv").read_text(encoding="utf-8").splitlines()) == 1
    moodle = kinegrade("export", marks, "--to", "moodle", "-o", tmp_path / "moodle.csv")
    assert moodle.exit_code == 0, moodle.stderr


def test_too_few_combinations_are_a_complaint_that_says_how_to_allow_it(tmp_path: Path) -> None:
    made = set_exam(tmp_path, FEW)
    assert made.exit_code == 1
    assert made.stderr.splitlines()[-1] == (
        "complaint: q1 (slider-crank): 2 of the 2 combinations of values are fit for 4 students, "
        "so some have the same numbers - expected one for each - state more values in the question, "
        "as in draw = { r = [...] }, or write repeats = true in the question"
    )


@pytest.mark.parametrize(
    ("entry", "advice"),
    [
        ('tag = "coriolis"', 'leave it out by without = ["{name}"]'),
        ('family = "rolling"', 'leave it out by without = ["{name}"]'),
        (
            'any = ["slider-crank", "four-bar-parallel-coupler"]',
            "put another template in its place",
        ),
    ],
)
def test_a_shipped_template_that_was_drawn_is_left_out_or_named(
    tmp_path: Path, entry: str, advice: str
) -> None:
    """Whoever drew it by a tag was told to widen the domains of a shipped template."""
    path = tmp_path / "bank.toml"
    path.write_text(f'{HEAD}[[questions]]\n{entry}\nasks = "velocity"\npoints = 6\n', "utf-8")
    (question, *_) = read_bank(path, "secret").questions
    name = question.template.name
    assert write_sentence(say_how_to_widen(question), ENGLISH) == (
        advice.format(name=name)
        + f', or make it a question of its own, template = "{name}", with more values stated by draw'
    )


@pytest.mark.parametrize(
    ("count", "said"),
    [
        (3, "q1: 2 sets of numbers for 3 students; 2 of them share theirs with somebody"),
        (2, "q1: 2 sets of numbers for 2 students; 0 of them share theirs with somebody"),
    ],
)
def test_repeats_that_the_bank_allows_are_counted(tmp_path: Path, count: int, said: str) -> None:
    made = set_exam(tmp_path, FEW + "repeats = true\n", "--strict", count=count)
    assert (made.exit_code, "complaint" in made.stderr) == (0, False)
    assert said in made.stderr.splitlines()
    assert sorted(read_draws(tmp_path)) == [str(1001 + each) for each in range(count)]


def test_one_of_the_two_is_enough(tmp_path: Path) -> None:
    made = set_exam(tmp_path, COMMON + "repeats = true\n")
    assert made.exit_code == 2
    assert made.stderr.endswith(
        ":8: questions[1].repeats: everybody has the same numbers, which leaves none to repeat "
        "- leave one of the two out\n"
    )


@pytest.mark.parametrize(
    ("draw", "fault"),
    [
        (
            "k = [0.5, 1]",
            "k: with 0.5, 1 the condition 1 < k of the template never holds - expected values like "
            "those of the template: 3/2, sqrt(3), 2, 5/2, 3",
        ),
        (
            "r = 0",
            "r: with 0 the mechanism never fits together - expected values like those of the "
            "template: 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, ...",
        ),
        ("k = true", 'k: true - expected a value, a list, or a range like "0.1 .. 0.5 step 0.05"'),
    ],
)
def test_values_that_the_template_cannot_have_are_refused(
    tmp_path: Path, draw: str, fault: str
) -> None:
    made = set_exam(tmp_path, COMMON + f"draw = {{ {draw} }}\n")
    assert made.exit_code == 2
    assert made.stderr.endswith(f"bank.toml:8: questions[1].draw.{fault}\n")


def test_a_single_value_is_the_same_on_all_papers(tmp_path: Path) -> None:
    assert set_exam(tmp_path, OWN + 'draw = { k = "sqrt(3)", phi = 30 }').exit_code == 0
    drawn = [json.loads(each) for each in read_draws(tmp_path).values()]
    assert {(each["k"], each["phi"]) for each in drawn} == {("sqrt(3)", "30")}
    assert len({each["r"] + each["omega"] for each in drawn}) > 1


ROLLING = """
[[questions]]
name = "rolling"
statement = "A wheel of radius {{ r }} rolls with {{ v }}: find $u$ and $k$."
parameters.v = { unit = "m/s", draw = [2, 3, 4] }
parameters.r = { unit = "m", draw = [1, 3] }
steps.u = "v/r"
steps.w = "2*v"
steps.k = "w/v"
asks.u = { unit = "rad/s", points = 1, means = "its angular velocity" }
asks.k = { unit = "1", points = 1, means = "the ratio of the speeds of its top and its centre" }
"""


def test_an_answer_that_all_papers_share_is_told(tmp_path: Path) -> None:
    result = set_exam(tmp_path, ROLLING, "--no-papers", count=5)
    assert result.exit_code == 1
    assert (
        "complaint: q1 (rolling): the answer to k is the same on all papers, whatever they have "
        "been dealt - ask for another quantity, or draw what it depends on from more values\n"
    ) in result.stderr
    assert "answer to u" not in result.stderr


def test_an_answer_that_few_papers_share_may_be_chance(tmp_path: Path) -> None:
    assert set_exam(tmp_path, ROLLING, "--no-papers", count=4).exit_code == 0
