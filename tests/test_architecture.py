"""The house stays as it is drawn: floors, siblings that do not know each other, small files, words
in two languages.
"""

from __future__ import annotations

import ast
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from graphlib import CycleError, TopologicalSorter
from pathlib import Path
from typing import get_args

import pytest

import kinegrade
from kinegrade.language import ENGLISH, Language
from kinegrade.mechanics.drivers import Driver
from kinegrade.mechanics.joints import Joint
from kinegrade.mechanics.laws import Law
from kinegrade.mechanics.relations import Kind as TermKind
from kinegrade.mechanics.vector_equation import Role
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.texts import list_lines, list_prose
from tests.package_files import GROUP, package_files

pytestmark = GROUP
PACKAGE = Path(kinegrade.__file__).parent
ROOT = PACKAGE.parent
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
LOBBY = {"kinegrade", "kinegrade.__main__"}  # the entrances, which call any floor
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
CHINESE = re.compile(r"[\u4e00-\u9fff]")


def module_name(file: Path) -> str:
    parts = file.relative_to(ROOT).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


@cache
def read_texts() -> Mapping[str, str]:
    """The modules of the package."""
    return {module_name(ROOT / file.path): file.text for file in package_files()}


@cache
def read_trees() -> Mapping[str, ast.Module]:
    """The modules of the package, parsed."""
    return {module_name(ROOT / file.path): file.tree for file in package_files()}


@cache
def list_nodes(tree: ast.AST) -> tuple[ast.AST, ...]:
    """All nodes of a tree, found once: many laws ask each of them."""
    return tuple(ast.walk(tree))


def imported(nodes: Iterable[ast.AST]) -> Iterator[str]:
    """The modules that import statements name; `from package import module` names the module."""
    for node in nodes:
        if isinstance(node, ast.Import):
            yield from (name.name for name in node.names)
        elif isinstance(node, ast.ImportFrom):
            module = node.module or ""
            for name in node.names:
                inner = f"{module}.{name.name}"
                yield inner if inner in read_trees() else module


def floor(module: str) -> str:
    return module.split(".")[1]


def edges() -> Iterator[tuple[str, str]]:
    """Who imports whom inside the package, wherever in the file."""
    for module, tree in read_trees().items():
        for target in imported(list_nodes(tree)):
            if target.startswith("kinegrade.") and not {module, target} & LOBBY:
                yield module, target


def functions(tree: ast.Module) -> Iterator[ast.FunctionDef]:
    return (node for node in list_nodes(tree) if isinstance(node, ast.FunctionDef))


def first_line(module: str, function: ast.FunctionDef) -> int:
    """Where a function begins; a command's parameters are its options, a line each, and do not
    count.
    """
    command = module.startswith("kinegrade.cli.")
    return function.body[0].lineno if command else function.lineno


def undocumented(tree: ast.Module) -> Iterator[str]:
    """Public functions, classes and methods without a docstring; what stands inside a function is
    its own business.
    """
    stack: list[ast.AST] = [tree]
    while stack:
        node = stack.pop()
        for child in ast.iter_child_nodes(node):
            if isinstance(child, ast.FunctionDef | ast.ClassDef) and not child.name.startswith("_"):
                if ast.get_docstring(child) is None:
                    yield child.name
                if isinstance(child, ast.ClassDef):
                    stack.append(child)


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


def test_a_folder_holds_at_most_twenty_files() -> None:
    folders = Counter(file.parent for file in PACKAGE.rglob("*.py"))
    assert {
        str(folder.relative_to(ROOT)) for folder, files in folders.items() if files > 20
    } == set()


def test_only_what_hands_values_to_other_processes_knows_pickle() -> None:
    """Unpickling a file runs the code of whoever wrote it."""
    knowing = {
        module
        for module, tree in read_trees().items()
        if "pickle" in set(imported(list_nodes(tree)))
    }
    assert knowing == {"kinegrade.processes.cluster", "kinegrade.processes.executor"}


def texts_without_docstrings(tree: ast.AST) -> Iterator[str]:
    """The string constants of a module, parts of f-strings too; no docstrings."""
    documented = ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef
    docstrings = {
        id(node.body[0].value)
        for node in list_nodes(tree)
        if isinstance(node, documented) and node.body and isinstance(node.body[0], ast.Expr)
    }
    for node in list_nodes(tree):
        match node:
            case ast.Constant(value=str(text)) if id(node) not in docstrings:
                yield text


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


def test_modules_are_named_for_what_they_hold() -> None:
    vague = re.compile(r"utils?|helpers?|common|managers?|misc|base|core|data|info")
    assert not [module for module in read_trees() if vague.fullmatch(module.split(".")[-1])]


def test_modules_are_small_and_documented() -> None:
    assert [name for name, text in read_texts().items() if text.count("\n") > 400] == []
    bare = [
        name
        for name, text in read_texts().items()
        if text and not ast.get_docstring(read_trees()[name])
    ]
    assert bare == []
    assert [
        (name, each) for name, tree in read_trees().items() for each in undocumented(tree)
    ] == []


def test_functions_are_short() -> None:
    assert [
        f"{name} {function.name}"
        for name, tree in read_trees().items()
        for function in functions(tree)
        if (function.end_lineno or 0) - first_line(name, function) >= 40
    ] == []


def test_modules_assert_nothing_and_change_no_names_of_others() -> None:
    odd = (ast.Assert, ast.Global, ast.Nonlocal)
    assert [
        f"{name}:{node.lineno}"
        for name, tree in read_trees().items()
        for node in list_nodes(tree)
        if isinstance(node, odd)
    ] == []


def test_no_module_runs_what_it_reads() -> None:
    assert [
        f"{name}:{node.lineno}"
        for name, tree in read_trees().items()
        for node in list_nodes(tree)
        if isinstance(node, ast.Call) and runs_anything(ast.unparse(node.func))
    ] == []


def runs_anything(called: str) -> bool:
    """Whether a call runs, prints or changes what no module may."""
    never = {"eval", "exec", "compile", "__import__", "print", "input", "breakpoint"}
    return called in never or called.endswith((".eval", ".system", ".popen", ".chdir"))


def test_what_runs_anything_is_seen() -> None:
    assert runs_anything("eval")
    assert runs_anything("os.system")
    assert not runs_anything("re.compile")


@pytest.mark.parametrize("name", find_template_names())
def test_every_sentence_of_a_template_is_there_in_both_languages(name: str) -> None:
    template = load_template(name)
    for _, text in (*list_lines(template), *list_prose(template)):
        english, chinese = text.in_language(ENGLISH), text.in_language(Language("zh"))
        assert english.strip()
        assert CHINESE.search(chinese), chinese
        assert not CHINESE.search(english), english


@pytest.mark.parametrize("name", find_template_names())
def test_no_two_sentences_of_a_template_say_the_same(name: str) -> None:
    template = load_template(name)
    for language in ("en", "zh"):
        for parts in (template.parameters, template.asks):
            sentences = [part.means.in_language(language) for part in parts.values()]  # type: ignore[attr-defined]
            assert len(set(sentences)) == len(sentences)


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
