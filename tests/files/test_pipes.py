"""A file that can be read only once is refused before it is read: its second reading is empty."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.small_class import generate, kinegrade, write_class

REFUSED = (
    "is a pipe or a device, which can be read only once - expected {} - save its content to a file "
    "and give that"
)


@pytest.fixture
def pipe() -> Iterator[str]:
    """What a shell gives for <(cat file)."""
    reader, writer = os.pipe()
    os.write(writer, b"student\n007\n")
    os.close(writer)
    yield f"/dev/fd/{reader}"
    os.close(reader)


def test_a_pipe_is_refused_for_every_file_that_is_given(tmp_path: Path, pipe: str) -> None:
    write_class(tmp_path)
    assert generate(tmp_path, "EXAM", "--no-papers").exit_code == 0
    exam, bank, roster = (str(tmp_path / name) for name in ("EXAM", "bank.toml", "roster.csv"))
    sheet, output = str(tmp_path / "EXAM" / "answers.csv"), ("-o", str(tmp_path / "NEW"))
    for expected, *given in (
        ("a policy file", "grade", exam, sheet, "--policy", pipe, *output),
        ("a CSV file", "grade", exam, pipe, *output),
        ("a CSV file", "grade", exam, sheet, "--manual", pipe, *output),
        ("a CSV file", "generate", bank, pipe, *output),
        ("a bank file", "generate", pipe, roster, *output),
    ):
        refused = kinegrade(*given).stderr.replace("\n", " ")
        assert f"error: {pipe}: {REFUSED.format(expected)}" in refused, given
