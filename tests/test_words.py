"""No module of the program holds words of a language: all of them stand in the catalogues."""

from __future__ import annotations

import ast

import pytest

from tests.allowed_words import ALLOWED, NAMES
from tests.package_files import GROUP, locate, package_files
from tests.words import find_words

pytestmark = GROUP


@pytest.fixture(scope="module")
def found() -> list[tuple[str, int, str]]:
    """What the rules find in the package: file, line, text."""
    return [
        (locate(file), one.line, one.text)
        for file in package_files()
        for one in find_words(file.tree)
    ]


def list_allowed() -> set[tuple[str, str]]:
    """The exceptions: file, text."""
    return {
        (file, text)
        for files in ALLOWED.values()
        for file, texts in files.items()
        for text in texts
    }


def test_no_module_holds_words_of_a_language(found: list[tuple[str, int, str]]) -> None:
    allowed = list_allowed()
    said = [
        f"{file}:{line}: {text!r}"
        for file, line, text in found
        if text not in NAMES and (file, text) not in allowed
    ]
    assert said == []


def test_no_exception_is_left_without_its_text(found: list[tuple[str, int, str]]) -> None:
    assert list_allowed() - {(file, text) for file, _, text in found} == set()
    assert NAMES - {text for _, _, text in found} == set()


@pytest.mark.parametrize(
    "code",
    [
        'say("no such paper")',
        'say("没有")',
        'say("Prüfung")',
        'say(f"{count} papers")',
        'say(f"paper {code}")',
        'def say(what="not there"): ...',
        'WORDS = {"a": "not there"}',
        'raise ExamError("not there")',
        'HTML = "<p>not there</p>"',
        """HTML = '<img alt="not there"/>'""",
        r'TEX = r"\textbf{not there}"',
    ],
)
def test_words_are_found(code: str) -> None:
    assert len(list(find_words(ast.parse(code)))) == 1


@pytest.mark.parametrize(
    "code",
    [
        '"""A docstring says it."""',
        'Message("exam.no-such-paper", name=name)',
        'raise ValueError("for programmers only")',
        'raise TypeError(f"for {name} only")',
        """HTML = '<td class="wide and long">{}</td>'""",
        'TYPST = "#set text(size: 3pt)"',
        r'TEX = r"\usepackage{use as it is}"',
        r'PATTERN = r"(?P<body>\w+) slides on (?P<line>.+)"',
        'NAMES = "one two three".split()',
    ],
)
def test_code_is_passed(code: str) -> None:
    assert list(find_words(ast.parse(code))) == []
