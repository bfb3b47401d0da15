"""What long work says of itself on standard error, which never reaches a pipe's standard output."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from kinegrade.cli import options

Capture = pytest.CaptureFixture[str]


def work(monkeypatch: pytest.MonkeyPatch, seconds: float, start: float = 0.0) -> list[str]:
    """Four papers, each of which takes so long, behind what it takes to start."""
    clock = 0.0

    def tick() -> float:
        return clock

    def papers() -> Iterator[str]:
        nonlocal clock
        clock += start
        for each in "abcd":
            clock += seconds
            yield each

    monkeypatch.setattr(options, "monotonic", tick)
    return list(options.show_progress(papers(), 4))


def test_a_log_gets_a_line_now_and_then_with_the_time_left(
    monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    assert work(monkeypatch, 20.0) == list("abcd")
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err == "2 of 4 papers, 3 a minute, about 40 seconds left\n"


def test_the_time_left_does_not_count_what_it_took_to_start(
    monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    """By the time that the first paper took, 50 s, the other three would take some 150 s."""
    work(monkeypatch, 6.0, start=44.0)
    assert capsys.readouterr().err == "2 of 4 papers, 10 a minute, about 12 seconds left\n"


def test_short_work_says_nothing_in_a_log(monkeypatch: pytest.MonkeyPatch, capsys: Capture) -> None:
    work(monkeypatch, 1.0)
    assert capsys.readouterr().err == ""


@pytest.mark.parametrize(("terminal", "rewritten"), [("xterm", True), ("dumb", False)])
def test_a_terminal_has_one_line_where_it_can_go_back(
    terminal: str, rewritten: bool, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    monkeypatch.setenv("TERM", terminal)
    monkeypatch.setattr("sys.stderr.isatty", lambda: True)
    work(monkeypatch, 20.0)
    assert ("\r" in capsys.readouterr().err) is rewritten
