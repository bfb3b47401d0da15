"""A command that replaces a folder notices that another one wrote there meanwhile."""

from __future__ import annotations

import os
import sys
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from pathlib import Path

import pytest

from kinegrade.errors import OutputError
from kinegrade.files.output import output_folder
from kinegrade.files.placing import one_at_a_time, publishing
from kinegrade.files.placing.standing import find_standing

CHANGED = (
    "EXAM: changed while this command ran, perhaps by another one; what stands there stays - "
    "expected one command at a time - give this command again"
)


def write(path: Path, text: str) -> None:
    with output_folder(path, marker="exam.json", force=True) as folder:
        (folder / "exam.json").write_text(text)


def add_one(path: Path) -> None:
    """What the folder says, and one more; given again until it is written."""
    while True:
        with (
            suppress(OutputError),
            output_folder(path, marker="exam.json", force=True) as folder,
        ):
            count = int((path / "exam.json").read_text())
            (folder / "exam.json").write_text(str(count + 1))
            break


def test_a_folder_of_somebody_else_is_not_looked_through(tmp_path: Path) -> None:
    """It may be a whole disk, which took half a minute before its refusal."""
    (tmp_path / "below").mkdir()
    (tmp_path / "below" / "deep.txt").write_text("mine")
    (tmp_path / "top.txt").write_text("mine")
    assert [*find_standing(tmp_path, "exam.json").files] == ["top.txt"]
    (tmp_path / "exam.json").write_text("{}")
    found = find_standing(tmp_path, "exam.json").files
    assert sorted(found) == ["below/deep.txt", "exam.json", "top.txt"]


def test_what_another_command_wrote_meanwhile_stays(tmp_path: Path) -> None:
    place = tmp_path / "EXAM"
    write(place, "one")

    def write_too_late() -> None:
        with output_folder(place, marker="exam.json", force=True) as folder:
            (folder / "exam.json").write_text("two")
            write(place, "one of another")

    with pytest.raises(OutputError) as refused:
        write_too_late()
    assert str(refused.value) == f"{tmp_path}/{CHANGED}"
    assert (place / "exam.json").read_text() == "one of another"
    assert os.listdir(tmp_path) == ["EXAM"]


@pytest.mark.parametrize("before", [True, False])
def test_a_file_that_somebody_saved_meanwhile_stays(tmp_path: Path, *, before: bool) -> None:
    place = tmp_path / "EXAM"
    write(place, "one")

    def write_too_late() -> None:
        with output_folder(place, marker="exam.json", force=True) as folder:
            (folder / "exam.json").write_text("two")
            if before:
                (place / "exam.json").write_text("1 h")  # no longer than it was
                os.utime(place / "exam.json", (0, 0))
            else:
                (place / "exam.json").unlink()

    with pytest.raises(OutputError, match="changed while this command ran"):
        write_too_late()
    assert [each.read_text() for each in place.iterdir()] == ["1 h"] * before


@pytest.mark.skipif(sys.platform != "linux", reason="the two-step way is what other systems have")
def test_what_came_between_the_look_and_the_renaming_stays(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    place = tmp_path / "EXAM"
    write(place, "one")

    def come_between(*_: Path, **__: bool) -> bool:
        (place / "exam.json").write_text("one of another machine")
        return False

    monkeypatch.setattr(publishing, "_rename_atomically", come_between)
    with pytest.raises(OutputError, match="changed while this command ran"):
        write(place, "two")
    assert (place / "exam.json").read_text() == "one of another machine"
    assert os.listdir(tmp_path) == ["EXAM"]


def test_of_many_commands_at_once_none_is_lost(tmp_path: Path) -> None:
    write(tmp_path / "EXAM", "0")
    with ThreadPoolExecutor(4) as workers:
        assert list(workers.map(add_one, [tmp_path / "EXAM"] * 8)) == [None] * 8
    assert (tmp_path / "EXAM" / "exam.json").read_text() == "8"


@pytest.mark.skipif(sys.platform == "win32", reason="folders are not locked there")
def test_who_locks_the_folder_for_long_holds_nothing_up(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(one_at_a_time, "_MOST_TRIES", 2)
    with one_at_a_time.alone_in(tmp_path):  # as the command flock does, around ours
        write(tmp_path / "EXAM", "one")
    assert (tmp_path / "EXAM" / "exam.json").read_text() == "one"
