"""`kinegrade new --policy` gives a policy that is finished: every key is there, explained, and any
exam can be marked by it.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.files.starter import read_starter_text
from kinegrade.grade_scale.stated import SCALE
from kinegrade.grading.lateness.reading import LATE, TRIES
from kinegrade.grading.policy.keys import ACCEPTED, ASK, POLICY, QUESTION
from kinegrade.grading.policy.reading import read_policy
from tests.small_class import kinegrade
from tests.starters import list_keys, list_unexplained, put_in_force

TEXT = read_starter_text("kinegrade.grading.policy")
BANK = """title = "Midterm"
course = "Mechanics"
[[questions]]
template = "slider-crank"
asks = { v_B = 3 }
"""


@pytest.fixture
def exam(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An exam of one question for one student, in the current folder."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bank.toml").write_text(BANK, encoding="utf-8")
    (tmp_path / "roster.csv").write_text("student,name\n1001,Ada Byron\n", encoding="utf-8")
    made = kinegrade("generate", "bank.toml", "roster.csv", "-o", "EXAM")
    assert made.exit_code == 0, made.stderr
    return tmp_path / "EXAM"


def test_new_writes_a_policy_by_which_a_class_is_marked(exam: Path) -> None:
    result = kinegrade("new", "--policy", "milder")
    assert (result.exit_code, result.stdout) == (0, "")
    assert result.stderr == (
        "milder.toml: written; mark by it with: "
        "kinegrade grade EXAM answers.csv -o MARKS --policy milder.toml\n"
    )
    marked = kinegrade(
        "grade", exam, exam / "answers.csv", "-o", "MARKS", "--policy", "milder.toml"
    )
    assert marked.exit_code == 0, marked.stderr


def test_every_key_is_there_and_explained_in_the_line_above_it() -> None:
    keys = list_keys(TEXT)
    assert {*keys[""], "questions", "scale", "late", "tries"} == set(POLICY)
    assert {*keys["scale"], *list_keys(read_starter_text("kinegrade.exam.bank"))["scale"]} == {
        *SCALE
    }
    assert set(keys["late"]) == set(LATE)
    assert set(keys["tries"]) == set(TRIES)
    assert {*keys["questions.q1"], "asks"} == set(QUESTION)
    assert {*keys["questions.q1.asks.v_B"], "accept"} == set(ASK)
    assert set(keys["questions.q1.asks.v_B.accept"]) == set(ACCEPTED)
    assert list_unexplained(TEXT) == []


def test_what_is_not_in_force_is_read_where_it_is_put_in_force(exam: Path) -> None:
    path = exam.parent / "policy.toml"
    path.write_text(put_in_force(TEXT), encoding="utf-8")
    policy = read_policy(path, open_exam(exam))
    assert policy.scale is not None
    assert list(policy.scale.grades) == ["A", "B", "C", "D"]
    assert policy.penalties.late is not None
    assert set(policy.penalties.late.extensions) == {"1001"}
    ruling = policy.rulings["q1.v_B"]
    assert (ruling.points, ruling.void, len(ruling.accepted)) == (4, "full", 1)
