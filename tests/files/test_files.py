"""An output is there whole or not at all, and nobody's own files are ever replaced."""

from __future__ import annotations

import os
import signal
import stat
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from kinegrade.errors import OutputError
from kinegrade.files.output import Access, output_folder, write_file
from kinegrade.files.placing import publishing
from kinegrade.files.placing.leftovers import make_process_name

FILES = 25
WRITE_VERSIONS = f"""
import sys
from pathlib import Path
from kinegrade.files import output_folder
for version in range(int(sys.argv[2]), 10**9):
    with output_folder(Path(sys.argv[1]), marker="0.txt", force=True) as folder:
        for number in range({FILES}):
            (folder / f"{{number}}.txt").write_text(str(version))
            print(version, number, flush=True)
"""


def write(path: Path, text: str, *, force: bool = False) -> None:
    with output_folder(
        path, marker="exam.json", contents=("exam.json", "papers"), force=force
    ) as folder:
        (folder / "exam.json").write_text(text)
        (folder / "papers").mkdir()
        (folder / "papers" / "007.pdf").write_text(text)


def hidden(folder: Path) -> list[str]:
    return [entry.name for entry in folder.iterdir() if entry.name.startswith(".")]


def test_a_new_folder_appears_with_all_its_files_and_nothing_beside_it(tmp_path: Path) -> None:
    write(tmp_path / "deep" / "EXAM", "one")
    assert (tmp_path / "deep" / "EXAM" / "papers" / "007.pdf").read_text() == "one"
    assert os.listdir(tmp_path / "deep") == ["EXAM"]


def test_force_replaces_a_folder_that_kinegrade_wrote(tmp_path: Path) -> None:
    write(tmp_path / "EXAM", "one")
    (tmp_path / "EXAM").chmod(0o700)
    (tmp_path / "EXAM" / ".DS_Store").touch()
    write(tmp_path / "EXAM", "two", force=True)
    assert (tmp_path / "EXAM" / "exam.json").read_text() == "two"
    assert stat.S_IMODE((tmp_path / "EXAM").stat().st_mode) == 0o700
    assert os.listdir(tmp_path) == ["EXAM"]


def test_an_existing_folder_needs_force(tmp_path: Path) -> None:
    write(tmp_path / "EXAM", "one")
    with pytest.raises(OutputError, match="EXAM: already exists - .* --force"):
        write(tmp_path / "EXAM", "two")
    assert (tmp_path / "EXAM" / "exam.json").read_text() == "one"


def test_force_replaces_an_empty_folder(tmp_path: Path) -> None:
    (tmp_path / "EXAM").mkdir()
    write(tmp_path / "EXAM", "one", force=True)
    assert (tmp_path / "EXAM" / "exam.json").read_text() == "one"


