"""`generate --force` over an exam that is printed: no paper, no solution, no typed answer is lost
without a word.
"""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest
from click.testing import Result

from tests.small_class import contents, key_lines, kinegrade

BANK = """title = "Quiz"
course = "Mechanics"
{more}
[[questions]]
template = "slider-crank"
asks = {{ v_B = {points}, a_B = 2 }}
"""


def write_inputs(folder: Path, students: str, points: int = 3, more: str = "") -> None:
    (folder / "bank.toml").write_text(BANK.format(points=points, more=more), encoding="utf-8")
    rows = "".join(f"{student},Student {student}\n" for student in students)
    (folder / "roster.csv").write_text("student,name\n" + rows, encoding="utf-8")


def generate(folder: Path, *options: str) -> Result:
    files = folder / "bank.toml", folder / "roster.csv"
    return kinegrade("generate", *files, "-o", folder / "EXAM", *options)


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with an EXAM for the students a, b and c; not to be changed."""
    folder = tmp_path_factory.mktemp("made")
    write_inputs(folder, "abc")
    assert generate(folder, "--seed", "spring").exit_code == 0
    return folder


@pytest.fixture
def folder(made: Path, tmp_path: Path) -> Path:
    """The same folder, to be changed."""
    return Path(shutil.copytree(made, tmp_path, dirs_exist_ok=True))


def refused(folder: Path, *options: str) -> str:
    """The one line of a refusal, as `refusals` gives them."""
    (line,) = refusals(folder, *options)
    return line


def refusals(folder: Path, *options: str) -> list[str]:
    """The lines of a refusal; the exam folder stays as it was, byte for byte."""
    before = contents(folder / "EXAM")
    names = sorted(entry.name for entry in folder.iterdir())
    result = generate(folder, "--force", *options)
    assert result.exit_code == 2
    assert contents(folder / "EXAM") == before
    assert sorted(entry.name for entry in folder.iterdir()) == names
    return result.stderr.splitlines()


def test_an_exam_that_changed_after_it_was_read_is_not_replaced(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def come_between(*_: object) -> None:
        (folder / "EXAM" / "exam.json").touch()

    monkeypatch.setattr("kinegrade.exam.generating.generate.require_languages", come_between)
    assert "changed while this command ran, perhaps by another one" in refused(folder)


def test_a_printed_exam_keeps_its_numbers(folder: Path) -> None:
    before = contents(folder / "EXAM")
    result = generate(folder, "--force")
    assert result.exit_code == 0
    assert contents(folder / "EXAM") == before
    assert "EXAM: 3 papers keep their numbers, 0 changed, 0 gone, 0 new" in result.stderr


def test_a_late_student_changes_nobodys_paper(folder: Path) -> None:
    before = key_lines(folder / "EXAM")
    write_inputs(folder, "abcd")
    result = generate(folder, "--force", "--seed", "spring")
    assert result.exit_code == 0
    assert key_lines(folder / "EXAM")[:3] == before
    assert "EXAM: 3 papers keep their numbers, 0 changed, 0 gone, 1 new" in result.stderr


def test_a_changed_bank_does_not_change_printed_papers(folder: Path) -> None:
    write_inputs(folder, "abcd", points=4)
    line = refused(folder)
    assert "EXAM: 3 of 3 papers would change and 0 would be gone (a, b, c), 1 be new - " in line
    assert line.endswith("or add --new-numbers to replace the papers")


def test_another_label_does_not_change_printed_papers(folder: Path) -> None:
    assert "3 of 3 papers would change" in refused(folder, "--seed", "autumn")
    assert "3 of 3 papers would change" in refused(folder, "--reproducible", "spring")


def test_a_student_whose_paper_is_printed_is_not_dropped(folder: Path) -> None:
    write_inputs(folder, "ac")
    line = refused(folder)
    assert "EXAM: 0 of 3 papers would change and 1 would be gone (b), 0 be new - " in line
    assert (
        "and every student in the roster, also who was assigned a spare paper or withdrew (exports leave alone"
        in line
    )
    assert "give changed ids by kinegrade exchange --new-id" in line


def test_new_numbers_are_drawn_where_they_are_wanted(folder: Path) -> None:
    before = key_lines(folder / "EXAM")
    secret = json.loads((folder / "EXAM" / "exam.json").read_text(encoding="utf-8"))["secret"]
    write_inputs(folder, "bcd")
    result = generate(folder, "--force", "--new-numbers")
    assert result.exit_code == 0
    assert "EXAM: 0 papers keep their numbers, 2 changed, 1 gone, 1 new" in result.stderr
    after = key_lines(folder / "EXAM")
    assert not {line["paper"] for line in before} & {line["paper"] for line in after}
    assert secret not in (folder / "EXAM" / "exam.json").read_text(encoding="utf-8")


def test_solutions_stay_when_they_are_not_asked_for_again(folder: Path) -> None:
    assert generate(folder, "--force", "--solutions").exit_code == 0
    before = contents(folder / "EXAM")
    assert "solutions/a.pdf" in before
    write_inputs(folder, "abcd")
    result = generate(folder, "--force")
    assert result.exit_code == 0
    after = contents(folder / "EXAM")
    assert {name: data for name, data in after.items() if name.startswith("solutions")} == {
        name: data for name, data in before.items() if name.startswith("solutions")
    }
    assert "EXAM: solutions stays as it was, without papers that are new" in result.stderr
    assert "EXAM: solutions.pdf stays as it was, without papers that are new" in result.stderr


def test_solutions_of_replaced_papers_do_not_stay_as_if_they_were_right(folder: Path) -> None:
    assert generate(folder, "--force", "--solutions").exit_code == 0
    result = generate(folder, "--force", "--new-numbers")
    assert result.exit_code == 0
    assert not (folder / "EXAM" / "solutions").exists()
    assert "solutions belonged to the papers that were replaced, and is gone" in result.stderr


def test_the_key_of_a_pool_stays_with_the_numbers(folder: Path) -> None:
    pool = folder / "EXAM" / "variants.jsonl"
    pool.write_text("{}\n", encoding="utf-8")
    result = generate(folder, "--force")
    assert (result.exit_code, pool.read_text(encoding="utf-8")) == (0, "{}\n")
    assert "variants.jsonl stays as it was\n" in result.stderr
    result = generate(folder, "--force", "--new-numbers")
    assert (result.exit_code, pool.exists()) == (0, False)
    assert "variants.jsonl belonged to the papers that were replaced, and is gone" in result.stderr


@pytest.mark.parametrize("options", [(), ("--new-numbers",)])
def test_typed_answers_are_not_overwritten_by_a_blank_sheet(
    folder: Path, options: tuple[str, ...]
) -> None:
    sheet = folder / "EXAM" / "answers.csv"
    sheet.write_text("student,name,q1.v_B,q1.a_B\na,x,,\nb,y,1.5,\nc,z,,\n", encoding="utf-8")
    line = refused(folder, *options)
    assert (
        "EXAM: holds answers.csv, edited or added since it was generated, which would be lost"
        in line
    )
    assert line.endswith("move it elsewhere or choose another folder")


def test_typed_answers_are_seen_before_anything_is_drawn(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def draw(*arguments: object) -> None:
        raise AssertionError("work was done in vain")

    monkeypatch.setattr("kinegrade.exam.generating.generate.deal_exam", draw)
    sheet = folder / "EXAM" / "answers.csv"
    sheet.write_text("student,name,q1.v_B,q1.a_B\na,x,1,\n", encoding="utf-8")
    assert "holds answers.csv" in refused(folder)


def test_an_unreadable_answer_sheet_is_not_taken_for_a_blank_one(folder: Path) -> None:
    (folder / "EXAM" / "answers.csv").write_bytes(b"PK\x03\x04")
    assert "holds answers.csv" in refused(folder)


def test_a_blank_sheet_that_a_spreadsheet_saved_again_holds_nothing(folder: Path) -> None:
    sheet = folder / "EXAM" / "answers.csv"
    sheet.write_bytes(b"\xef\xbb\xbfstudent;name;q1.v_B;q1.a_B\r\na;x;;\r\n")
    assert generate(folder, "--force").exit_code == 0


def test_a_paper_edited_in_word_is_not_overwritten(folder: Path) -> None:
    (folder / "EXAM" / "papers" / "a.docx").write_bytes(b"an own question")
    assert "holds papers/a.docx, edited or added since it was generated" in refused(folder)


def test_a_bank_edited_in_the_folder_is_not_overwritten(folder: Path) -> None:
    kept = folder / "EXAM" / "bank.toml"
    kept.write_text(kept.read_text(encoding="utf-8") + "# mine\n", encoding="utf-8")
    assert "holds bank.toml, edited or added since it was generated" in refused(folder)
    again = kinegrade(
        "generate",
        kept,
        folder / "roster.csv",
        "-o",
        folder / "EXAM",
        "--force",
    )
    assert again.exit_code == 0  # the edited bank is the one that was asked for
    assert kept.read_text(encoding="utf-8").endswith("# mine\n")


def test_a_remark_added_to_the_bank_is_no_reason_to_refuse(folder: Path) -> None:
    write_inputs(folder, "abc", more="# a remark\n")
    assert generate(folder, "--force").exit_code == 0


@pytest.mark.left(beside="test_a_paper_edited_in_word_is_not_overwritten")
@pytest.mark.needs_tex
def test_edited_sources_are_not_overwritten(folder: Path) -> None:
    assert generate(folder, "--force", "--engine", "latex").exit_code == 0
    assert generate(folder, "--force", "--engine", "latex").exit_code == 0
    source = sorted((folder / "EXAM" / "tex").rglob("*.tex"))[0]
    source.write_text(source.read_text(encoding="utf-8") + "% mine\n", encoding="utf-8")
    name = source.relative_to(folder / "EXAM").as_posix()
    assert f"holds {name}, edited or added since" in refused(folder, "--engine", "latex")
    assert f"holds {name}, edited or added since" in refused(folder)


def test_sources_of_a_folder_that_does_not_say_what_was_generated_are_not_overwritten(
    folder: Path,
) -> None:
    path = folder / "EXAM" / "exam.json"
    head = json.loads(path.read_text(encoding="utf-8"))
    del head["editable"]
    path.write_text(json.dumps(head), encoding="utf-8")
    write_inputs(folder, "abc", more="# the bank may have another text\n")
    (folder / "EXAM" / "tex").mkdir()
    (folder / "EXAM" / "tex" / "a.tex").write_text("mine", encoding="utf-8")
    assert "holds tex/a.tex, edited or added since" in refused(folder)
    (folder / "EXAM" / "tex" / "a.tex").unlink()
    assert generate(folder, "--force").exit_code == 0


@pytest.mark.parametrize("text", ["not a key", '{"student": "a"}\n', "[]\n"])
def test_an_exam_whose_key_is_damaged_is_replaced_on_purpose_only(folder: Path, text: str) -> None:
    (folder / "EXAM" / "key.jsonl").write_text(text, encoding="utf-8")
    (folder / "EXAM" / "variants.jsonl").write_text("{}\n", encoding="utf-8")
    line = refused(folder)
    assert "key.jsonl: line 1: is broken (" in line
    assert line.endswith("choose another one, or add --new-numbers to replace its papers anyway")
    result = generate(folder, "--force", "--new-numbers")
    assert result.exit_code == 0
    assert "variants.jsonl belonged to the papers that were replaced" in result.stderr
    assert "EXAM: the exam that stood there could not be read, so nothing is" in result.stderr
    assert "3 new" not in result.stderr


def test_an_exam_without_its_key_is_replaced_on_purpose_only(folder: Path) -> None:
    (folder / "EXAM" / "key.jsonl").unlink()
    assert "key.jsonl: cannot be read (No such file or directory)" in refused(folder)


def test_an_exam_without_its_secret_is_replaced_on_purpose_only(folder: Path) -> None:
    head = folder / "EXAM" / "exam.json"
    record = json.loads(head.read_text(encoding="utf-8"))
    head.write_text(json.dumps(record | {"secret": ""}), encoding="utf-8")
    assert "exam.json: does not hold the secret" in refused(folder)
    assert generate(folder, "--force", "--new-numbers").exit_code == 0


def test_the_words_of_a_reproducible_exam_are_kept(folder: Path) -> None:
    assert generate(folder, "--force", "--new-numbers", "--reproducible", "w").exit_code == 0
    before = contents(folder / "EXAM")
    for options in ((), ("--seed", "w"), ("--reproducible", "w")):
        assert generate(folder, "--force", *options).exit_code == 0
        assert contents(folder / "EXAM") == before
    assert "3 of 3 papers would change" in refused(folder, "--seed", "other")


@pytest.mark.parametrize("lines", [0, 2])
def test_a_printed_paper_that_the_key_has_lost_is_not_replaced_as_if_it_were_new(
    folder: Path, lines: int
) -> None:
    key = folder / "EXAM" / "key.jsonl"
    key.write_text("".join(key.read_text(encoding="utf-8").splitlines(keepends=True)[:lines]))
    write_inputs(folder, "abc", points=4)
    remedy = (
        "expected one - restore the exam folder as it was generated, choose another one, or add "
        "--new-numbers to replace its papers anyway"
    )
    lost = [f'error: {key}: no line for student "{each}" - {remedy}' for each in "abc"[lines:]]
    assert refusals(folder) == lost


def test_an_exam_that_does_not_say_who_has_a_paper_is_replaced_on_purpose_only(
    folder: Path,
) -> None:
    head = folder / "EXAM" / "exam.json"
    record = json.loads(head.read_text(encoding="utf-8"))
    head.write_text(json.dumps(record | {"students": 3}), encoding="utf-8")
    assert "exam.json:1: students: 3 - expected a list - restore" in refused(folder)


def test_numbers_that_can_be_guessed_are_not_kept_without_a_word(folder: Path) -> None:
    """Exams of earlier versions were drawn from words that somebody typed, like "spring"."""
    head = folder / "EXAM" / "exam.json"
    record = json.loads(head.read_text(encoding="utf-8"))
    for name in ("secret", "label", "codes"):
        del record[name]
    head.write_text(json.dumps(record | {"seed": "spring"}), encoding="utf-8")
    words = generate(folder, "--force", "--new-numbers", "--reproducible", "spring")
    assert words.exit_code == 0
    again = generate(folder, "--force")
    said = f"{folder}/EXAM: keeps numbers that come from words: anyone who guesses these words can print"
    assert [line for line in again.stderr.splitlines() if line.startswith(said)]
    assert "come from words" not in generate(folder, "--force", "--new-numbers").stderr


@pytest.mark.parametrize("name", ["papers/notes.txt", "templates/sketch.pdf"])
def test_own_files_beside_the_papers_are_not_lost(folder: Path, name: str) -> None:
    (folder / "EXAM" / name).write_text("mine", encoding="utf-8")
    for options in ((), ("--new-numbers",)):
        assert refused(folder, *options) == (
            f"error: {folder}/EXAM: holds {name}, edited or added since it was generated, which "
            "would be lost - expected only what is written again - move it elsewhere or choose "
            "another folder"
        )
