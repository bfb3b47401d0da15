"""`kinegrade words` lists what the readers read: every word of their tables, and sentences and
calls that they accept.
"""

from __future__ import annotations

import itertools
import re
import tomllib
from typing import Any

import pytest

from kinegrade.expressions.reading import read_expression
from kinegrade.expressions.tree import Call, walk
from kinegrade.language import ENGLISH
from kinegrade.language.known import known_languages
from kinegrade.mechanics.branches import BRANCHES
from kinegrade.mechanics.drivers import DRIVERS
from kinegrade.mechanics.joints import JOINTS
from kinegrade.numbers.units import SCALES, SHORT, read_unit
from kinegrade.problem.quantities.functions import QUANTITIES
from kinegrade.problem.template.hints import SHAPES
from kinegrade.problem.template.sections import keys
from kinegrade.problem.template.sections.key_examples import KEY_EXAMPLES
from kinegrade.problem.template.sentences import read_driver, read_joint
from kinegrade.problem.template.tags import TAGS
from kinegrade.problem.vocabulary import (
    GROUPS,
    describe_group,
    list_names,
    list_sections,
    write_meaning,
)
from kinegrade.sign_conventions import CONVENTIONS
from tests.small_class import kinegrade

FILLED = {
    "POINT": "A",
    "BODY": "OA",
    "LINE": "line(O, 0)",
    "CIRCLE": "circle(C, r)",
    "ANGLE": "pi/3",
    "...": "CD",
}
ALTERNATIVES = {
    "LINE|CIRCLE": ("LINE", "CIRCLE"),
    "open|crossed": ("open", "crossed"),
    "+x|-x|+y|-y|ANGLE": ("+x", "-y", "ANGLE"),
    "translates|turns with BODY": ("translates", "turns with BODY"),
}


def spell_out(form: str) -> list[str]:
    """The sentences of a form: with and without what is in brackets, for each alternative."""
    forms = [form]
    for written, meant in ALTERNATIVES.items():
        forms = [each.replace(written, one) for each in forms for one in meant]
    parts = [re.split(r"( \[[^]]*\])", each) for each in forms]
    choices = [
        [("", part) if part.startswith(" [") else (part,) for part in each] for each in parts
    ]
    spelled = ["".join(picked) for each in choices for picked in itertools.product(*each)]
    return sorted({fill_in(re.sub(r"[\[\]]", "", each)) for each in spelled})


def fill_in(form: str) -> str:
    return " ".join(
        FILLED.get(word.rstrip(",:"), word.rstrip(",:")) + word[len(word.rstrip(",:")) :]
        for word in form.split()
    )


@pytest.mark.parametrize("kind", [*JOINTS, *DRIVERS], ids=lambda kind: kind.__name__)
def test_a_form_says_all_that_the_pattern_reads_and_nothing_else(kind: Any) -> None:
    matches = [re.fullmatch(kind.PATTERN, each) for each in spell_out(kind.FORM)]
    assert None not in matches, spell_out(kind.FORM)
    given = {name for each in matches if each for name, value in each.groupdict().items() if value}
    assert given == set(re.compile(kind.PATTERN).groupindex)


@pytest.mark.parametrize("kind", JOINTS)
def test_the_examples_of_a_joint_are_read_as_that_joint(kind: Any) -> None:
    assert {read_joint(example).stated for example in kind.EXAMPLES} == {kind}


@pytest.mark.parametrize("kind", DRIVERS)
def test_the_examples_of_an_input_are_read_as_that_input(kind: Any) -> None:
    v, a = read_expression("v"), read_expression("a")
    assert {read_driver(example, v, a).stated for example in kind.EXAMPLES} == {kind}


@pytest.mark.parametrize("name", QUANTITIES)
def test_the_example_of_a_function_calls_it_with_what_it_takes(name: str) -> None:
    signature = QUANTITIES[name]
    tree = read_expression(signature.example)
    (call,) = (part for part in walk(tree) if isinstance(part, Call) and part.function == name)
    assert signature.needed <= len(call.arguments) <= len(signature.slots)


TABLES = {
    "parameter": keys.PARAMETER,
    "input": keys.INPUT,
    "ask": keys.ASK,
    "published": keys.PUBLISHED,
}


