"""Marking again without the policy of before says that its rules no longer hold."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.small_class import generate, kinegrade, write_class

POLICY = 'tolerance = { relative = "3 %" }\n[questions.q1]\nvoid = "drop"\n'
EARLIER = ("--since", "--never-lower")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """EXAM, and MARKS by a policy."""
    write_class(tmp_path)
    assert generate(tmp_path, "EXAM", "--no-papers").exit_code == 0
    (tmp_path / "answers.csv").write_text("student,q2.v_y\n007,4\n", encoding="utf-8")
    (tmp_path / "policy.toml").write_text(POLICY, encoding="utf-8")
    grade(tmp_path, "MARKS", "--policy", tmp_path / "policy.toml")
    return tmp_path


def grade(folder: Path, name: str, *options: str | Path) -> list[str]:
    """What is said of the policy when the class is marked into a folder."""
    files = folder / "EXAM", folder / "answers.csv", "-o", folder / name
    done = kinegrade("grade", *files, *options)
    assert done.exit_code in (0, 1), done.stderr
    return [
        line
        for line in done.stderr.splitlines()
        if "no longer hold" in line or "rules nothing" in line
    ]


def lapsed(folder: Path) -> list[str]:
    return [
        f"{folder}/MARKS/policy.toml: the marking before was by a policy (tolerance, questions);"
        " without --policy its rules no longer hold"
    ]


def test_a_policy_that_is_replaced_is_named_once(folder: Path) -> None:
    assert grade(folder, "MARKS", "--force") == lapsed(folder)
    assert grade(folder, "MARKS", "--force") == []


@pytest.mark.parametrize("earlier", EARLIER)
def test_a_policy_of_the_earlier_marking_is_named(folder: Path, earlier: str) -> None:
    reason = ("--reason", "Appeals") if earlier == "--since" else ()
    assert grade(folder, "NEW", earlier, folder / "MARKS", *reason) == lapsed(folder)


def test_a_policy_that_is_given_again_says_nothing(folder: Path) -> None:
    again = "--policy", folder / "policy.toml"
    assert grade(folder, "MARKS", "--force", *again) == []
    assert grade(folder, "NEW", "--never-lower", folder / "MARKS", *again) == []


def test_rules_that_another_policy_has_not_are_named(folder: Path) -> None:
    late = folder / "late.toml"
    late.write_text('[questions.q3.asks.omega_AB]\nvoid = "full"\n', encoding="utf-8")
    said = grade(folder, "NEW", "--policy", late, "--never-lower", folder / "MARKS")
    assert said == [
        f"{folder}/MARKS/policy.toml: the marking before had rules that {late} has not, and that "
        "no longer hold: tolerance.relative, questions.q1.void"
    ]


def test_each_accepted_answer_is_a_rule(folder: Path) -> None:
    both, one = folder / "both.toml", folder / "one.toml"
    accepted = [f'[[questions.q2.asks.v_y.accept]]\nvalue = "{each}"\n' for each in ("3", "5")]
    both.write_text("".join(accepted), encoding="utf-8")
    one.write_text(accepted[1], encoding="utf-8")
    assert len(grade(folder, "MARKS", "--force", "--policy", both)) == 1
    said = grade(folder, "MARKS", "--force", "--policy", one)
    assert len(said) == 1
    assert "questions.q2.asks.v_y.accept (value = 3)" in said[0]


def test_for_how_many_each_accepted_answer_counted_is_said(folder: Path) -> None:
    policy = folder / "both.toml"
    accepted = [f'[[questions.q2.asks.v_y.accept]]\nvalue = "{each}"\n' for each in ("97", "98")]
    policy.write_text("".join(accepted), encoding="utf-8")
    (folder / "answers.csv").write_text("student,q2.v_y\n007,97\n0012,97\n", encoding="utf-8")
    files = folder / "EXAM", folder / "answers.csv", "-o", folder / "NEW"
    said = kinegrade("grade", *files, "--policy", policy).stderr.splitlines()
    assert [line for line in said if "accepted answer" in line] == [
        'q2.v_y: accepted answer 1, "97", counted for 2 students',
        'q2.v_y: accepted answer 2, "98", counted for 0 students',
    ]


def test_a_damaged_copy_holds_no_rules(folder: Path) -> None:
    (folder / "MARKS" / "policy.toml").write_text("= 3", encoding="utf-8")
    assert grade(folder, "MARKS", "--force") == []


@pytest.mark.parametrize(
    ("text", "rules"),
    [("", False), ('# void = "drop"\n[questions.q1]\n', False), ("\ufeff" + POLICY, True)],
)
def test_a_policy_that_rules_nothing_is_said_so(folder: Path, text: str, rules: bool) -> None:
    policy = folder / "other.toml"
    policy.write_text(text, encoding="utf-8")
    nothing = f"{policy} rules nothing: answers are marked as without a policy; if it should, save"
    assert grade(folder, "NEW", "--policy", policy) == ([] if rules else [f"{nothing} it again"])
