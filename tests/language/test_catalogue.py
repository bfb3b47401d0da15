"""What a catalogue writes: places filled, numbers and lists as the language has them, nouns in their
forms, plurals; and what its keys in code must be.
"""

from __future__ import annotations

import pickle
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import pytest

from kinegrade.errors import BankError, FieldError, KinegradeError, suggest
from kinegrade.language import Language, entries
from kinegrade.language.catalogue import Catalogue, open_catalogue
from kinegrade.language.known import choose_terminal_language, known_languages, read_language
from kinegrade.language.message import (
    Fault,
    Message,
    Quoted,
    list_all,
    list_choices,
    list_statements,
)

HEAD = """msgid ""
msgstr ""
"Language: de\\n"
"Content-Type: text/plain; charset=utf-8\\n"
"Plural-Forms: nplurals=2; plural=(n != 1);\\n"

"""
GERMAN = {
    "language": """msgctxt "forms"
msgid "nominative"
msgstr "nominative genitive dative accusative"

msgctxt "contractions"
msgid "-"
msgstr "von dem=vom"

msgctxt "decimal-mark"
msgid "."
msgstr ","
""",
    "grammar": """msgctxt "comma"
msgid ", "
msgstr ", "

msgctxt "and"
msgid "<first> and <last>"
msgstr "<first> und <last>"
""",
    "worked": r"""#, noun
msgctxt "rod"
msgid "the rod $<name>$"
msgstr "die Stange $<name>$|der Stange $<name>$|der Stange $<name>$|die Stange $<name>$"

#, noun
msgctxt "lettered"
msgid "<body> $<letters>$"
msgstr "<body> $<letters>$|<body:genitive> $<letters>$|<body:dative> $<letters>$|<body> $<letters>$"

msgctxt "base"
msgid "The velocity $\\boldsymbol{v}_<point>$ of <body>."
msgstr "Die Geschwindigkeit $\\boldsymbol{v}_<point>$ <body:genitive>."

msgctxt "turns"
msgid "<Body> turns."
msgstr "<Body> dreht sich."

msgctxt "equations"
msgid "one equation"
msgid_plural "<count> equations"
msgstr[0] "eine Gleichung"
msgstr[1] "<count> Gleichungen"
""",
}


@pytest.fixture
def german(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Catalogue:
    """A small catalogue with the grammar of German."""
    for domain, text in GERMAN.items():
        (tmp_path / f"{domain}.po").write_text(HEAD + text, encoding="utf-8")
    monkeypatch.setattr(entries, "catalogue_folder", lambda _: tmp_path)
    return Catalogue(Language("a language of this test"))


ROD = Message("worked.rod", name="AB")


def test_a_sentence_takes_the_form_of_a_noun_that_it_needs(german: Catalogue) -> None:
    assert german.text("worked.base", point="B", body=ROD) == (
        r"Die Geschwindigkeit $\boldsymbol{v}_B$ der Stange $AB$."
    )
    assert german.text("worked.turns", body=ROD) == "Die Stange $AB$ dreht sich."


def test_a_noun_with_letters_is_declined_by_its_word(german: Catalogue) -> None:
    body = Message("worked.lettered", body=ROD, letters="l")
    assert german.text("worked.base", point="B", body=body).endswith(" der Stange $AB$ $l$.")


def test_every_noun_of_a_list_takes_the_form_that_the_sentence_needs(german: Catalogue) -> None:
    rods = list_all([ROD, Message("worked.rod", name="BC")])
    assert german.text("worked.base", point="B", body=rods).endswith(
        "der Stange $AB$ und der Stange $BC$."
    )


def test_a_list_of_nouns_and_a_number_are_written_in_the_language(german: Catalogue) -> None:
    assert german.write(list_all([ROD, "OA", "BC"])) == "die Stange $AB$, OA und BC"
    assert german.write(Decimal("0.250")) == "0,250"
    assert german.write(Fraction(5, 2)) == "2,5"


@pytest.mark.parametrize(
    ("count", "text"),
    [
        (1, "eine Gleichung"),
        (2, "2 Gleichungen"),
        (0, "0 Gleichungen"),
        (Decimal("1.5"), "1,5 Gleichungen"),
    ],
)
def test_a_number_of_things_chooses_its_text(
    german: Catalogue, count: int | Decimal, text: str
) -> None:
    assert german.text("worked.equations", count=count) == text


def test_what_fills_a_place_is_not_read_for_places(german: Catalogue) -> None:
    assert german.text("worked.turns", body="<point>") == "<point> dreht sich."


def test_an_entry_or_a_part_that_is_missing_is_a_fault_of_the_program(german: Catalogue) -> None:
    with pytest.raises(LookupError, match=r"no entry worked.none in the catalogue"):
        german.text("worked.none")
    with pytest.raises(LookupError, match=r"worked.turns is said without its part body"):
        german.text("worked.turns")


def test_a_fault_says_where_what_expected_and_what_to_do_in_each_language() -> None:
    fault = Fault("bank.toml:3: points", "0", "a number above zero", "write points = 1")
    written = {language: open_catalogue(language).write(fault) for language in known_languages()}
    assert written[Language("en")] == (
        "bank.toml:3: points: 0 - expected a number above zero - write points = 1"
    )
    assert written[Language("zh")].startswith("bank.toml:3: points: 0 - 应为")


def test_an_error_keeps_its_faults_for_any_language_through_other_processes() -> None:
    error = BankError(Fault("bank.toml", Message("grammar.unknown", name=Quoted("x"))))
    field = FieldError(Message("grammar.no-names"), "a name", suggest("x", ["y"]))
    for one in (error, field):
        again: KinegradeError = pickle.loads(pickle.dumps(one))
        assert (type(again), again.faults) == (type(one), one.faults)
        assert open_catalogue(Language("zh")).write(again.faults[0])


def test_an_unknown_language_is_refused_by_name() -> None:
    with pytest.raises(FieldError) as raised:
        read_language("zhh")
    assert str(raised.value).startswith(
        'unknown: "zhh" - expected a language with a catalogue - did you mean "zh"?'
    )


def test_the_terminal_speaks_the_language_of_the_environment() -> None:
    assert choose_terminal_language({"LANG": "zh_CN.UTF-8", "LC_ALL": "en_GB.UTF-8"}) == "en"
    assert choose_terminal_language({"LANG": "zh_CN.UTF-8", "LC_ALL": ""}) == "zh"
    assert choose_terminal_language({"LANG": "xx_XX.UTF-8"}) == "en"


def test_statements_are_separated_by_semicolons() -> None:
    statements = list_statements(["a, b", "c"])
    assert open_catalogue(Language("en")).write(statements) == "a, b; c"
    assert open_catalogue(Language("zh")).write(statements) == "a, b；c"


def test_choices_are_said_in_quotation_marks() -> None:
    english = open_catalogue(Language("en"))
    assert english.write(list_choices(map(Quoted, "abc"))) == '"a", "b" or "c"'


def test_what_to_do_is_said_however_many_places_a_fault_is_in() -> None:
    fault = Fault("points.A", "x" * 1000, "y" * 250, "narrow the domains")
    for where in ("crank", "q1", "bank.toml:3"):
        fault = Fault(where, fault)
    written = open_catalogue(Language("en")).write(fault)
    assert written.startswith("bank.toml:3: q1: crank: points.A: xxx")
    assert written.endswith("yyy - narrow the domains")
    assert "x… - expected y" in written
