"""kinegrade without its source: a wheel, made of the source archive, is installed into an empty
environment, and the tutorial is followed there, in an empty place, with processes of its own.

No network is needed: the environment sees the dependencies that the tests run with, by a line of a
.pth file, which adds their folder to the path and runs nothing in it. So kinegrade as it is
installed there, editable and pointing at this source, is not seen.
"""

from __future__ import annotations

import os
import subprocess
import sys
import sysconfig
import tarfile
import zipfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from kinegrade import __version__
from tests.docs.pages import (
    DOCS,
    INSTALLING,
    ROOT,
    Command,
    Program,
    list_pages,
    read_steps,
    run,
    take,
)

pytestmark = pytest.mark.xdist_group("installing")
PACKED = ("kinegrade", "templates", "banks", "tests", "benchmarks", "docs")
OURS = {"kinegrade/templates": "templates", "kinegrade/banks": "banks", "kinegrade": "kinegrade"}


def call(*arguments: str | Path, folder: Path = ROOT) -> None:
    """Run Python with these arguments. Fails with what it says."""
    ran = subprocess.run(
        [sys.executable, *map(str, arguments)],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
    )
    assert ran.returncode == 0, ran.stdout + ran.stderr


def list_files(folder: Path) -> Iterator[str]:
    """The files that belong to a folder, by their paths in it."""
    for file in folder.rglob("*"):
        name = file.relative_to(folder).as_posix()
        written = folder == DOCS and name.startswith("reference/") and name != "reference/index.md"
        if file.is_file() and "__pycache__" not in file.parts and not written:
            yield name


@pytest.fixture(scope="module")
def archive(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("archive")
    call("-m", "hatchling", "build", "--target", "sdist", "--directory", folder)
    return folder / f"kinegrade-{__version__}.tar.gz"


@pytest.fixture(scope="module")
def wheel(archive: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("wheel")
    offline = ("--no-index", "--no-deps", "--no-build-isolation")
    call("-m", "pip", "wheel", "--quiet", *offline, "--wheel-dir", folder, archive, folder=folder)
    return folder / f"kinegrade-{__version__}-py3-none-any.whl"


@pytest.fixture(scope="module")
def installed(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of programs of an environment with nothing but the wheel in it."""
    home = tmp_path_factory.mktemp("home") / "venv"
    call("-m", "venv", "--without-pip", home)
    scheme = {"base": str(home), "platbase": str(home)}
    packages = Path(sysconfig.get_path("purelib", "venv", vars=scheme))
    (packages / "dependencies.pth").write_text(f"{sysconfig.get_path('purelib')}\n", "utf-8")
    programs = Path(sysconfig.get_path("scripts", "venv", vars=scheme))
    quietly = ("install", "--quiet", "--no-index", "--no-deps")
    call("-m", "pip", "--python", programs / "python", *quietly, wheel)
    return programs


@pytest.fixture
def elsewhere(installed: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """An empty folder, from which the programs of the environment are found before others."""
    monkeypatch.setenv("PATH", f"{installed}{os.pathsep}{os.environ['PATH']}")
    monkeypatch.setenv("LC_ALL", "C")
    monkeypatch.setenv("PYTHONUTF8", "1")
    monkeypatch.delenv("PYTHONPATH", raising=False)
    return tmp_path


def test_the_archive_holds_what_the_tests_need(archive: Path) -> None:
    with tarfile.open(archive) as packed:
        names = {name.partition("/")[2] for name in packed.getnames()}
    needed = {f"{folder}/{name}" for folder in PACKED for name in list_files(ROOT / folder)}
    needed |= {"Makefile", "pyproject.toml", "LICENSE", *(page.name for page in ROOT.glob("*.md"))}
    assert needed - names == set()


def test_the_wheel_holds_the_program_its_templates_and_banks_and_nothing_else(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as packed:
        names = {name for name in packed.namelist() if ".dist-info/" not in name}
    assert names == {
        f"{target}/{name}" for target, folder in OURS.items() for name in list_files(ROOT / folder)
    }


def test_what_is_installed_is_all_that_is_found(elsewhere: Path, installed: Path) -> None:
    code = "import kinegrade, sys; print(kinegrade.__file__); print(*sys.path, sep='\\n')"
    status, (file, *path) = run(f'python -c "{code}"', elsewhere)
    assert status == 0
    assert Path(file).is_relative_to(installed.parent)
    assert ROOT not in {(elsewhere / entry).resolve() for entry in path}


@pytest.mark.left(beside="test_what_is_installed_is_all_that_is_found")
def test_the_tutorial_can_be_followed(elsewhere: Path) -> None:
    steps = read_steps(DOCS / "tutorial" / "first-exam.md")
    faults = [take(step, elsewhere, run) for step in steps if not isinstance(step, Program)]
    assert "".join(faults) == ""


def test_pages_install_what_a_wheel_is_made_of() -> None:
    steps = [step for page in list_pages() for step in read_steps(page)]
    lines = {step.line for step in steps if isinstance(step, Command)}
    assert {line for line in lines if line.startswith(INSTALLING)} == {
        "pip install .",
        "pip install '.[preview]'",
        "pip install '.[word]'",
    }
