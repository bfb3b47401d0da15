"""Nobody finds an exam's numbers by guessing: the secret is random, lives in the folder, and is
printed nowhere.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import stat
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.folder.exam_secret import ExamSecret, FromWords, RandomSecret, draw_secret
from kinegrade.exam.setting.paper_codes import make_paper_code, make_paper_codes
from tests.small_class import contents, generate, key_lines, kinegrade, table, write_class

EARLIER = Path(__file__).parent.parent / "data" / "exam-of-0.1"
BANK = """title = "Quiz"
course = "Mechanics"

[[questions]]
template = "slider-crank"
asks = { v_B = 3, a_B = 2 }
"""
ROSTER = "student,name\n007,Ann\n012,Bob\n"
posix = pytest.mark.skipif(os.name != "posix", reason="modes of POSIX")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "bank.toml").write_text(BANK, encoding="utf-8")
    (tmp_path / "roster.csv").write_text(ROSTER, encoding="utf-8")
    return tmp_path


def written(folder: Path, name: str, *options: str) -> str:
    """Standard error of `kinegrade generate` without any words, which has to succeed."""
    files = folder / "bank.toml", folder / "roster.csv"
    result = kinegrade("generate", *files, "-o", folder / name, *options)
    assert (result.exit_code, result.stdout) == (0, "")
    return result.stderr


def head(exam: Path) -> dict[str, Any]:
    found: dict[str, Any] = json.loads((exam / "exam.json").read_text(encoding="utf-8"))
    return found


def kept_secret(exam: Path) -> ExamSecret | None:
    return open_exam(exam).head.drawn_from


def parameters(exam: Path) -> list[Any]:
    return [line["questions"][0]["parameters"] for line in key_lines(exam)]


def codes(exam: Path) -> list[str]:
    return [line["paper"] for line in key_lines(exam)]


def test_the_same_label_twice_gives_other_numbers_and_other_codes(folder: Path) -> None:
    for name in ("ONE", "TWO"):
        written(folder, name, "--seed", "spring")
    one, two = folder / "ONE", folder / "TWO"
    assert parameters(one) != parameters(two)
    assert not set(codes(one)) & set(codes(two))
    for exam in (one, two):
        kept = head(exam)
        assert re.fullmatch("[0-9a-f]{64}", kept["secret"])
        assert re.fullmatch("[0-9a-f]{64}", kept["codes"])
        assert (kept["secret"] != kept["codes"], kept["label"]) == (True, "spring")
        assert make_paper_code("spring", "007") not in codes(exam)


def test_the_program_draws_another_secret_whenever_it_is_run() -> None:
    script = "from kinegrade.exam.folder.exam_secret import draw_secret as d; print(d().draws, d().codes)"
    program = (sys.executable, "-c", script)
    runs = [subprocess.run(program, check=True, capture_output=True, text=True) for _ in range(2)]
    drawn = [word for run in runs for word in run.stdout.split()]
    assert [len(each) for each in drawn] == [64] * 4
    assert len(set(drawn)) == 4


def test_a_test_draws_the_same_secret_in_every_run() -> None:
    assert draw_secret().draws[:16] == "5f09bdd8f9f82649"


def test_the_secret_stands_in_exam_json_and_nowhere_else(folder: Path) -> None:
    said = written(folder, "EXAM")
    exam = folder / "EXAM"
    secrets = [head(exam)["secret"], head(exam)["codes"]]
    assert not [secret for secret in secrets if secret in said]
    elsewhere = {name: data for name, data in contents(exam).items() if name != "exam.json"}
    assert not [
        name
        for name, data in elsewhere.items()
        for secret in secrets
        if secret.encode() in data or bytes.fromhex(secret) in data
    ]
    assert secrets[0] not in repr(kept_secret(exam))
    assert secrets[0] not in repr(open_exam(exam))


def test_codes_tell_nothing_of_the_secret_that_draws(folder: Path) -> None:
    written(folder, "EXAM")
    secret = kept_secret(folder / "EXAM")
    assert isinstance(secret, RandomSecret)
    same_numbers = RandomSecret(secret.draws, draw_secret().codes, secret.label)
    assert same_numbers.drawing == secret.drawing
    assert make_paper_codes(same_numbers.coding, ["007"]) != make_paper_codes(
        secret.coding, ["007"]
    )
    other_numbers = RandomSecret(draw_secret().draws, secret.codes)
    assert other_numbers.drawing != secret.drawing
    assert list(make_paper_codes(other_numbers.coding, ["007", "012"]).values()) == codes(
        folder / "EXAM"
    )


def test_another_label_gives_other_numbers_under_the_same_secret() -> None:
    secret = draw_secret("spring")
    assert secret.drawing != RandomSecret(secret.draws, secret.codes, "autumn").drawing
    assert secret.drawing == RandomSecret(secret.draws, secret.codes, "spring").drawing


def test_no_two_papers_of_a_class_have_one_code(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        "kinegrade.exam.setting.paper_codes.LETTERS", "AB" * 16
    )  # 256 codes instead of 2^40
    students = [str(number) for number in range(200)]
    dealt = make_paper_codes("secret", students)
    assert len(set(dealt.values())) == len(students)
    assert list(make_paper_codes("secret", students[:50]).items()) == list(dealt.items())[:50]


def test_words_give_the_same_exam_anywhere_and_say_what_they_cost(folder: Path) -> None:
    said = [written(folder, name, "--reproducible", "open sesame") for name in ("ONE", "TWO")]
    assert contents(folder / "ONE") == contents(folder / "TWO")
    assert "anyone who guesses these words can print every paper and its key" in said[0]
    assert "guesses" not in written(folder, "EXAM", "--seed", "open sesame")
    assert kept_secret(folder / "ONE") == FromWords("open sesame")
    help_text = " ".join(kinegrade("generate", "--help").stdout.split())
    assert "Anyone who guesses them can print every paper and its key" in help_text


def test_a_label_and_words_exclude_each_other(folder: Path) -> None:
    result = generate(folder, "EXAM", "--seed", "spring", "--reproducible", "spring")
    assert result.exit_code == 2
    assert "--seed mixes a label into a random secret" in result.stderr
    assert not (folder / "EXAM").exists()


@contextmanager
def umask(mask: int) -> Iterator[None]:
    before = os.umask(mask)
    try:
        yield
    finally:
        os.umask(before)


def modes(exam: Path) -> dict[str, int]:
    entries = [exam, *exam.rglob("*")]
    return {
        entry.relative_to(exam).as_posix(): stat.S_IMODE(entry.stat().st_mode) for entry in entries
    }


@posix
@pytest.mark.parametrize("mask", [0o000, 0o022, 0o077])
@pytest.mark.parametrize(
    ("options", "of_folder", "of_file"),
    [((), 0o700, 0o600), (("--share-with-group",), 0o750, 0o640)],
)
def test_others_on_the_machine_cannot_read_the_key(
    folder: Path, mask: int, options: tuple[str, ...], of_folder: int, of_file: int
) -> None:
    with umask(mask):
        written(folder, "EXAM", *options)
    found = modes(folder / "EXAM")
    assert (found["."], found["templates"]) == (of_folder, of_folder)
    for name in ("exam.json", "key.jsonl", "key.pdf", "bank.toml", "answers.csv"):
        assert found[name] == of_file
    assert found["templates/slider-crank.toml"] == of_file


@posix
def test_an_exam_that_all_could_read_is_closed_when_it_is_replaced(folder: Path) -> None:
    written(folder, "EXAM", "--solutions")
    for entry in (folder / "EXAM", *(folder / "EXAM").rglob("*")):
        entry.chmod(0o777 if entry.is_dir() else 0o666)
    written(folder, "EXAM", "--force")
    found = modes(folder / "EXAM")
    assert (found["."], found["key.jsonl"], found["solutions/007.pdf"]) == (0o700, 0o600, 0o600)


@posix
def test_what_is_being_written_is_closed_to_others_already(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from kinegrade.exam.generating import generate as module

    seen: list[int] = []
    write_head = module.write_head

    def look(head: Any, setting: Any, place: Path) -> None:
        seen.append(stat.S_IMODE(place.stat().st_mode))
        write_head(head, setting, place)

    monkeypatch.setattr(module, "write_head", look)
    with umask(0):
        written(folder, "EXAM")
    assert seen == [0o700]


@pytest.fixture
def earlier(tmp_path: Path) -> Path:
    """A copy of an exam folder that version 0.1 wrote with `--seed spring`, as far as it is
    text.
    """
    shutil.copytree(EARLIER, tmp_path / "EXAM")
    return tmp_path / "EXAM"


def test_the_secret_of_an_earlier_folder_is_the_seed_that_was_typed(earlier: Path) -> None:
    assert head(earlier)["seed"] == "spring"
    assert kept_secret(earlier) == FromWords("spring")


def test_an_earlier_folder_is_marked_told_and_exported(earlier: Path, tmp_path: Path) -> None:
    rows = table(earlier / "answers.csv")
    line = key_lines(earlier)[0]
    right = {
        f"{question['question']}.{name}": ask["decimal"]
        for question in line["questions"]
        for name, ask in question["asks"].items()
    }
    columns = list(rows[0])
    answers = tmp_path / "answers.csv"
    answers.write_text(
        ",".join(columns) + "\n007,x," + ",".join(right[name] for name in columns[2:]) + "\n",
        encoding="utf-8",
    )
    marks = tmp_path / "MARKS"
    assert kinegrade("grade", earlier, answers, "-o", marks).exit_code == 1  # the other is absent
    assert {row["student"]: row["total"] for row in table(marks / "grades.csv")}["007"] == "12.5"
    assert kinegrade("report", earlier, marks, "-o", tmp_path / "report.html").exit_code == 0
    feedback = kinegrade("feedback", earlier, marks, "-o", tmp_path / "F", "--format", "md")
    assert feedback.exit_code == 0
    pool = ("quiz", earlier, "--to", "moodle-xml", "--variants", "2", "-o", tmp_path / "pool.xml")
    assert kinegrade(*pool).exit_code < 2  # it says what Moodle cannot carry
    assert "<quiz>" in (tmp_path / "pool.xml").read_text(encoding="utf-8")
    assert kinegrade("export", marks, "--to", "generic", "-o", tmp_path / "g.csv").exit_code == 0


def test_an_earlier_folder_is_written_again_with_the_same_papers(
    earlier: Path, tmp_path: Path
) -> None:
    roster = tmp_path / "roster.csv"
    roster.write_text("student,name\n007,Ann\n0012,Bob\n013,Cy\n", encoding="utf-8")
    before = key_lines(earlier)
    # What templates no longer draw, such as a = 0, the bank has to draw
    with (earlier / "bank.toml").open("a", encoding="utf-8") as bank:
        bank.write("draw.a = [0, 1, 2, 3]\ndraw.phi = [30, 45, 60, 75, 105, 120, 135, 150]\n")
    again = "-o", earlier, "--force", "--accept-changes"
    result = kinegrade("generate", earlier / "bank.toml", roster, *again)
    assert result.exit_code == 0, result.stderr
    assert "2 papers keep their numbers, 0 changed, 0 gone, 1 new" in result.stderr
    after = key_lines(earlier)
    assert [line.pop("place") for line in after] == [0, 1, 2]
    for question in (question for line in after for question in line["questions"]):
        assert question.pop("drawn").keys() == question["parameters"].keys()
    for question in (question for line in (*after, *before) for question in line["questions"]):
        for ask in question["asks"].values():
            ask.pop("mistakes")  # of which more are known now
    assert after[:2] == before  # which version 0.1 kept without these
    assert head(earlier)["reproducible"] == "spring"


@pytest.mark.parametrize(
    "secret",
    [
        {"reproducible": None},
        {"secret": "00", "codes": "00", "label": ""},
        {"secret": "zz" * 32, "codes": "00" * 32, "label": ""},
        {"secret": "00" * 32, "codes": "00" * 32},
    ],
)
def test_an_exam_is_not_replaced_without_its_secret(
    folder: Path, secret: dict[str, str | None]
) -> None:
    written(folder, "EXAM", "--reproducible", "spring")
    changed = {**head(folder / "EXAM"), "reproducible": None, **secret}
    (folder / "EXAM" / "exam.json").write_text(json.dumps(changed), encoding="utf-8")
    result = generate(folder, "EXAM", "--force")
    assert result.exit_code == 2
    assert "exam.json: does not hold the secret that its numbers are drawn from - " in result.stderr
    assert result.stderr.rstrip().endswith(
        "restore the exam folder, choose another one, or add --new-numbers to replace its papers "
        "anyway"
    )


def test_the_demonstration_class_is_still_the_same_for_everybody(tmp_path: Path) -> None:
    """The words of `make demo` draw what the seed of earlier versions drew."""
    assert generate(write_class(tmp_path), "EXAM").exit_code == 0
    assert codes(tmp_path / "EXAM")[0] == "WJPK-SNPQ"