def test_every_key_and_every_side_has_an_example() -> None:
    assert {table: tuple(each) for table, each in KEY_EXAMPLES.items()} == {
        **TABLES,
        "branch": BRANCHES,
    }


@pytest.mark.parametrize("table", TABLES)
def test_the_example_of_a_key_is_an_entry_in_which_it_stands(table: str) -> None:
    for key, example in KEY_EXAMPLES[table].items():
        entry = tomllib.loads(example)
        [written] = entry.values()
        assert key in (written if table in ("parameter", "ask") else entry)
        if table in ("parameter", "ask"):
            assert set(written) <= set(TABLES[table])
            read_unit(written["unit"])
        if table == "ask":
            read_expression(written["quantity"])
            assert written.get("sign", "ccw") in CONVENTIONS


@pytest.mark.parametrize("side", BRANCHES)
def test_the_example_of_a_side_is_a_point_on_it(side: str) -> None:
    tree = read_expression(KEY_EXAMPLES["branch"][side])
    assert isinstance(tree, Call)
    assert tree.function == "meet"
    assert side in str(tree.arguments[-1])


def list_words() -> set[str]:
    sections = [section for group in GROUPS for section in list_sections(group)]
    return {word.text for section in sections for word in section.words}


def test_every_word_of_the_tables_is_listed() -> None:
    tables = [table for name, table in vars(keys).items() if name.isupper()]
    known = {word for table in tables if isinstance(table, tuple) for word in table}
    assert keys.FIGURE_EXAMPLES.keys() == set(keys.FIGURE)
    functions = {each.usage(name) for name, each in QUANTITIES.items()}
    known |= {*functions, *BRANCHES, *SHAPES, *SCALES, *SHORT, *TAGS, *CONVENTIONS}
    known |= {kind.FORM for kind in (*JOINTS, *DRIVERS)}
    assert known - list_words() == set()


@pytest.mark.parametrize("language", known_languages())
@pytest.mark.parametrize("group", GROUPS)
def test_every_word_has_a_meaning_in_every_language(group: Any, language: Any) -> None:
    for section in list_sections(group):
        assert write_meaning(section.title, language)
        for word in section.words:
            meaning = write_meaning(word.meaning, language)
            assert meaning


def test_words_without_a_group_names_the_groups() -> None:
    result = kinegrade("words", "--lang", "en")
    assert result.exit_code == 0
    lines = dict(line.split("  ", 1) for line in result.stdout.splitlines())
    assert {name.strip() for name in lines} == set(GROUPS)
    assert result.stdout.count(write_meaning(describe_group("units"), ENGLISH)) == 1


def test_words_of_a_group_are_shown_with_meaning_and_examples() -> None:
    result = kinegrade("words", "joints", "--lang", "de")
    assert (
        "  POINT of BODY slides on LINE [of BODY]\n"
        "    Ein Schieber auf einer geraden Führung, oder ein Stift in einem geraden\n"
        "    Schlitz.\n"
        "    | B of AB slides on line(O, 0)\n"
    ) in result.stdout


def test_a_group_that_there_is_not_is_refused() -> None:
    result = kinegrade("words", "joins")
    assert result.exit_code == 2
    assert "'joins' is not one of 'template', 'parameters', 'points', 'joints'" in result.stderr


def test_a_group_is_found_by_its_singular() -> None:
    assert kinegrade("words", "joint").stdout == kinegrade("words", "joints").stdout != ""


@pytest.mark.parametrize("name", ["Gelenke", "gelenke", "铰链", "运动副", "joint"])
def test_a_group_is_found_by_its_name_in_any_language(name: str) -> None:
    result = kinegrade("words", name, "--lang", "en")
    assert result.exit_code == 0, result.output
    assert result.output == kinegrade("words", "joints", "--lang", "en").output


def test_groups_are_named_in_the_language_of_their_list() -> None:
    assert "joints      Gelenke: Die Sätze" in kinegrade("words", "--lang", "de").output
    assert "joints      The sentences" in kinegrade("words", "--lang", "en").output


def test_no_two_groups_share_a_name() -> None:
    names = [
        name.casefold()
        for group in GROUPS
        for name in {each for lang in known_languages() for each in list_names(group, lang)}
    ]
    assert len(names) == len(set(names))
