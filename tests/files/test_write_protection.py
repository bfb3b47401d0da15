"""Folders that were protected are not replaced, and nothing hidden stays beside them."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

from kinegrade.errors import OutputError
from kinegrade.files.output import output_folder
from kinegrade.files.placing.leftovers import remove

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="modes of Linux")
NOBODY = 65534


@contextmanager
def as_ordinary_user(folder: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """The folder is that of a user whom modes hold off, and the working folder."""
    monkeypatch.chdir(folder)
    if os.geteuid() != 0:
        yield
        return
    for each in (folder, *folder.rglob("*")):
        os.chown(each, NOBODY, NOBODY)
    os.setresuid(NOBODY, NOBODY, 0)
    try:
        yield
    finally:
        os.setresuid(0, 0, 0)


@pytest.fixture
def exam() -> Iterator[Path]:
    """A folder of ours, with another one in it, where every user may come."""
    with TemporaryDirectory() as name:
        exam = Path(name, "EXAM")
        (exam / "papers").mkdir(parents=True)
        (exam / "exam.json").write_text("old")
        (exam / "papers" / "007.pdf").write_text("old")
        yield exam
        remove(exam)


@pytest.mark.parametrize("name", [".", "papers"])
def test_a_protected_folder_is_not_replaced(
    exam: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    (exam / name).chmod(0o500)

    def replace() -> None:
        with output_folder(Path("EXAM"), marker="exam.json", force=True):
            pytest.fail("work was done in vain")

    with as_ordinary_user(exam.parent, monkeypatch), pytest.raises(OutputError) as refused:
        replace()
    assert str(refused.value) == (
        f"{Path('EXAM', name)}: is write-protected - expected a folder that may be replaced - "
        "take the protection away (chmod -R u+w), or choose another"
    )
    assert os.listdir(exam.parent) == ["EXAM"]


def test_what_was_begun_is_removed_whatever_its_modes(
    exam: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (exam / "papers").chmod(0)
    exam.chmod(0o500)
    with as_ordinary_user(exam.parent, monkeypatch):
        remove(Path("EXAM"))
    assert not exam.exists()
