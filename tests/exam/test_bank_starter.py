"""`kinegrade new --bank` gives a bank that is finished: every key is there, explained, and papers
can be set from it.
"""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

from kinegrade.exam.bank.bank import read_bank
from kinegrade.exam.bank.keys import (
    ANY,
    ASK,
    BANK,
    BY_HAND,
    COUNTED,
    DEALT,
    DRAWN,
    FAMILY,
    HEADER,
    NAMED,
    OWN,
    TAG,
    TEXT,
)
from kinegrade.files.starter import read_starter_text
from kinegrade.grade_scale.stated import SCALE
from kinegrade.problem.template.sections.stepwise_keys import STEPWISE
from tests.small_class import kinegrade
from tests.starters import list_keys, list_unexplained, put_in_force

STARTER = read_starter_text("kinegrade.exam.bank")
CREST = '<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><path d="M0 0H9V9Z"/></svg>'


def test_new_writes_a_bank_of_which_papers_are_set(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    result = kinegrade("new", "--bank", "midterm 2026")
    assert (result.exit_code, result.stdout) == (0, "")
    assert result.stderr == (
        "midterm 2026.toml: written; set an exam of it with: "
        "kinegrade generate midterm 2026.toml roster.csv -o EXAM\n"
    )
    (tmp_path / "roster.csv").write_text("student,name\n1001,Ada Byron\n", encoding="utf-8")
    for language in ("en", "zh"):
        exam = f"EXAM-{language}"
        made = kinegrade(
            "generate", "midterm 2026.toml", "roster.csv", "-o", exam, "--lang", language
        )
        assert made.exit_code == 0, made.stderr


def test_every_key_is_there_and_explained_in_the_line_above_it() -> None:
    keys = list_keys(STARTER)
    shown = {*keys[""], *(name for name in keys if name in BANK)}
    assert shown == set(BANK)
    assert set(keys["header"]) == set(HEADER)
    assert set(keys["scale"]) <= set(SCALE)
    assert set(keys["questions"]) == {
        *(*NAMED, *ANY, *FAMILY, *TAG, *DRAWN, *DEALT, *COUNTED),
        *(*TEXT, *BY_HAND),
        *(*OWN, *STEPWISE),
    }
    asked = tomllib.loads(STARTER)["questions"][0]["asks"].values()
    assert {key for ask in asked if isinstance(ask, dict) for key in ask} == set(ASK)
    assert list_unexplained(STARTER) == []


def test_what_is_not_in_force_is_read_where_it_is_put_in_force(tmp_path: Path) -> None:
    path = tmp_path / "bank.toml"
    everything = put_in_force(STARTER)
    assert everything.count("\n") == STARTER.count("\n")
    assert everything != STARTER
    path.write_text(everything, encoding="utf-8")
    (tmp_path / "crest.svg").write_text(CREST, encoding="utf-8")
    (tmp_path / "formulas.md").write_text("$v = \\omega r$", encoding="utf-8")
    bank = read_bank(path, "secret")
    assert (bank.versions, bank.lms, bank.header.logo != "") == (3, "canvas", True)


def test_a_bank_may_be_written_anywhere_and_is_kept_unless_forced(tmp_path: Path) -> None:
    path = tmp_path / "other.toml"
    assert kinegrade("new", "--bank", "midterm", "-o", path).exit_code == 0
    path.write_text("mine", encoding="utf-8")
    refused = kinegrade("new", "--bank", "midterm", "-o", path)
    assert refused.exit_code == 2
    assert "exists" in refused.stderr
    assert kinegrade("new", "--bank", "midterm", "-o", path, "--force").exit_code == 0
    assert path.read_text(encoding="utf-8") == STARTER


@pytest.mark.parametrize("name", ["midterm.toml", "../midterm", "-", "a/b"])
def test_a_name_is_no_path(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    result = kinegrade("new", "--bank", "--", name)
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr == (
        f"error: {name}: a starter is named by letters, digits, hyphens and spaces - "
        "give a name without folders and without .toml, and another place with -o\n"
    )
    assert list(tmp_path.iterdir()) == []


def test_one_starter_is_written_at_a_time() -> None:
    result = kinegrade("new", "--bank", "--policy", "both")
    assert result.exit_code == 2
    assert "--bank and --policy: one of them, as each is a file of its own" in result.stderr
