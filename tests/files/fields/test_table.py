"""A file is read key by key; all its faults are reported at once, with place and line."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest

from kinegrade.errors import BankError, JsonError
from kinegrade.files.fields.document import Document, FileKind, json_table, read_text, toml_table
from kinegrade.files.fields.faults import Faults
from kinegrade.files.fields.json_text import read_json
from kinegrade.files.fields.place import Place
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import amount, choice, date_text, flag, share, text, whole
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue

KIND = FileKind("a bank file", BankError, 100)
RESTORED = FileKind("an exam's head", BankError, 100, "restore it")


def toml(content: str) -> Table:
    return toml_table("bank.toml", content, KIND)


def faults(table: Table) -> tuple[str, ...]:
    with pytest.raises(BankError) as caught:
        table.faults.require_none()
    return caught.value.problems


def test_values_are_read_exactly() -> None:
    table = toml(
        'title = "Quiz"\nshuffle = true\nnumber = 3\npoints = 2.50\nleast = "0.1"\n'
        'part = 0.1\nper = "12.5 %"\nratio = "1/3"\nengine = "latex"\nday = 2026-05-01\n'
        "list = [1, 2]"
    )
    assert table.required("title", text) == "Quiz"
    assert table.with_default("shuffle", flag, False) is True
    assert table.required("number", whole(1, 3)) == 3
    assert table.required("points", amount) == Fraction(5, 2)
    assert table.required("least", amount) == Fraction(1, 10)
    assert table.required("part", share) == Fraction(1, 10)
    assert table.required("per", share) == Fraction(1, 8)
    assert table.required("ratio", share) == Fraction(1, 3)
    assert table.required("engine", choice(("typst", "latex"))) == "latex"
    assert table.required("day", date_text) == "2026-05-01"
    assert table.listing("list", whole(0, 9)) == (1, 2)
    assert table.optional("none", text) is None
    assert table.with_default("none", text, "as ever") == "as ever"
    table.faults.require_none()


def test_all_faults_stand_in_the_order_of_the_file_with_their_lines() -> None:
    table = toml(
        'shuffle = "yes"\n\n[tolerance]\nfigures = 7\nsize = 1\n'
        "[[questions]]\nnumber = 0\n[[questions]]\nwithout = [\n  'a',\n  3,\n]\n"
        "[[questions]]\nasks = 3\n"
    )
    for question in table.tables("questions"):
        question.only("number", "without", "asks")
        question.optional("number", whole(1, 50))
        question.listing("without", text)
        if "asks" in question:
            question.table("asks", "{ v_B = 3 }").require(["never"])
    tolerance = table.table("tolerance").only("relative", "figures")
    tolerance.required("figures", whole(2, 6))
    tolerance.required("relative", share)
    table.optional("shuffle", flag)
    table.required("title", text)
    assert faults(table) == (
        'bank.toml: title: missing - expected a text in quotation marks, "..."',
        'bank.toml:1: shuffle: "yes" - expected true or false',
        f"bank.toml:3: tolerance.relative: missing - expected {SHARE}",
        "bank.toml:4: tolerance.figures: 7 - expected a whole number from 2 to 6",
        "bank.toml:5: tolerance.size: unknown key - known here: figures, relative",
        "bank.toml:7: questions[1].number: 0 - expected a whole number from 1 to 50",
        'bank.toml:11: questions[2].without[2]: 3 - expected a text in quotation marks, "..."',
        "bank.toml:14: questions[3].asks: 3 - expected a table like { v_B = 3 }",
    )


def test_a_missing_key_under_a_misspelt_one_is_one_fault() -> None:
    table = toml('titel = "Quiz"').only("title", "course")
    table.required("title", text)
    table.require(["course"])
    assert faults(table) == (
        "bank.toml: course: missing",
        'bank.toml:1: titel: unknown key - did you mean "title"? (known here: course, title)',
    )


AMOUNT = "a number of zero or more like 2.5, at most 9 digits before the point and 12 after it"
SHARE = 'a share from 0 to 1, like 0.5, "50 %" or "1/2"'


@pytest.mark.parametrize(
    ("value", "read", "problem"),
    [
        ("3", text, '3 - expected a text in quotation marks, "..."'),
        ("3.5", text, '3.5 - expected a text in quotation marks, "..."'),
        ('" "', text, '" " - expected a text in quotation marks, "..."'),
        ("1", flag, "1 - expected true or false"),
        ("true", whole(0, 1), "true - expected a whole number from 0 to 1"),
        ("1.0", whole(0, 1), "1.0 - expected a whole number from 0 to 1"),
        ("nan", amount, f"nan - expected {AMOUNT}"),
        ("-1", amount, f"-1 - expected {AMOUNT}"),
        ("1e999999999", amount, f"1e999999999 - expected {AMOUNT}"),
        ("1234567890", amount, f"1234567890 - expected {AMOUNT}"),
        ("0.1234567890123", amount, f"0.1234567890123 - expected {AMOUNT}"),
        ("true", amount, f"true - expected {AMOUNT}"),
        ("{}", amount, f"a table - expected {AMOUNT}"),
        ("inf", share, f"inf - expected {SHARE}"),
        ('"101 %"', share, f'"101 %" - expected {SHARE}'),
        ('"1/0"', share, f'"1/0" - expected {SHARE}'),
        ('"٣ %"', share, f'"٣ %" - expected {SHARE}'),
        ("[]", choice(("a", "b")), "a list - expected a or b"),
        ("3", date_text, '3 - expected a text or a date, like "spring 2026" or 2026-05-01'),
        (
            "10:00:00",
            date_text,
            '10:00:00 - expected a text or a date, like "spring 2026" or 2026-05-01',
        ),
        (f'"{"x" * 200}\\n"', flag, f'"{"x" * 79}…" - expected true or false'),
    ],
)
def test_a_value_of_another_kind_is_refused(value: str, read: object, problem: str) -> None:
    table = toml(f"key = {value}")
    assert table.required("key", read) is None  # type: ignore[arg-type]
    assert faults(table) == (f"bank.toml:1: key: {problem}",)


def test_lists_and_tables_of_another_kind_are_refused() -> None:
    table = toml("list = 1\ntables = [1]\nnames = { a = 1, b = {} }")
    assert table.listing("list", text) == ()
    assert [list(entry) for entry in table.tables("tables", "{ a = 1 }")] == [[]]
    assert list(table.table("names").each_table()) == ["a", "b"]
    assert table.table("names").entries(whole(0, 1)) == {"a": 1}
    assert faults(table) == (
        "bank.toml:1: list: 1 - expected a list",
        "bank.toml:2: tables[1]: 1 - expected a table like { a = 1 }",
        "bank.toml:3: names.a: 1 - expected a table",
        "bank.toml:3: names.b: a table - expected a whole number from 0 to 1",
    )


def test_json_is_read_alike() -> None:
    table = json_table("exam.json", '{"format": 2,\n"students": [\n{"name": null}]}', RESTORED)
    table.required("format", whole(1, 1))
    for student in table.tables("students"):
        student.required("name", text)
        student.required("student", text)
    assert faults(table) == (
        "exam.json:1: format: 2 - expected a whole number from 1 to 1 - restore it",
        'exam.json:3: students[1].name: nothing - expected a text in quotation marks, "..." '
        "- restore it",
        'exam.json:3: students[1].student: missing - expected a text in quotation marks, "..." '
        "- restore it",
    )


@pytest.mark.parametrize(
    ("content", "line", "problem"),
    [
        ('{"a":\n}', 2, "broken JSON (Expecting value)"),
        ('{"a": 1,\n"a": 2}', None, '"a" stands twice in one object: leave one of the two out'),
        ('{"a": NaN}', None, "NaN is no number"),
        ("[" * 40 + "]" * 40, None, "nested too deeply: write it more simply"),
        ("[" * 100_000, None, "nested too deeply: write it more simply"),
        ("[" + "9" * 61 + "]", None, "a whole number of more than 60 digits: round it"),
        ("9" * 5000, None, "a whole number of more than 60 digits: round it"),
    ],
)
def test_what_is_no_json_is_refused_with_its_line(
    content: str, line: int | None, problem: str
) -> None:
    with pytest.raises(JsonError) as caught:
        read_json(content)
    assert (caught.value.line, str(caught.value)) == (line, problem)


@pytest.mark.parametrize(
    ("content", "problem"),
    [
        ("[]", "exam.json: a list - expected one JSON object - restore it"),
        (
            "{\n1",
            "exam.json:2: broken JSON (Expecting property name enclosed in double quotes) "
            "- expected an exam's head in JSON - restore it",
        ),
    ],
)
def test_what_is_no_object_is_refused(content: str, problem: str) -> None:
    with pytest.raises(BankError) as caught:
        json_table("exam.json", content, RESTORED)
    assert str(caught.value) == problem


def test_a_file_that_cannot_be_opened_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "bank.toml"
    for content, problem in (
        (
            None,
            "cannot be read (No such file or directory) - expected a bank file - check the name",
        ),
        (b"#" * 101, "too large - expected a bank file of at most 100 bytes - check the name"),
        (b"\xff", "not UTF-8 at byte 0 - expected a bank file in UTF-8 - fix it"),
    ):
        if content is not None:
            file.write_bytes(content)
        with pytest.raises(BankError) as caught:
            read_text(file, KIND)
        assert str(caught.value) == f"{file}: {problem}"
    file.write_bytes(b"\xef\xbb\xbfa = 1")
    assert read_text(file, KIND) == "a = 1"


def test_lines_are_looked_for_once_and_only_where_there_is_a_fault() -> None:
    searched: list[str] = []

    def find_lines(content: str) -> dict[Place, int]:
        searched.append(content)
        return {("b",): 2, ("a",): 1}

    document = Document("bank.toml", "a = 1\nb = 2", find_lines)
    table = Table(Faults(document, BankError), (), {"a": 1, "b": 2})
    assert table.required("a", whole(1, 1)) == 1
    table.faults.require_none()
    assert searched == []
    table.required("b", flag)
    table.required("a", flag)
    assert faults(table) == (
        "bank.toml:1: a: 1 - expected true or false",
        "bank.toml:2: b: 2 - expected true or false",
    )
    assert searched == ["a = 1\nb = 2"]


def test_what_was_found_and_expected_is_said_in_the_language_that_is_asked_for() -> None:
    table = toml("list = {}\nflag = [1]")
    table.listing("list", text, "[1, 2]")
    table.required("flag", flag)
    faults = table.faults.raised().faults
    assert [open_catalogue(Language("zh")).write(fault) for fault in faults] == [
        "bank.toml:1: list: 表 - 应为形如 [1, 2] 的列表",
        "bank.toml:2: flag: 列表 - 应为true 或 false",
    ]
