"""Whoever installs kinegrade has all that it imports: nothing comes from what developers have
besides.
"""

from __future__ import annotations

import ast
import re
import sys
import tomllib
from importlib.metadata import packages_distributions
from pathlib import Path

ROOT = Path(__file__).parent.parent
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def imported(file: Path) -> set[str]:
    """The packages that a module imports, by their first names."""
    tree = ast.parse(file.read_text(encoding="utf-8"))
    nodes = list(ast.walk(tree))
    names = [alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names]
    names += [
        node.module or "" for node in nodes if isinstance(node, ast.ImportFrom) and node.level == 0
    ]
    return {name.partition(".")[0] for name in names}


def declared() -> set[str]:
    """The distributions that pyproject.toml names for users, extras included."""
    extras = PROJECT["optional-dependencies"].values()
    requirements = [*PROJECT["dependencies"], *(one for extra in extras for one in extra)]
    return {normalised(re.split(r"[\[<>=;! ]", one)[0]) for one in requirements}


def normalised(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()


def test_all_that_is_imported_is_named_in_the_project() -> None:
    ours = {*sys.stdlib_module_names, "_typeshed", "kinegrade"}
    distributions = packages_distributions()
    unnamed = {
        f"{file.relative_to(ROOT)}: {name}"
        for file in (ROOT / "kinegrade").rglob("*.py")
        for name in imported(file) - ours
        if not {normalised(each) for each in distributions.get(name, ())} & declared()
    }
    assert unnamed == set()
