"""`kinegrade archive` and `verify`: a lost folder is a lost key, so an exam is kept whole."""

from __future__ import annotations

import json
import shutil
import subprocess
import zipfile
from hashlib import sha256
from pathlib import Path

import pytest
from pypdf import PdfReader

from tests.small_class import contents, kinegrade


@pytest.fixture
def exam(small_class: Path, tmp_path: Path) -> Path:
    """A small exam, alone in its folder."""
    return Path(shutil.copytree(small_class / "EXAM", tmp_path / "EXAM"))


@pytest.fixture
def archive(exam: Path) -> Path:
    """Its archive."""
    target = exam.parent / "kept.zip"
    assert kinegrade("archive", exam, "-o", target).exit_code == 0
    return target


def rewrite(archive: Path, changes: dict[str, bytes | None]) -> None:
    """Change, add or leave out files of an archive."""
    with zipfile.ZipFile(archive) as old:
        held: dict[str, bytes | None] = {name: old.read(name) for name in old.namelist()}
    with zipfile.ZipFile(archive, "w") as new:
        for name, content in {**held, **changes}.items():
            if content is not None:
                new.writestr(name, content)


def page_of(archive: Path) -> Path:
    return archive.with_name("kept-page.pdf")


def complaints(path: Path, *options: str) -> list[str]:
    """What verifying complains of."""
    result = kinegrade("verify", path, *options)
    assert result.stdout == ""
    lines = result.stderr.splitlines()
    found = [line.removeprefix("complaint: ") for line in lines if line.startswith("complaint: ")]
    assert result.exit_code == (1 if found else 0)
    return found


def test_an_archive_restores_the_exam_byte_for_byte(exam: Path, archive: Path) -> None:
    with zipfile.ZipFile(archive) as held:
        held.extractall(exam.parent / "restored")
    assert contents(exam.parent / "restored" / "EXAM") == contents(exam)
    compared = ["sha256sum", "--check", "--quiet", "CHECKSUMS.txt"]
    assert subprocess.run(compared, cwd=exam.parent / "restored", check=False).returncode == 0


def test_what_is_taken_out_of_it_is_its_owners_alone(archive: Path) -> None:
    with zipfile.ZipFile(archive) as held:
        assert {each.external_attr >> 16 & 0o777 for each in held.infolist()} == {0o600}


def test_two_folders_of_marks_are_refused_so_that_none_is_left_out(exam: Path) -> None:
    marks = "--marks", exam.parent / "M1", "--marks", exam.parent / "M2"
    done = kinegrade("archive", exam, *marks, "-o", exam.parent / "two.zip")
    assert done.exit_code == 2
    assert "--marks is given twice - expected once - leave one of the two out" in done.stderr


def test_the_bytes_depend_on_the_exam_alone(exam: Path, archive: Path) -> None:
    again = exam.parent / "again.zip"
    assert kinegrade("archive", exam, "-o", again).exit_code == 0
    assert again.read_bytes() == archive.read_bytes()
    for file in (archive, page_of(archive)):
        assert file.stat().st_mode & 0o077 == 0  # it gives the key away
    assert kinegrade("archive", exam, "-o", again).exit_code == 2  # it is there already


def test_nothing_is_written_where_the_page_is_there_already(exam: Path) -> None:
    (exam.parent / "kept-page.pdf").write_text("mine", encoding="utf-8")
    before = contents(exam.parent)
    assert kinegrade("archive", exam, "-o", exam.parent / "kept.zip").exit_code == 2
    assert contents(exam.parent) == before


def test_the_page_says_what_is_needed_to_restore_it(exam: Path, archive: Path) -> None:
    page = "".join(
        "".join(each.extract_text().split()) for each in PdfReader(page_of(archive)).pages
    )
    head = json.loads((exam / "exam.json").read_text(encoding="utf-8"))
    assert sha256(archive.read_bytes()).hexdigest() in page
    secret = head.get("secret") or head["reproducible"]
    assert "".join(secret.split()) in page
    assert [each for each in head["students"] if each["paper"] not in page] == []
    assert "kept.zip" in page
    assert "kinegradeverifyEXAM--all" in page


def test_a_whole_archive_is_found_whole(archive: Path) -> None:
    result = kinegrade("verify", archive)
    assert result.exit_code == 0
    assert f"{archive}: the keys of 4 of 4 papers solved again" in result.stderr
    assert "files compared with their checksums" in result.stderr


def test_marks_are_kept_with_it(exam: Path, small_class: Path, tmp_path: Path) -> None:
    marks = tmp_path / "MARKS"
    assert kinegrade("grade", exam, exam / "answers.csv", "-o", marks).exit_code in (0, 1)
    kept = tmp_path / "with-marks.zip"
    assert kinegrade("archive", exam, "--marks", marks, "-o", kept).exit_code == 0
    assert complaints(kept) == []
    grades = (marks / "grades.csv").read_bytes()
    rewrite(kept, {"MARKS/grades.csv": grades.replace(b"0012,", b"0013,")})
    differs, *broken = complaints(kept)
    assert differs == "MARKS/grades.csv: is not as it was archived"
    assert [each for each in broken if each.startswith("/")] == []
    refused = kinegrade("archive", exam, "--marks", exam, "-o", tmp_path / "no.zip")
    assert refused.exit_code == 2


def test_what_differs_is_named(archive: Path) -> None:
    changes = {
        "EXAM/papers/007.pdf": None,
        "EXAM/bank.toml": b"title = 1",
        "EXAM/notes.txt": b"new",
    }
    rewrite(archive, {**changes})
    found = complaints(archive)
    assert set(found[:3]) == {
        "EXAM/papers/007.pdf: is missing",
        "EXAM/bank.toml: is not as it was archived",
        "EXAM/notes.txt: was not archived",
    }


