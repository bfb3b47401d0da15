"""The names that `import kinegrade` offers: few, typed, loaded when they are used, shadowed by
nothing.
"""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from dataclasses import fields
from importlib import import_module
from inspect import isclass, isfunction, signature
from pathlib import Path
from pkgutil import walk_packages

import click
import pytest

import kinegrade
from kinegrade.cli import main

NAMES = [name for name in kinegrade.__all__ if name != "__version__"]
FUNCTIONS = [name for name in NAMES if isfunction(getattr(kinegrade, name))]
OPTIONS: dict[str, tuple[type, set[str]]] = {
    "generate": (kinegrade.GenerateOptions, {"progress", "sheets"}),
    "grade": (kinegrade.GradeOptions, {"assuming"}),
    "export": (kinegrade.ExportOptions, set()),
    "quiz": (kinegrade.QuizOptions, {"progress"}),
    "feedback": (kinegrade.FeedbackOptions, set()),
    "exchange": (kinegrade.ExchangeOptions, {"code", "student"}),
}  # the options of each command, and those that a terminal has no use for


def test_no_module_shadows_a_public_name() -> None:
    before = {name: getattr(kinegrade, name) for name in NAMES}
    for module in walk_packages(kinegrade.__path__, "kinegrade."):
        import_module(module.name)
    assert {name: getattr(kinegrade, name) for name in NAMES} == before
    assert [name for name in NAMES if not (isfunction(before[name]) or isclass(before[name]))] == []


def test_nothing_is_loaded_before_it_is_used() -> None:
    loaded = "import sys, kinegrade; print(*(m for m in sys.modules if m.startswith('kinegrade')))"
    run = subprocess.run([sys.executable, "-c", loaded], capture_output=True, text=True, check=True)
    assert run.stdout.split() == ["kinegrade"]


def test_types_are_there_for_those_who_use_the_package() -> None:
    assert (Path(kinegrade.__file__).parent / "py.typed").is_file()


def test_a_name_that_is_not_there_is_refused_as_of_any_module() -> None:
    with pytest.raises(AttributeError, match="module 'kinegrade' has no attribute 'marks'"):
        kinegrade.marks  # noqa: B018
    assert dir(kinegrade) == sorted(kinegrade.__all__)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_function_takes_few_parameters_and_shows_a_use_and_a_refusal(name: str) -> None:
    function: Callable[..., object] = getattr(kinegrade, name)
    assert len(signature(function).parameters) <= 6
    document = str(function.__doc__)
    assert f"{name}(" in document
    assert "Traceback (most recent call last):\n    kinegrade.errors." in document


@pytest.mark.parametrize("name", OPTIONS)
def test_every_option_of_a_command_is_a_keyword_and_every_keyword_an_option(name: str) -> None:
    kind, here_only = OPTIONS[name]
    function = signature(getattr(kinegrade, name))
    offered = {
        "to" if each.name == "system" else str(each.name)
        for each in main.commands[name].params
        if isinstance(each, click.Option)
    }
    apart = {"late", "allow_odd_ids", "columns"}  # add_students, and Roster.read
    known = {*function.parameters, *(field.name for field in fields(kind))} - here_only
    positional = {"bank", "roster", "exam", "marks", "answers", "options"}
    assert offered - apart - known == set()
    assert known - offered - positional == set()
