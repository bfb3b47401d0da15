"""Every command on the pages that people read runs, in order, and shows what the page says."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from kinegrade.cli import main
from tests.docs.pages import (
    DOCS,
    ROOT,
    Change,
    Command,
    File,
    Program,
    Step,
    find_earlier,
    fits,
    list_pages,
    parse_steps,
    read_steps,
    take,
)

pytestmark = pytest.mark.xdist_group("docs")  # one worker sets the tutorial's exam, once


@pytest.fixture(scope="module")
def left(tmp_path_factory: pytest.TempPathFactory) -> dict[Path, Path]:
    """The folders that pages left behind, for those that continue them."""
    return {}


def follow(page: Path, folder: Path, left: dict[Path, Path]) -> str:
    """Follow a page in a folder; what went wrong."""
    earlier = find_earlier(page)
    if page.parent == ROOT:  # these begin in a copy of the source
        shutil.copytree(ROOT / "banks", folder / "banks")
    if earlier is not None:
        shutil.copytree(left[earlier.resolve()], folder, dirs_exist_ok=True)
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        patch.setenv("LC_ALL", "C")
        names: dict[str, object] = {}
        faults = [do(step, folder, names) for step in read_steps(page)]
    left[page.resolve()] = folder
    return "\n".join(fault for fault in faults if fault)


def do(step: Step, folder: Path, names: dict[str, object]) -> str:
    """Do what a step of a page says; what is wrong, or nothing. `names` are its program's."""
    if not isinstance(step, Program):
        return take(step, folder)
    exec(step.text, names)
    return ""


def in_order(pages: list[Path]) -> list[Path]:
    """Pages that others continue come first."""
    return sorted(pages, key=lambda page: find_earlier(page) is not None)


@pytest.mark.sampled(3, first=1, by="page")
@pytest.mark.parametrize(
    "page", [pytest.param(page, id=page.stem) for page in in_order(list_pages())]
)
def test_what_a_page_says_can_be_done(page: Path, tmp_path: Path, left: dict[Path, Path]) -> None:
    earlier = find_earlier(page)
    if earlier is not None and earlier.resolve() not in left:
        before = tmp_path / "before"
        before.mkdir()
        assert follow(earlier.resolve(), before, left) == ""
    folder = tmp_path / "here"
    folder.mkdir()
    assert follow(page, folder, left) == ""


def test_the_pages_show_every_command() -> None:
    steps = [step for page in list_pages() for step in read_steps(page)]
    lines = [step.line.split() for step in steps if isinstance(step, Command)]
    assert {line[1] for line in lines if line[0] == "kinegrade"} >= set(main.commands)


def test_the_program_of_the_readme_gives_what_it_says() -> None:
    (program,) = (step for step in read_steps(ROOT / "README.md") if isinstance(step, Program))
    names: dict[str, object] = {}
    exec(program.text, names)
    assert names["answers"]["v_B"].exact == "2*sqrt(3)/15"  # type: ignore[index]


def test_a_page_is_read_as_people_read_it() -> None:
    text = """Write
```{code-block} csv
:caption: roster.csv

student,name
```
and run
```diff
 student,name
+1,A
```
```sh
kinegrade generate a b \\
  -o EXAM  # an exam
```
or
```console
$ kinegrade list
one
...
$ kinegrade show one
```
```toml
kinegrade = "no command"
```
```python
import kinegrade
```
"""
    assert list(parse_steps(text)) == [
        File("roster.csv", "student,name\n"),
        Change("roster.csv", "student,name\n", "student,name\n1,A\n"),
        Command("kinegrade generate a b    -o EXAM  # an exam"),
        Command("kinegrade list", ("one", "...")),
        Command("kinegrade show one", ()),
        Program("import kinegrade\n"),
    ]


@pytest.mark.parametrize(
    ("shown", "output", "same"),
    [
        (["a", "b"], ["a", "b"], True),
        (["a"], ["a", "b"], False),
        (["a", "...", "d"], ["a", "b", "c", "d"], True),
        (["a", "...", "d"], ["a", "d"], True),
        (["...", "d"], ["a", "e"], False),
        (["a", "..."], ["b", "a"], False),
    ],
)
def test_shown_lines_are_compared(shown: list[str], output: list[str], same: bool) -> None:
    assert fits(shown, output) is same


@pytest.mark.parametrize(
    "step",
    [
        Command("kinegrade list", ("nothing",)),
        Command("kinegrade show no-such-template"),
        Command("kinegrade show slider-crank", ("complaint: none",)),
        Command("false"),
    ],
)
def test_a_page_that_says_something_else_is_noticed(step: Command, tmp_path: Path) -> None:
    assert take(step, tmp_path) != ""


@pytest.mark.parametrize(("before", "fault"), [("a\n", ""), ("b\n", "x: "), ("a\na\n", "x: ")])
def test_a_change_of_lines_that_are_not_there_is_noticed(
    before: str, fault: str, tmp_path: Path
) -> None:
    (tmp_path / "x").write_text(before, encoding="utf-8")
    assert take(Change("x", "a\n", "c\n"), tmp_path).startswith(fault)
    assert (tmp_path / "x").read_text("utf-8") == (before if fault else "c\n")


def test_pages_are_found() -> None:
    pages = list_pages()
    assert ROOT / "README.md" in pages
    assert DOCS / "tutorial" / "first-exam.md" in pages
    assert not [page for page in pages if page.parent.name == "reference"]
