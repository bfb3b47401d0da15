"""`kinegrade preview` at the terminal: where the page is, news of each save, how it ends."""

from __future__ import annotations

import re
import signal
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from http.client import HTTPResponse
from pathlib import Path

import pytest

from tests.preview.visitor import Visitor
from tests.problem.crank import crank_text
from tests.small_class import kinegrade

COMMAND = [sys.executable, "-m", "kinegrade", "preview"]


@contextmanager
def previewing(file: Path) -> Iterator[tuple[Visitor, subprocess.Popen[str]]]:
    """A preview of a file as a process, at a port that was free."""
    process = subprocess.Popen(
        [*COMMAND, file, "--port", "0"], stderr=subprocess.PIPE, text=True, cwd=file.parent
    )
    try:
        assert process.stderr is not None
        said = process.stderr.readline()
        found = re.search(r"http://127\.0\.0\.1:(\d+)/", said)
        assert found, said
        yield Visitor(int(found[1])), process
    finally:
        process.kill()
        process.wait()


def read_news(news: HTTPResponse) -> bytes:
    """The next line that tells of a change."""
    told = (news.readline() for _ in range(60))
    return next(line for line in told if line.startswith(b"data"))


@pytest.fixture
def file(tmp_path: Path) -> Path:
    """A template of one's own."""
    path = tmp_path / "crank.toml"
    path.write_text(crank_text(), encoding="utf-8")
    return path


def test_each_save_of_a_file_or_its_translation_is_news(file: Path) -> None:
    with previewing(file) as (visitor, _):
        news = visitor.open("/news")
        assert news.readline() == b": watching\n"
        for saved in (file, file.with_suffix(".fr.toml")):
            saved.write_text(crank_text(), encoding="utf-8")
            assert read_news(news) == b"data: changed\n"
        assert "crank.fr.toml: unknown" in visitor.read("/problem/0/en")


def test_it_ends_by_ctrl_c_while_a_page_waits_for_news(file: Path) -> None:
    with previewing(file) as (visitor, process):
        assert visitor.open("/news").readline() == b": watching\n"
        process.send_signal(signal.SIGINT)
        assert process.wait(timeout=30) == 130
        assert process.stderr is not None
        assert "Traceback" not in process.stderr.read()


def test_a_port_that_is_taken_is_said(file: Path) -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = str(taken.getsockname()[1])
        result = kinegrade("preview", file, "--port", port)
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr == (
        f"error: --port {port}: the port is taken - expected another port, or --port 0 for any "
        "that is free\n"
    )


def test_what_is_not_installed_is_said(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "kinegrade.preview.serving", None)
    result = kinegrade("preview", file)
    assert (result.exit_code, result.stderr) == (
        2,
        "error: preview: what the preview needs is not installed - "
        "install it by: pip install 'kinegrade[preview]'\n",
    )
