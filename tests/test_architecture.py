"""The house stays as it is drawn: floors, siblings that do not know each other, small files, words
in two languages.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from graphlib import CycleError, TopologicalSorter
from pathlib import Path
from typing import get_args

import pytest

from kinegrade.mechanics.drivers import Driver
from kinegrade.mechanics.joints import Joint
from kinegrade.mechanics.laws import Law
from kinegrade.mechanics.relations.terms import Kind as TermKind
from kinegrade.mechanics.vector_equation import Role
from tests.package_files import GROUP
from tests.package_trees import (
    LOBBY,
    ROOT,
    edges,
    floor,
    imported,
    list_nodes,
    read_trees,
    texts_without_docstrings,
)

pytestmark = GROUP
FLOORS = {
    "ask_names": 0,
    "deadlines": 0,
    "errors": 0,
    "expressions": 0,
    "files": 0,
    "grade_scale": 0,
    "language": 0,
    "marks_folder": 0,
    "numbers": 0,
    "processes": 0,
    "question_numbers": 0,
    "round_numbers": 0,
    "sign_conventions": 0,
    "stated_marking": 0,
    "mechanics": 1,
    "motion": 2,
    "problem": 3,
    "students": 4,
    "figure": 5,
    "draws": 6,
    "worked": 7,
    "choosing": 8,
    "cycles": 8,
    "description": 8,
    "press": 9,
    "proof": 9,
    "exam": 10,
    "grading": 11,
    "practice": 12,
    "reports": 12,
    "lms": 13,
    "public": 14,
    "preview": 15,
    "cli": 16,
}
# Messages are below the errors that hold them, all else in language/ is above these
INSIDE = {"kinegrade.errors": "kinegrade.language.errors"}
SIBLINGS = ("figure", "grading", "lms")
GRADING_MAY_USE = {
    "kinegrade.exam.keyed_exam",
    "kinegrade.exam.value_dimension",
    "kinegrade.exam.roster.known_columns",
    "kinegrade.exam.roster.student_ids",
    "kinegrade.exam.roster.student_names",
    "kinegrade.exam.roster.students",
}
EXAM_FOLDER = "kinegrade.exam.folder."
FLINT = {"expressions", "numbers", "problem", "students"}
DIRECT_TEXT = (".py", ".toml", ".typ", ".md", ".csv", ".json", ".jsonl", ".yml", ".txt")


def test_every_module_has_a_floor() -> None:
    assert {floor(module) for module in read_trees() if module not in LOBBY} == set(FLOORS)


def test_imports_are_seen_wherever_they_stand() -> None:
    seen = set(edges())
    assert ("kinegrade.exam.setting.setting", "kinegrade.draws.draw_filter") in seen
    assert ("kinegrade.cli.marks", "kinegrade.reports.comparison") in seen  # inside a function
    assert ("kinegrade.public.marking", "kinegrade.lms.grades.moodle") in seen  # from a package


def test_a_file_imports_only_from_its_own_floor_and_those_below() -> None:
    assert [edge for edge in edges() if FLOORS[floor(edge[0])] < FLOORS[floor(edge[1])]] == []


def test_figure_grading_and_lms_do_not_know_each_other() -> None:
    assert not [
        edge
        for edge in edges()
        if floor(edge[0]) != floor(edge[1]) and {floor(edge[0]), floor(edge[1])} <= set(SIBLINGS)
    ]


def test_grading_uses_of_setting_nothing_but_the_exam_folder_the_roster_and_its_ids() -> None:
    below = {
        target
        for module, target in edges()
        if floor(module) == "grading" and floor(target) != "grading"
    }
    above = {target for target in below if FLOORS[floor(target)]}
    assert {target for target in above if not target.startswith(EXAM_FOLDER)} <= GRADING_MAY_USE


def test_the_exam_folder_knows_of_setting_nothing_but_the_roster_and_alternatives() -> None:
    below = {
        target
        for module, target in edges()
        if module.startswith(EXAM_FOLDER) and not target.startswith(EXAM_FOLDER)
    }
    assert {target for target in below if floor(target) == "exam"} == {
        "kinegrade.exam.choices",
        "kinegrade.exam.roster.students",
    }
    assert not {target for target in below if FLOORS[floor(target)] > FLOORS["exam"]}


def test_a_template_and_its_mechanics_know_nothing_of_exams() -> None:
    assert not [
        edge
        for edge in edges()
        if floor(edge[0]) in ("numbers", "mechanics") and FLOORS[floor(edge[1])] > 1
    ]


def test_nobody_imports_the_command_line() -> None:
    assert not [edge for edge in edges() if floor(edge[1]) == "cli" != floor(edge[0])]


def find_neighbours(importing: str, target: str) -> tuple[str, str, str] | None:
    """The folder in which the ways to two modules part, and what they go through there; None for a
    package and what is in it.
    """
    ways = [INSIDE.get(module, module).split(".") for module in (importing, target)]
    for place, (above, below) in enumerate(zip(*ways, strict=False)):
        if above != below:
            return ".".join(ways[0][:place]), above, below
    return None


def test_no_file_and_no_room_imports_itself_by_way_of_others() -> None:
    """In every folder the files and the rooms stand one above the other, whatever imports late or
    for types alone.
    """
    graphs: dict[str, dict[str, set[str]]] = {}
    for importing, target in edges():
        neighbours = find_neighbours(importing, target)
        if neighbours:
            folder, above, below = neighbours
            graphs.setdefault(folder, {}).setdefault(above, set()).add(below)
    for folder, graph in graphs.items():
        try:
            TopologicalSorter(graph).prepare()
        except CycleError as error:
            pytest.fail(f"{folder}: a cycle of imports: {' <- '.join(error.args[1])}")


def list_asked_classes(tree: ast.Module) -> Iterator[str]:
    """The names of the classes that a module asks for: by `isinstance`, or in a pattern."""
    for node in list_nodes(tree):
        if isinstance(node, ast.MatchClass):
            yield ast.unparse(node.cls)
    yield from list_tested_classes(tree)


def list_compared_texts(tree: ast.AST) -> Iterator[str]:
    """The texts that a module compares something with: by an operator, in a set, or in a pattern."""
    compared = ast.Compare | ast.MatchValue | ast.Set
    for node in list_nodes(tree):
        if isinstance(node, compared):
            yield from texts_without_docstrings(node)


def test_a_joint_that_is_asked_for_by_its_name_is_seen_in_every_form() -> None:
    asked = 'a.kind == "roll"; "pin" in kinds; kinds & {"mesh"}'
    matched = 'match kind:\n    case "contact" | "sleeve":\n        ...'
    assert set(list_compared_texts(ast.parse(asked))) == {"roll", "pin", "mesh"}
    assert set(list_compared_texts(ast.parse(matched))) == {"contact", "sleeve"}


def test_no_module_compares_anything_with_the_name_of_a_joint_or_driver() -> None:
    other_words = {*get_args(TermKind), *get_args(Role)}  # they mean a term of a vector equation
    names = {part.__name__.lower() for kinds in (Joint, Driver) for part in get_args(kinds)}
    assert {"pin", "mesh", "circulation"} <= names - other_words
    found = {name: set(list_compared_texts(tree)) & names for name, tree in read_trees().items()}
    assert {name: words - other_words for name, words in found.items() if words - other_words} == {}


def list_tested_classes(tree: ast.Module) -> Iterator[str]:
    """The names of the classes that a module asks for by `isinstance`, where nothing makes it
    consider the others.
    """
    for node in list_nodes(tree):
        if isinstance(node, ast.Call) and ast.unparse(node.func) == "isinstance":
            yield from (part.id for part in ast.walk(node.args[1]) if isinstance(part, ast.Name))


def test_only_mechanics_tests_for_a_law_others_match_all_or_ask_it() -> None:
    laws = {law.__name__ for law in get_args(Law)} | {"Law", "Condition", "Imposed"}
    assert {"NoSlip", "EqualRotation", "ImposedMotion"} <= laws
    found = {
        module: laws & set(list_tested_classes(tree))
        for module, tree in read_trees().items()
        if not module.startswith("kinegrade.mechanics")
    }
    assert {module: asked for module, asked in found.items() if asked} == {}


def test_no_module_asks_which_joint_or_driver_it_has_but_those_that_draw_or_describe_it() -> None:
    rooms = (
        "kinegrade.mechanics.joints",
        "kinegrade.mechanics.drivers",
        "kinegrade.figure.joints",
        "kinegrade.description.",
    )
    parts = {part.__name__ for kinds in (Joint, Driver) for part in get_args(kinds)}
    assert {"Pin", "Mesh", "Rotation"} <= parts
    found = {module: parts & set(list_asked_classes(tree)) for module, tree in read_trees().items()}
    joints = {part.__name__ for part in get_args(Joint)}
    assert found["kinegrade.figure.joints.table"] == joints
    assert found["kinegrade.description.joints"] == joints
    assert {
        name: asked for name, asked in found.items() if asked and not name.startswith(rooms)
    } == {}


def test_only_the_arithmetic_knows_the_library_of_numbers() -> None:
    libraries = {
        module: {name.split(".")[0] for name in imported(list_nodes(tree))}
        for module, tree in read_trees().items()
    }
    assert {floor(module) for module, names in libraries.items() if "flint" in names} <= FLINT
    assert {module for module, names in libraries.items() if "sympy" in names} == {
        "kinegrade.numbers.symbolic"
    }
    assert not set().union(*libraries.values()) & {"mpmath", "scipy", "pandas"}


def test_markdown_is_read_in_one_place_and_each_typesetter_has_its_room() -> None:
    rooms = {
        "markdown_it": "kinegrade.language.prose",
        "mdit_py_plugins": "kinegrade.language.prose",
        "typst": "kinegrade.press.typst",
        "pylatex": "kinegrade.press.latex",
    }
    used = {
        (name.split(".")[0], module)
        for module, tree in read_trees().items()
        for name in imported(list_nodes(tree))
        if name.split(".")[0] in rooms
    }
    assert {library for library, _ in used} == rooms.keys()
    assert not [use for use in used if not use[1].startswith(f"{rooms[use[0]]}.")]


def test_only_what_hands_values_to_other_processes_knows_pickle() -> None:
    """Unpickling a file runs the code of whoever wrote it."""
    knowing = {
        module
        for module, tree in read_trees().items()
        if "pickle" in set(imported(list_nodes(tree)))
    }
    assert knowing == {"kinegrade.processes.cluster", "kinegrade.processes.executor"}


def test_only_one_package_knows_the_files_of_a_marks_folder() -> None:
    files = ("grades.csv", "marks.csv", "complaints.csv", "printed.csv", "kept.csv", "variants.csv")
    knowing = {
        module
        for module, tree in read_trees().items()
        for text in texts_without_docstrings(tree)
        if any(file in text for file in files)
    }
    assert knowing == {"kinegrade.marks_folder.layout"}


def test_only_one_module_starts_programs() -> None:
    starting = {
        module
        for module, tree in read_trees().items()
        if "subprocess" in set(imported(list_nodes(tree)))
    }
    assert starting == {"kinegrade.press.program_run"}


def written_texts(tree: ast.Module) -> Iterator[str]:
    """The texts that a module works with; docstrings are not among them."""
    prose = {
        id(node.value)
        for node in list_nodes(tree)
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
    }
    for node in list_nodes(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in prose:
            yield node.value


def test_only_the_exam_folder_knows_what_its_files_are_called() -> None:
    files = ("exam.json", "key.jsonl", "variants.jsonl")
    knowing = {
        module
        for module, tree in read_trees().items()
        if any(file in text for text in written_texts(tree) for file in files)
    }
    assert knowing == {"kinegrade.exam.folder.contents"}


def test_no_file_knows_the_machine_it_was_written_on() -> None:
    places = re.compile("/(?:" + "|".join(("work", "root", "home", "Users", "tmp")) + r")/\w")
    folders = ("kinegrade", "templates", "banks", "tests", "benchmarks", ".ci")
    files = [file for folder in folders for file in (ROOT / folder).rglob("*") if file.is_file()]
    # A worktree's own pointer
    files += [file for file in ROOT.iterdir() if file.is_file() and file.name != ".git"]
    named = {
        str(file.relative_to(ROOT))
        for file in files
        if "__pycache__" not in file.parts
        and (file.suffix in DIRECT_TEXT or not file.suffix)
        and places.search(text_of(file))
    }
    assert not named


def text_of(file: Path) -> str:
    return file.read_text(encoding="utf-8", errors="replace")