def test_force_does_not_replace_somebodys_folder(tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").touch()
    with pytest.raises(OutputError, match=r"was not written by kinegrade \(no exam.json in it\)"):
        write(tmp_path, "one", force=True)
    assert (tmp_path / "thesis.tex").exists()


def test_force_does_not_lose_a_file_put_into_a_folder_of_kinegrade(tmp_path: Path) -> None:
    write(tmp_path / "EXAM", "one")
    (tmp_path / "EXAM" / "notes.txt").touch()
    with pytest.raises(
        OutputError, match="holds notes.txt, which would be lost - .* - move it elsewhere"
    ):
        write(tmp_path / "EXAM", "two", force=True)
    assert (tmp_path / "EXAM" / "notes.txt").exists()


def test_a_file_or_the_root_is_no_place_for_a_folder(tmp_path: Path) -> None:
    (tmp_path / "EXAM").touch()
    with pytest.raises(OutputError, match="is not a folder - expected a folder"):
        write(tmp_path / "EXAM", "one", force=True)
    with pytest.raises(OutputError, match="cannot be written .*EXAM"):
        write(tmp_path / "EXAM" / "below", "one")
    with pytest.raises(OutputError, match="is the root of the file system"):
        write(Path("/"), "one", force=True)


def test_an_error_while_writing_leaves_the_old_folder_and_nothing_else(tmp_path: Path) -> None:
    write(tmp_path / "EXAM", "one")

    def fail() -> None:
        with output_folder(tmp_path / "EXAM", marker="exam.json", force=True) as folder:
            (folder / "exam.json").write_text("two")
            raise OSError(28, "No space left on device")

    with pytest.raises(OutputError, match="EXAM: cannot be written .*No space left"):
        fail()
    assert (tmp_path / "EXAM" / "exam.json").read_text() == "one"
    assert os.listdir(tmp_path) == ["EXAM"]


def test_a_folder_made_by_somebody_else_meanwhile_is_not_touched(tmp_path: Path) -> None:

    def write_too_late() -> None:
        with output_folder(tmp_path / "EXAM", marker="exam.json") as folder:
            (folder / "exam.json").touch()
            write(tmp_path / "EXAM", "somebody else's")

    with pytest.raises(OutputError, match="EXAM: already exists"):
        write_too_late()
    assert (tmp_path / "EXAM" / "exam.json").read_text() == "somebody else's"


@pytest.mark.skipif(sys.platform != "linux", reason="the two-step way is what other systems have")
def test_where_nothing_atomic_exists_two_renames_do_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(publishing, "_rename_atomically", lambda *_, **__: False)
    write(tmp_path / "EXAM", "one")
    write(tmp_path / "EXAM", "two", force=True)
    assert (tmp_path / "EXAM" / "exam.json").read_text() == "two"
    assert os.listdir(tmp_path) == ["EXAM"]


def test_a_file_is_written_whole_and_replaced_only_by_force(tmp_path: Path) -> None:
    target = tmp_path / "moodle.csv"
    write_file(target, b"one", "csv")
    with pytest.raises(
        OutputError, match="moodle.csv: already exists - expected a new file - add --force"
    ):
        write_file(target, b"two", "csv")
    assert target.read_bytes() == b"one"
    write_file(target, b"two", "csv", force=True)
    assert target.read_bytes() == b"two"
    assert sorted(os.listdir(tmp_path)) == ["moodle.csv", "moodle.csv.previous-1"]


def test_only_a_plain_file_is_replaced_by_a_file(tmp_path: Path) -> None:
    for path in (tmp_path, Path(os.devnull)):
        with pytest.raises(OutputError, match="is not a plain file"):
            write_file(path, b"one", "csv", force=True)


def versions(target: Path) -> Iterator[set[str]]:
    """For each of the file's places the version found there, after one SIGKILL at each of several
    moments.
    """
    for moment in (
        1,
        2,
        FILES // 2,
        FILES - 1,
        FILES,
        FILES,
        FILES,
        2 * FILES,
        2 * FILES + 1,
        3 * FILES,
    ):
        start = str(moment * 1000)
        command = [sys.executable, "-c", WRITE_VERSIONS, str(target), start]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
            if process.stdout:
                for _ in range(moment):
                    process.stdout.readline()
            time.sleep(0.002 * (moment % 3))
            process.send_signal(signal.SIGKILL)
        yield {entry.read_text() for entry in target.glob("*.txt")} if target.exists() else set()


@pytest.mark.skipif(os.name != "posix", reason="SIGKILL")
def test_a_killed_process_leaves_the_old_output_or_the_new_one(tmp_path: Path) -> None:
    target = tmp_path / "EXAM"
    with output_folder(target, marker="0.txt") as folder:
        for number in range(FILES):
            (folder / f"{number}.txt").write_text("old")
    for found in versions(target):
        assert len(found) == 1
        assert len(list(target.iterdir())) == FILES
    with output_folder(target, marker="0.txt", force=True) as folder:
        (folder / "0.txt").touch()
    assert hidden(tmp_path) == []


def test_what_a_running_process_is_building_is_not_cleared(tmp_path: Path) -> None:
    with output_folder(tmp_path / "EXAM", marker="exam.json") as outer:
        write(tmp_path / "EXAM", "inner")
        assert outer.exists()
        (tmp_path / "EXAM").rename(tmp_path / "OTHER")
    assert (tmp_path / "EXAM").exists()


@pytest.mark.skipif(os.name != "posix", reason="modes of POSIX")
def test_a_folder_with_access_is_closed_from_its_first_moment(tmp_path: Path) -> None:
    target = tmp_path / "EXAM"
    target.mkdir(mode=0o755)
    access = Access(0o750, 0o640, ordinary=("papers",))
    with output_folder(target, marker="a", force=True, access=access) as folder:
        assert stat.S_IMODE(folder.stat().st_mode) == 0o700
        for name in ("papers", "keys"):
            (folder / name).mkdir(mode=0o711)
            (folder / name / "papers").touch(mode=0o604)
    modes = {
        entry.relative_to(tmp_path).as_posix(): stat.S_IMODE(entry.stat().st_mode)
        for entry in (target, *target.rglob("*"))
    }
    assert modes == {
        "EXAM": 0o750,
        "EXAM/papers": 0o711,
        "EXAM/papers/papers": 0o604,
        "EXAM/keys": 0o750,
        "EXAM/keys/papers": 0o640,
    }


def test_a_folder_without_a_marker_is_known_by_its_contents_alone(tmp_path: Path) -> None:
    for text in ("one", "two"):
        with output_folder(tmp_path / "A", marker=None, contents=("1.pdf",), force=True) as folder:
            (folder / "1.pdf").write_text(text)
    (tmp_path / "A" / "2.pdf").touch()
    with (
        pytest.raises(OutputError, match="holds 2.pdf, which would be lost"),
        output_folder(tmp_path / "A", marker=None, contents=("1.pdf",), force=True),
    ):
        pass
    assert (tmp_path / "A" / "1.pdf").read_text() == "two"


@pytest.mark.skipif(os.name != "posix", reason="whether a process runs")
def test_the_key_in_a_temporary_folder_of_a_killed_run_goes_with_the_next_output(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    room = tmp_path / "temporary"
    room.mkdir()
    monkeypatch.setattr("tempfile.tempdir", str(room))
    with subprocess.Popen([sys.executable, "-c", "pass"]) as ended:
        ended.wait()
    left = make_process_name("kinegrade").replace(f"-{os.getpid()}-", f"-{ended.pid}-")
    (room / left).mkdir()
    (room / left / "key.jsonl").write_text("the key", encoding="utf-8")
    write_file(tmp_path / "quiz.csv", b"", "csv")
    assert not list(room.iterdir())
