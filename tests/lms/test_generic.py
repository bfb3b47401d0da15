"""The plain sheet: the usual four columns, with a byte-order mark so that spreadsheets show Chinese names."""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.errors import TableError
from kinegrade.lms.dialect import ExportOptions
from kinegrade.lms.generic import GENERIC
from tests.golden_files import Hold
from tests.lms.marked_folder import filled, fresh


def test_the_golden_file(tmp_path: Path, hold: Hold) -> None:
    text = fresh(tmp_path, GENERIC).text
    hold("lms/generic.csv", text)
    assert text.startswith("\ufeff学号,姓名,成绩,评语\n0012345,王伟,8.25,")


def test_by_question_and_email(tmp_path: Path) -> None:
    text = fresh(tmp_path, GENERIC, ExportOptions(by=("email",), per_question=True)).text
    assert text.splitlines()[:2] == [
        "\ufeff邮箱,姓名,成绩 q1,成绩 q2",
        "w1@example.invalid,王伟,7,1.25",
    ]


def test_what_cannot_be_had_is_refused(tmp_path: Path) -> None:
    with pytest.raises(
        TableError,
        match="the generic sheet does not know people by login .* choose one of: id, email",
    ):
        fresh(tmp_path, GENERIC, ExportOptions(by=("login",)))
    with pytest.raises(
        TableError, match="--by: id, email - expected one key for a new file - choose one"
    ):
        fresh(tmp_path, GENERIC, ExportOptions(by=("id", "email")))
    with pytest.raises(
        TableError, match="--feedback: the generic sheet takes none with --per-question"
    ):
        fresh(tmp_path, GENERIC, ExportOptions(feedback=True, per_question=True))
    with pytest.raises(
        TableError, match="--into: the generic sheet has no file of its own to be filled in - exp"
    ):
        filled(tmp_path, GENERIC, "学号,成绩\n0012345,\n")
