"""What `--force` replaces stays beside it: no table that somebody filled in is lost by a wrong name."""

from __future__ import annotations

import errno
import os
from pathlib import Path

import pytest
from click.testing import CliRunner

from kinegrade.cli import main
from kinegrade.errors import OutputError
from kinegrade.files.output import output_file, write_file
from kinegrade.files.placing.previous import Previous


def replace(target: Path, *texts: str) -> None:
    """Write a table once for each text, over what stands there."""
    for text in texts:
        write_file(target, text.encode(), "csv", force=True)


def read_all(folder: Path) -> dict[str, str]:
    return {each.name: each.read_text() for each in folder.iterdir()}


def test_every_table_that_was_replaced_is_kept(tmp_path: Path) -> None:
    replace(tmp_path / "a.csv", "one", "two", "three")
    assert read_all(tmp_path) == {
        "a.csv": "three",
        "a.csv.previous-1": "one",
        "a.csv.previous-2": "two",
    }


def test_the_same_table_again_leaves_nothing_beside_it(tmp_path: Path) -> None:
    replace(tmp_path / "a.csv", "one", "one")
    assert read_all(tmp_path) == {"a.csv": "one"}


def test_of_pages_the_last_is_kept(tmp_path: Path) -> None:
    for text in (b"one", b"two", b"three"):
        write_file(tmp_path / "a.html", text, "html", force=True)
    assert read_all(tmp_path) == {"a.html": "three", "a.html.previous": "two"}


def fail_over(target: Path) -> None:
    """Begin another version of a table, and break off."""
    with output_file(target, force=True, previous=Previous.ALL) as partial:
        partial.write_text("two")
        raise ZeroDivisionError


def test_what_fails_leaves_what_stood_there_and_nothing_beside_it(tmp_path: Path) -> None:
    replace(tmp_path / "a.csv", "one")
    with pytest.raises(ZeroDivisionError):
        fail_over(tmp_path / "a.csv")
    assert read_all(tmp_path) == {"a.csv": "one"}


def test_where_a_file_has_one_name_only_it_is_copied(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*places: Path) -> None:
        raise OSError(errno.EPERM, "Operation not permitted")

    monkeypatch.setattr(os, "link", refuse)
    replace(tmp_path / "a.csv", "one", "two")
    assert read_all(tmp_path) == {"a.csv": "two", "a.csv.previous-1": "one"}


def test_what_cannot_be_kept_is_not_replaced(tmp_path: Path) -> None:
    (tmp_path / "a.html").write_text("one")
    (tmp_path / "a.html.previous").mkdir()
    with pytest.raises(OutputError, match="a.html: cannot be written .*a.html.previous"):
        write_file(tmp_path / "a.html", b"two", "html", force=True)
    assert (tmp_path / "a.html").read_text() == "one"


def test_a_template_that_was_worked_on_survives_a_second_new(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    runner = CliRunner()
    assert runner.invoke(main, ["new", "my-crank"]).exit_code == 0
    Path("my-crank.toml").write_text("an evening's work")
    assert runner.invoke(main, ["new", "my-crank", "--force"]).exit_code == 0
    assert Path("my-crank.toml.previous-1").read_text() == "an evening's work"
