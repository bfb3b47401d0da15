"""The sums of marks.csv are the same by columns and record by record, and so is what is wrong with
a file, whatever stands in it and wherever its blocks end.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory
from unittest.mock import patch

from hypothesis import example, given, settings
from hypothesis import strategies as st

from kinegrade.errors import TableError
from kinegrade.exam.folder.columns.writing import write_columns
from kinegrade.exam.folder.contents import KEY, KEY_COLUMNS
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.files.csv_writing import write_csv_text
from kinegrade.grading.grade import MarkingWishes, grade
from kinegrade.lms.grades.moodle import export
from kinegrade.marks_folder.layout import ANSWERS
from kinegrade.marks_folder.rows import StudentSums
from kinegrade.marks_folder.sums import columns, reading
from kinegrade.marks_folder.sums.columns import OddTextError
from kinegrade.marks_folder.sums.reading import read_sums
from tests.grading.test_block_judge import write_class
from tests.grading.test_written_marks import HOSTILE, type_hostile

TYPED = (
    "", "-", " \u2013 ", "'-", "\u3000", "0", "-1.5", "--", "=1", "'=1", "1,5", 'a "b", c', "1\n2", "-\n", "1\r2", "\u6574",
)  # fmt: skip
IDS = ("007", "8", "a/b", "'=2", "\u6574", "9" * 70, "b,c", "")
AMOUNTS = ("3", "0", "1.5", "0.6667", "x", "", "9" * 70)
CHANGES = (
    b'"', b",", b"\n", b"\r", b"\0", b"\xff", b"\xc3", b'""', b"q1", b"\n\n", b"1", b"",
)  # fmt: skip

Line = tuple[str, str, str, str, str]
LINES = st.lists(
    st.tuples(
        st.sampled_from(IDS),
        st.sampled_from(("q1", "q2", "q,3")),
        st.sampled_from(TYPED),
        st.sampled_from(AMOUNTS[:4]),
        st.sampled_from(("3", "1.5")),
    ),
    max_size=12,
)


def write_lines(lines: list[Line]) -> bytes:
    """A file as `grade` writes it, each line three times."""
    rows = [
        (student, question, "v", typed, "", "m", "right", points, out_of, 'a, "b"', "", "")
        for student, question, typed, points, out_of in sorted(lines, key=lambda each: each[0])
        for _ in range(3)
    ]
    return write_csv_text(ANSWERS.columns, rows).encode()


def refuse(*_: object) -> Iterator[StudentSums]:
    """Reads nothing by columns."""
    raise OddTextError
    yield


def outcome(folder: Path) -> list[StudentSums] | str:
    """The sums, or what is wrong with the file."""
    try:
        return list(read_sums(folder, frozenset(), {}))
    except TableError as fault:
        return str(fault)


def both_ways(content: bytes, block: int) -> tuple[object, object]:
    """What is found by columns in blocks of so many bytes, and record by record."""
    with TemporaryDirectory() as name:
        (Path(name) / ANSWERS.name).write_bytes(content)
        with patch.object(columns, "_FEW", block):
            by_columns = outcome(Path(name))
        with patch.object(reading, "read_students", refuse):
            return by_columns, outcome(Path(name))


@given(LINES, st.sampled_from((1, 40, 200, 10**6)))
@example([("007", "q1", "-", "3", "3")] * 2, 60)
def test_sums_are_those_of_records(lines: list[Line], block: int) -> None:
    by_columns, by_records = both_ways(write_lines(lines), block)
    assert by_columns == by_records


@given(
    LINES,
    st.sampled_from((1, 40, 200, 10**6)),
    st.lists(st.tuples(st.floats(0, 1), st.integers(0, 3), st.sampled_from(CHANGES)), max_size=3),
)
def test_changed_bytes_are_found_as_in_records(
    lines: list[Line], block: int, changes: list[tuple[float, int, bytes]]
) -> None:
    content = write_lines(lines)
    for share, removed, put in changes:
        at = int(share * len(content))
        content = content[:at] + put + content[at + removed :]
    by_columns, by_records = both_ways(content, block)
    assert by_columns == by_records


@settings(deadline=None)
@given(LINES, st.sampled_from((1, 40, 10**6)))
@example([("007", "q1", "1", "3", "3")], 10**6)
def test_a_last_line_without_its_end_counts(lines: list[Line], block: int) -> None:
    by_columns, by_records = both_ways(write_lines(lines).removesuffix(b"\n"), block)
    assert by_columns == by_records


@settings(max_examples=25, deadline=None)
@given(
    st.integers(0, 10**9),
    st.lists(
        st.tuples(st.integers(0, 11), st.integers(0, 3), st.sampled_from(HOSTILE)), max_size=9
    ),
)
def test_the_whole_folder_is_the_same_by_columns_and_by_rows(
    seed: int, hostile: list[tuple[int, int, str]]
) -> None:
    with TemporaryDirectory() as name:
        folder = Path(name)
        write_class(folder, Random(seed), 12)
        type_hostile(folder, hostile)
        with patch.object(reading, "read_students", refuse):
            by_rows = mark_folder(folder, folder / "ROWS")
        write_columns(folder / KEY_COLUMNS, folder / KEY, open_exam(folder).head)
        assert mark_folder(folder, folder / "COLUMNS") == by_rows


def mark_folder(folder: Path, output: Path) -> dict[str, bytes]:
    """All files of the marks of a class, with the grades for Moodle."""
    wishes = MarkingWishes(exports={"moodle.csv": export}, own_papers=True)
    grade(open_exam(folder), folder / "answers.csv", output, wishes)
    return {file.name: file.read_bytes() for file in output.iterdir()}


def test_files_of_this_version_are_summed_by_columns() -> None:
    lines = [("007", "q1", typed, "3", "3") for typed in TYPED if "\r" not in typed]
    with TemporaryDirectory() as name:
        (Path(name) / ANSWERS.name).write_bytes(write_lines(lines))
        with patch.object(reading, "read_records") as read_records:
            (found,) = read_sums(Path(name), frozenset(), {})
    assert read_records.call_count == 0
    assert found.points.lines == 3 * len(lines)
