"""Booklets of rooms after papers have changed hands: those that stay as they were are the ones that
would be bound anew.
"""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from pathlib import Path

import pytest

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.printing.room_booklets import write_room_booklets
from tests.exam.test_seating import LATE, write_seated_class
from tests.small_class import generate, kinegrade


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A class with rooms, its exam, spare papers and a list of who is late."""
    folder = write_seated_class(tmp_path_factory.mktemp("seated"))
    (folder / "late.csv").write_text(LATE, encoding="utf-8")
    result = generate(folder, "EXAM", "--spare", "2")
    assert result.exit_code == 0, result.stderr
    return folder


def read_booklets(exam: Path) -> dict[str, bytes]:
    """Each booklet by its name."""
    return {each.name: each.read_bytes() for each in sorted((exam / "rooms").iterdir())}


def bind_anew(exam: Path, place: Path) -> dict[str, bytes]:
    """The booklets of a copy that has none."""
    shutil.copytree(exam, place)
    shutil.rmtree(place / "rooms")
    write_room_booklets(place, open_exam(place).head)
    return read_booklets(place)


@pytest.mark.parametrize(
    ("words", "changed"),
    [
        (["assign", "EXAM", "CODE", "0099"], {"spare.pdf", "without-room.pdf"}),
        (["exchange", "EXAM", "CODE", "007"], {"spare.pdf", "Hall-7.pdf"}),
        (["exchange", "EXAM", "0014", "014", "--new-id"], {"教一-101.pdf"}),
        (
            ["generate", "bank.toml", "roster.csv", "-o", "EXAM", "--add", "late.csv"],
            {"Hall-7.pdf"},
        ),
    ],
    ids=lambda each: each[0] if isinstance(each, list) else "",
)
def test_booklets_after_a_change_are_those_bound_anew(
    folder: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    words: Sequence[str],
    changed: set[str],
) -> None:
    here = shutil.copytree(folder, tmp_path / "class")
    monkeypatch.chdir(here)
    before = read_booklets(here / "EXAM")
    code = open_exam(here / "EXAM").head.spares[0].paper
    result = kinegrade(*(each.replace("CODE", code) for each in words))
    assert result.exit_code == 0, result.stderr
    after = read_booklets(here / "EXAM")
    assert {name for name in after if after[name] != before.get(name)} == changed
    assert after == bind_anew(here / "EXAM", tmp_path / "anew")


def test_a_booklet_that_was_taken_away_is_bound_again(folder: Path, tmp_path: Path) -> None:
    here = shutil.copytree(folder, tmp_path / "class")
    before = read_booklets(here / "EXAM")
    (here / "EXAM" / "rooms" / "Hall-7.pdf").unlink()
    code = open_exam(here / "EXAM").head.spares[0].paper
    assert kinegrade("assign", here / "EXAM", code, "0099").exit_code == 0
    assert read_booklets(here / "EXAM")["Hall-7.pdf"] == before["Hall-7.pdf"]