def test_a_key_that_no_longer_follows_is_named(exam: Path) -> None:
    key = exam / "key.jsonl"
    first, *others = key.read_text(encoding="utf-8").splitlines(keepends=True)
    line = json.loads(first)
    line["questions"][0]["asks"]["v_B"]["value"] *= 2
    key.write_text(json.dumps(line, ensure_ascii=False) + "\n" + "".join(others), encoding="utf-8")
    found = complaints(exam)
    assert found
    assert [each for each in found if "v_B" not in each] == []


def test_a_key_that_follows_from_other_numbers_than_were_printed_is_named(exam: Path) -> None:
    """The questions of two students, exchanged: solved again they follow."""
    key = exam / "key.jsonl"
    first, second, *others = map(json.loads, key.read_text(encoding="utf-8").splitlines())
    first["questions"], second["questions"] = second["questions"], first["questions"]
    lines = [json.dumps(line) + "\n" for line in (first, second, *others)]
    key.write_text("".join(lines), encoding="utf-8")
    told, *named = complaints(exam, "--all")
    assert told == f"{key}: was changed since kinegrade wrote it"
    for line in (first, second):
        assert any(f'student "{line["student"]}"' in each for each in named), named
    assert not any(f'student "{line["student"]}"' in each for each in named for line in others)


def test_pages_of_other_numbers_are_named_where_no_arrays_keep_the_key(exam: Path) -> None:
    """The questions of two students, exchanged, in a folder without key.npz."""
    key = exam / "key.jsonl"
    first, second, *others = map(json.loads, key.read_text(encoding="utf-8").splitlines())
    first["questions"], second["questions"] = second["questions"], first["questions"]
    lines = [json.dumps(line) + "\n" for line in (first, second, *others)]
    key.write_text("".join(lines), encoding="utf-8")
    (exam / "key.npz").unlink()
    printed = [exam / "papers" / f"{line['student']}.pdf" for line in (first, second)]
    said = "is not the paper that follows from the exam's folder"
    assert [each.partition(": ")[0] for each in complaints(exam, "--all") if said in each] == [
        str(file) for file in printed
    ]


def test_a_paper_whose_pages_were_edited_is_named_once(exam: Path) -> None:
    paper = exam / "papers" / "007.pdf"
    paper.write_bytes(paper.read_bytes() + b"\n")
    (named,) = complaints(exam, "--all")
    assert named.startswith(f"{paper}: is not the paper that follows from the exam's folder")
    assert named.endswith('print it again: kinegrade paper EXAM "007" --force -o FILE')


def test_pages_by_another_version_are_not_compared(exam: Path) -> None:
    """Its layout may be another one."""
    head = exam / "exam.json"
    stated = json.loads(head.read_text(encoding="utf-8"))
    head.write_text(json.dumps(stated | {"kinegrade": "0.1.0"}), encoding="utf-8")
    paper = exam / "papers" / "007.pdf"
    paper.write_bytes(paper.read_bytes() + b"\n")
    assert complaints(exam, "--all") == []


def test_a_changed_mistake_is_named(exam: Path) -> None:
    key = exam / "key.jsonl"
    first, *others = key.read_text(encoding="utf-8").splitlines(keepends=True)
    line = json.loads(first)
    mistakes = line["questions"][0]["asks"]["v_B"]["mistakes"]
    mistakes[next(iter(mistakes))] = "12345"
    key.write_text(json.dumps(line, ensure_ascii=False) + "\n" + "".join(others), encoding="utf-8")
    _, named = complaints(exam, "--all")
    assert "v_B: not as kinegrade wrote it" in named
    assert f'student "{line["student"]}"' in named


def test_a_paper_in_the_place_of_another_is_named(exam: Path) -> None:
    shutil.copy(exam / "papers" / "007.pdf", exam / "papers" / "0012.pdf")
    (named,) = complaints(exam)
    assert "007.pdf" in named
    assert "0012.pdf" in named
    assert "is the same file as" in named


def test_a_folder_that_lost_a_paper_or_was_edited_is_found_out(exam: Path) -> None:
    (exam / "papers" / "0012.pdf").unlink()
    template = exam / "templates" / "crank.toml"
    template.write_text(template.read_text(encoding="utf-8") + "# note\n", encoding="utf-8")
    assert complaints(exam, "--all") == [
        f"{template}: is not as it was generated",
        f"{exam / 'papers' / '0012.pdf'}: is missing",
    ]


@pytest.mark.parametrize("name", ["../out.txt", "/etc/out.txt", "OTHER/file.txt", "EXAM/../../x"])
def test_names_that_lead_elsewhere_are_refused(archive: Path, name: str) -> None:
    rewrite(archive, {name: b"x"})
    result = kinegrade("verify", archive)
    assert result.exit_code == 2
    assert "holds other files than an exam, or too many" in result.stderr


def test_what_is_no_archive_is_refused(exam: Path, archive: Path) -> None:
    text = exam.parent / "text.zip"
    text.write_text("no zip", encoding="utf-8")
    assert f"error: {text}: cannot be read: " in kinegrade("verify", text).stderr
    rewrite(archive, {"CHECKSUMS.txt": None})
    assert "holds no CHECKSUMS.txt" in kinegrade("verify", archive).stderr
    assert kinegrade("verify", exam.parent / "none.zip").exit_code == 2


def test_links_are_not_archived(exam: Path) -> None:
    (exam / "papers" / "link.pdf").symlink_to(exam / "key.pdf")
    result = kinegrade("archive", exam, "-o", exam.parent / "kept.zip")
    assert result.exit_code == 2
    assert "link.pdf: is a link, of which an archive would keep nothing" in result.stderr
    assert not (exam.parent / "kept.zip").exists()
