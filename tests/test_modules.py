"""Modules are small, documented and named for what they hold; functions are short and run nothing
that they read.
"""

from __future__ import annotations

import ast
import re
from collections import Counter
from collections.abc import Iterator

from tests.package_files import GROUP
from tests.package_trees import PACKAGE, ROOT, list_nodes, read_texts, read_trees

pytestmark = GROUP


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


def test_a_folder_holds_at_most_twenty_files() -> None:
    folders = Counter(file.parent for file in PACKAGE.rglob("*.py"))
    assert {
        str(folder.relative_to(ROOT)) for folder, files in folders.items() if files > 20
    } == set()


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
