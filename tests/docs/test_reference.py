"""The reference says what the readers read: every word of their tables, and examples that they
accept.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from docs.generator.banks import write_bank_page, write_policy_page
from docs.generator.commands import write_commands
from docs.generator.described import read_constants, read_words
from docs.generator.folders import write_folder_page
from docs.generator.pages import PAGES, write_reference
from docs.generator.python import write_python_page
from docs.generator.templates import (
    write_expression_page,
    write_shipped_page,
    write_template_page,
)
from kinegrade.cli import main
from kinegrade.exam.bank import keys as bank_keys
from kinegrade.exam.bank.bank import read_bank
from kinegrade.exam.folder.contents import CONTENTS
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.grade_scale import stated as stated_scale
from kinegrade.grading.lateness import reading as lateness
from kinegrade.grading.policy import keys as policy_keys
from kinegrade.grading.policy.reading import read_policy
from kinegrade.language import ENGLISH
from kinegrade.marks_folder.layout import FILES
from kinegrade.problem.template.sections import stepwise_keys
from kinegrade.problem.vocabulary import GROUPS, list_sections, write_meaning
from kinegrade.reports.term import plan as term_plan
from tests.small_class import generate, write_class

TABLES = [
    ("kinegrade.exam.bank.keys", bank_keys, "BANK NAMED ANY FAMILY TAG DRAWN DEALT"),
    ("kinegrade.exam.bank.keys", bank_keys, "COUNTED TEXT BY_HAND ASK"),
    ("kinegrade.exam.bank.keys", bank_keys, "OWN OWN_ASK"),
    ("kinegrade.problem.template.sections.stepwise_keys", stepwise_keys, "STEPWISE"),
    (
        "kinegrade.problem.template.sections.stepwise_keys",
        stepwise_keys,
        "STEPWISE_PARAMETER STEPWISE_ASK STEPWISE_MISTAKE",
    ),
    ("kinegrade.grading.policy.keys", policy_keys, "POLICY QUESTION ASK ACCEPTED"),
    ("kinegrade.grade_scale.stated", stated_scale, "SCALE"),
    ("kinegrade.reports.term.plan", term_plan, "PLAN PART"),
    ("kinegrade.grading.lateness.reading", lateness, "LATE TRIES"),
]


@pytest.mark.parametrize(
    ("module", "table", "name"),
    [(module, table, name) for module, table, names in TABLES for name in names.split()],
)
def test_every_key_that_is_read_is_described(module: str, table: object, name: str) -> None:
    described = read_words(module, name)
    assert tuple(described) == getattr(table, name)
    assert [meaning for meaning in described.values() if not meaning.endswith(".")] == []


def test_a_word_without_a_description_is_noticed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "bare_table.py").write_text(
        'KEYS = (\n    #: What it is.\n    "title",\n    "course",\n)\n', encoding="utf-8"
    )
    monkeypatch.syspath_prepend(tmp_path)
    with pytest.raises(KeyError):
        read_words("bare_table", "KEYS")
    assert read_constants("bare_table") == {}


def test_the_reference_is_written_whole(tmp_path: Path) -> None:
    write_reference(tmp_path)
    assert {page.stem for page in tmp_path.glob("*.md")} == set(PAGES)
    for page in tmp_path.glob("*.md"):
        text = page.read_text(encoding="utf-8")
        assert text.startswith("# ")
        rows = [line for line in text.splitlines() if line.startswith("| ")]
        assert [row for row in rows if not re.search(r"(?<!\\)\| (?! *\|)", row)] == []


def test_the_commands_are_all_there_with_their_options() -> None:
    page = write_commands()
    for name, command in main.commands.items():
        (section,) = re.findall(rf"^## {name}\n(.*?)(?=^## |\Z)", page, re.MULTILINE | re.DOTALL)
        options = {name for each in command.params for name in each.opts if name.startswith("-")}
        assert {name for name in options if name not in section} == set()


def test_the_pages_of_templates_have_all_words_with_their_meanings_and_examples() -> None:
    pages = (write_template_page() + write_expression_page() + write_shipped_page()).replace(
        "\\|", "|"
    )
    for group in GROUPS:
        for word in (word for section in list_sections(group) for word in section.words):
            meaning = " ".join(write_meaning(word.meaning, ENGLISH).split())
            assert f"| `{word.text}` | {meaning} |" in pages
            assert [each for each in word.examples if f"`{each}`" not in pages] == []


def test_the_files_of_exams_and_marks_are_all_there() -> None:
    page = write_folder_page()
    translations = {name for name in CONTENTS if re.fullmatch(r"bank\.\w+\.toml", name)}
    assert translations
    named = {*CONTENTS, *FILES} - translations
    assert {name for name in named if f"`{name}`" not in page} == set()


def test_the_examples_of_a_bank_and_a_policy_are_read(tmp_path: Path) -> None:
    (tmp_path / "example.toml").write_text(first_block(write_bank_page()), encoding="utf-8")
    bank = read_bank(tmp_path / "example.toml", "any")
    assert len(bank.questions) == 3
    write_class(tmp_path)
    assert generate(tmp_path).exit_code == 0
    exam = open_exam(tmp_path / "EXAM")
    policy = first_block(write_policy_page()).replace(
        "questions.q2.asks.v_B", "questions.q1.asks.v_B"
    )
    policy = policy.replace('[questions.q1]\nvoid = "drop"\n', "")
    (tmp_path / "policy.toml").write_text(policy, encoding="utf-8")
    read = read_policy(tmp_path / "policy.toml", exam)
    assert read.attempts == "best"


def first_block(page: str) -> str:
    return re.findall(r"^```toml\n(.*?)^```", page, re.MULTILINE | re.DOTALL)[0]


def test_the_page_of_python_says_what_is_given_back_and_how_a_problem_is_solved() -> None:
    page = write_python_page()
    assert "grade(\n    exam: ExamFolder," in page
    assert "    options: GradeOptions = GradeOptions(),\n) -> Graded\n" in page
    assert "template(...).solve(\n    **values: str | int | float,\n) -> Solution\n" in page
    assert "`.decimal(digits)`" in page
