"""Rosters with what nobody sees: characters without width inside ids, signs that turn the direction
of a name, ids of which a spreadsheet has kept fifteen digits; through the command line.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.small_class import generate, kinegrade, write_short_class

UNSEEN = "00\u200b12"


def write_roster(folder: Path, *lines: str) -> Path:
    """A roster of these lines, with the header."""
    file = folder / "roster.csv"
    file.write_text("\n".join(("student,name", *lines)) + "\n", encoding="utf-8")
    return file


@pytest.mark.parametrize("unseen", ["\u200b", "\u00ad", "\u2060", "\ufeff", "\u202d", "\u2066"])
def test_two_ids_that_look_the_same_are_one(tmp_path: Path, unseen: str) -> None:
    result = kinegrade("roster", write_roster(tmp_path, "0012,Ann", f"00{unseen}12,Ben"))
    assert result.exit_code == 2
    assert 'student id "0012" stands on lines 2 and 3' in result.stderr


def test_what_is_not_seen_in_an_id_is_left_out_and_said(tmp_path: Path) -> None:
    result = kinegrade("roster", write_roster(tmp_path, f"{UNSEEN},Ann", "0013,Ben"))
    assert result.exit_code == 0, result.stderr
    assert "1 id has characters that cannot be seen" in result.output
    assert '"0012" Ann' in result.output


def test_an_answer_beside_such_an_id_is_that_students(tmp_path: Path) -> None:
    write_short_class(tmp_path)
    write_roster(tmp_path, "0012,Ann", "0013,Ben")
    assert generate(tmp_path).exit_code == 0
    sheet = tmp_path / "EXAM" / "answers.csv"
    filled = sheet.read_text(encoding="utf-8-sig").replace("0012,", f"{UNSEEN},")
    (tmp_path / "answers.csv").write_text(filled.replace(",,", ",1,"), encoding="utf-8")
    marked = kinegrade(
        "grade", tmp_path / "EXAM", tmp_path / "answers.csv", "-o", tmp_path / "MARKS"
    )
    grades = (tmp_path / "MARKS" / "grades.csv").read_text(encoding="utf-8-sig")
    assert "0012" in grades
    assert "absent" not in grades, marked.stderr


def test_a_name_does_not_turn_what_is_printed_behind_it(tmp_path: Path) -> None:
    """Joiners stay, as Persian names are written with them."""
    persian = "علی\u200cرضا"
    write_short_class(tmp_path)
    write_roster(tmp_path, "0012,Ann \u202eByron", f"0013,{persian}")
    result = generate(tmp_path)
    assert "1 name has signs that turn the direction" in result.stderr
    head = (tmp_path / "EXAM" / "exam.json").read_text(encoding="utf-8")
    assert '"Ann Byron"' in head
    assert persian in head
    assert "\u202e" not in head


def test_a_room_that_looks_the_same_is_the_same(tmp_path: Path) -> None:
    write_short_class(tmp_path)
    lines = "student,name,room\n0012,Ann,Hall\u200b 7\n0013,Ben,Hall 7\n"
    (tmp_path / "roster.csv").write_text(lines, encoding="utf-8")
    assert generate(tmp_path).exit_code == 0
    assert [each.name for each in (tmp_path / "EXAM" / "rooms").iterdir()] == ["Hall-7.pdf"]


@pytest.mark.parametrize(
    ("ids", "refused"),
    [
        (("11010119900101000", "11010119900102000"), True),
        (("11010119900101000", "11010119900102001"), False),
        (("1101011990010100", "1101011990010200"), False),  # two zeros come by chance
        (("110101199001010", "110101199001020"), False),
    ],
)
def test_ids_of_which_fifteen_digits_were_kept_are_refused(
    tmp_path: Path, ids: tuple[str, str], *, refused: bool
) -> None:
    roster = write_roster(tmp_path, f"{ids[0]},Ann", f"{ids[1]},Ben")
    result = kinegrade("roster", roster)
    assert result.exit_code == (2 if refused else 0), result.stderr
    said = f'student id "{ids[0]}" has zeros behind fifteen digits'
    assert (said in result.stderr) is refused
    assert kinegrade("roster", roster, "--allow-odd-ids").exit_code == 0
