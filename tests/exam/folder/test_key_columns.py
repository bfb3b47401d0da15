"""key.npz says what key.jsonl says, and nothing is taken from it once it does not."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable
from fractions import Fraction
from itertools import chain
from math import nextafter
from pathlib import Path
from zipfile import ZipFile

import numpy as np
import pytest

from benchmarks.large_class import write_class
from kinegrade.exam.folder.columns import reading, record, writing
from kinegrade.exam.folder.columns.gathering import find_decimals, read_centres, read_mistakes
from kinegrade.exam.folder.columns.part import PartKeys
from kinegrade.exam.folder.contents import HEAD, KEY, KEY_COLUMNS
from kinegrade.exam.folder.exam_folder import ExamFolder, open_exam
from kinegrade.exam.folder.key.exact_keys import ListedKeys
from kinegrade.exam.folder.keys import Key
from kinegrade.exam.folder.papers import Paper
from kinegrade.numbers.tolerance import Tolerance

STUDENTS = 25


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    write_class(tmp_path, STUDENTS, 0.0)
    return tmp_path / "EXAM"


def without_columns(folder: Path) -> ExamFolder:
    """A copy that has the key alone."""
    copy = folder.with_name("OLD")
    shutil.copytree(folder, copy, ignore=shutil.ignore_patterns(KEY_COLUMNS))
    return open_exam(copy)


def are_columns(papers: list[Paper]) -> list[bool]:
    return [isinstance(each.keys, PartKeys) for each in papers]


def state(papers: list[Paper]) -> list[object]:
    """Everything that papers say."""
    return [(each.student, each.name, [*each.keys]) for each in papers]


@pytest.mark.parametrize("size", [1, 7, STUDENTS, 1000])
def test_columns_hold_every_digit_of_the_key(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, size: int
) -> None:
    monkeypatch.setattr(writing, "PART", size)
    monkeypatch.setattr(reading, "PART", size)
    write_class(tmp_path, STUDENTS, 0.0)
    papers = list(open_exam(tmp_path / "EXAM").papers())
    assert set(are_columns(papers)) == {True}
    assert state(papers) == state(list(without_columns(tmp_path / "EXAM").papers()))


@pytest.mark.parametrize("size", [1, 7, 20, 1000])
def test_so_do_blocks_of_several_parts(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, size: int
) -> None:
    for module in (writing, reading):
        monkeypatch.setattr(module, "PART", 7)
    write_class(tmp_path, STUDENTS, 0.0)
    blocks = list(open_exam(tmp_path / "EXAM").blocks(size))
    listed = list(without_columns(tmp_path / "EXAM").blocks(size))
    assert [block for block in blocks if len(block) > size] == []
    assert state([*chain(*blocks)]) == state([*chain(*listed)])
    for each in (blocks, listed):
        assert [*chain(*(block.students for block in each))] == [f"{n:06}" for n in range(STUDENTS)]
        assert {name for block in each for name in block.names} >= {"Student 0", "Student 24"}
    if size >= STUDENTS:
        places = np.array([0, 69, 70, 71, 249])
        found, expected = (read_mistakes(each[0].keys, places, 10) for each in (blocks, listed))
        assert found.values.tolist() == expected.values.tolist()
        assert np.array_equal(read_centres(blocks[0].keys), read_centres(listed[0].keys))


def test_a_generated_exam_has_columns(small_class: Path) -> None:
    papers = list(open_exam(small_class / "EXAM").papers())
    assert set(are_columns(papers)) == {True}


def test_keys_gathered_from_columns_are_those_of_the_lines(folder: Path) -> None:
    papers, lines = list(open_exam(folder).papers()), list(without_columns(folder).papers())
    ours, theirs = [each.keys for each in papers], [each.keys for each in lines]
    mixed = [*ours[:9], *theirs[9:]]
    places = np.array([0, 3, 4, 100, 101, 249])
    for keys in (ours, mixed):
        assert np.array_equal(read_centres(keys), read_centres(theirs), equal_nan=True)
        for own, other in zip(keys, theirs, strict=True):
            assert list(own.list_values()) == list(other.list_values())
            assert list(own.list_periods()) == list(other.list_periods())
            assert own.list_rules() == other.list_rules()
        found, expected = (read_mistakes(each, places, 10) for each in (keys, theirs))
        assert found.counts.tolist() == expected.counts.tolist()
        named, meant = (
            [each.known[number] for number in each.names.tolist()] for each in (found, expected)
        )
        assert named == meant
        assert found.values.tolist() == expected.values.tolist()


def flip_a_byte(file: Path) -> None:
    content = bytearray(file.read_bytes())
    content[len(content) // 2] ^= 1
    file.write_bytes(content)


def leave_out_a_member(file: Path) -> None:
    with ZipFile(file) as archive:
        kept = {name: archive.read(name) for name in archive.namelist() if "wrong" not in name}
    with ZipFile(file, "w") as archive:
        for name, content in kept.items():
            archive.writestr(name, content)


DAMAGE: dict[str, Callable[[Path], object]] = {
    "cut": lambda file: file.write_bytes(file.read_bytes()[:-9]),
    "empty": lambda file: file.write_bytes(b""),
    "another file": lambda file: file.write_bytes(b"student,name\n"),
    "a flipped byte": flip_a_byte,
    "a part of it": leave_out_a_member,
    "missing": lambda file: file.unlink(),
}


@pytest.mark.parametrize("damage", DAMAGE.values(), ids=DAMAGE)
def test_what_is_damaged_is_read_from_the_key(
    folder: Path, damage: Callable[[Path], object]
) -> None:
    expected = state(list(open_exam(folder).papers()))
    damage(folder / KEY_COLUMNS)
    papers = list(open_exam(folder).papers())
    assert False in are_columns(papers)
    assert state(papers) == expected


def test_damage_behind_the_first_part_repeats_and_loses_nobody(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(writing, "PART", 10)
    monkeypatch.setattr(reading, "PART", 10)
    write_class(tmp_path, STUDENTS, 0.0)
    flip_a_byte(tmp_path / "EXAM" / KEY_COLUMNS)
    papers = list(open_exam(tmp_path / "EXAM").papers())
    assert are_columns(papers) == [True] * 10 + [False] * 15
    assert [each.student for each in papers] == [f"{number:06}" for number in range(STUDENTS)]


def test_a_key_that_was_changed_counts_at_once(folder: Path) -> None:
    before = next(open_exam(folder).papers()).keys[0]
    old = f'"value": {float(Fraction(before.value))!r}'
    value = nextafter(float(Fraction(before.value)), 0)
    text = (folder / KEY).read_text(encoding="utf-8")
    assert text.count(old) == 1
    (folder / KEY).write_text(text.replace(old, f'"value": {value!r}'), encoding="utf-8")
    papers = list(open_exam(folder).papers())
    assert set(are_columns(papers)) == {False}
    assert papers[0].keys.list_values()[0] == value


def write_later(folder: Path, seconds: float) -> None:
    """The columns, written so long after the key."""
    before = (folder / KEY_COLUMNS).stat().st_mtime_ns - int(seconds * 10**9)
    os.utime(folder / KEY, ns=(before, before))
    writing.write_columns(folder / KEY_COLUMNS, folder / KEY, open_exam(folder).head)


def refuse_to_digest(*_: object) -> None:
    raise AssertionError


def test_a_key_that_was_left_alone_is_not_read_again(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_later(folder, 60)
    monkeypatch.setattr(record, "file_digest", refuse_to_digest)
    assert set(are_columns(list(open_exam(folder).papers()))) == {True}


def test_columns_are_the_same_whenever_they_are_written(folder: Path) -> None:
    first = (folder / KEY_COLUMNS).read_bytes()
    write_later(folder, 60)
    assert (folder / KEY_COLUMNS).read_bytes() == first


def change_in_place(folder: Path) -> None:
    """One digit of the key, so that its file has the same size and time."""
    times = (folder / KEY).stat()
    text = (folder / KEY).read_text(encoding="utf-8")
    (folder / KEY).write_text(text.replace('"points": 3', '"points": 4', 1), encoding="utf-8")
    os.utime(folder / KEY, ns=(times.st_mtime_ns, times.st_mtime_ns))


def test_columns_as_young_as_the_key_are_held_against_its_digest(folder: Path) -> None:
    os.utime(folder / KEY)
    write_later(folder, 0)
    change_in_place(folder)
    assert reading.find_columns(folder / KEY_COLUMNS, folder / KEY, open_exam(folder).head) is None


def test_files_of_one_time_are_held_against_the_digest(folder: Path) -> None:
    write_later(folder, 60)
    for file in (folder / KEY, folder / KEY_COLUMNS):
        os.utime(file, ns=(10**18, 10**18))
    change_in_place(folder)
    assert reading.find_columns(folder / KEY_COLUMNS, folder / KEY, open_exam(folder).head) is None


def test_a_copied_folder_is_held_against_its_digest(folder: Path) -> None:
    copy = folder.with_name("COPY")
    shutil.copytree(folder, copy, copy_function=shutil.copyfile)
    assert set(are_columns(list(open_exam(copy).papers()))) == {True}
    flip_a_byte(copy / KEY)
    assert reading.find_columns(copy / KEY_COLUMNS, copy / KEY, open_exam(copy).head) is None


@pytest.mark.parametrize(
    ("old", "new"), [('"points": 3\n', '"points": 4\n'), ('"000003"', '"000003a"')]
)
def test_a_head_that_was_changed_is_compared_with_the_key(folder: Path, old: str, new: str) -> None:
    head = folder / HEAD
    head.write_text(head.read_text(encoding="utf-8").replace(old, new, 1), encoding="utf-8")
    assert reading.find_columns(folder / KEY_COLUMNS, folder / KEY, open_exam(folder).head) is None


def test_a_line_that_is_not_as_generated_leaves_no_columns(folder: Path) -> None:
    text = (folder / KEY).read_text(encoding="utf-8")
    (folder / KEY).write_text(text.replace('"decimal"', '"digits"', 1), encoding="utf-8")
    writing.write_columns(folder / KEY_COLUMNS, folder / KEY, open_exam(folder).head)
    assert sorted(each.name for each in folder.iterdir()) == [HEAD, KEY]


def test_few_digits_are_told_from_many_and_from_fractions_that_do_not_end() -> None:
    written = ["27/2", "-81/50", "2", "-0", "0.5", "1/3", "22/7", "1/1024", "0.1234567890123456"]
    key = Tolerance(Fraction(1, 100))
    papers = [ListedKeys([Key(Fraction(each), key)]) for each in written]
    found = find_decimals(papers, np.arange(len(written)), 1)
    assert found.tolist() == [True, True, True, True, True, False, False, True, False]
