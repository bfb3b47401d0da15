"""`generate --force` with a roster, a bank, templates or options that are not those of the exam: the
numbers stay, and nothing else changes without a word.
"""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path

import pytest
from click.testing import Result

from kinegrade.problem.template.library.library import load_template
from tests.small_class import contents, key_lines, kinegrade

ROSTER = """student,name,email,room,language,extra time
a,Student a,a@example.org,H1,zh,25 %
b,Student b,b@example.org,H1,,
c,Student c,,H2,,
"""
OWN = '[[questions]]\ntemplate = "own.toml"\nasks = { v_B = 3 }\n'


def generate(folder: Path, *options: str) -> Result:
    files = folder / "bank.toml", folder / "roster.csv"
    return kinegrade("generate", *files, "-o", folder / "EXAM", *options)


def refused(folder: Path, *options: str) -> str:
    """The one line of a refusal; the exam folder stays as it was, byte for byte."""
    before = contents(folder / "EXAM")
    result = generate(folder, "--force", *options)
    assert (result.exit_code, contents(folder / "EXAM")) == (2, before)
    (line,) = result.stderr.splitlines()
    return line


@pytest.fixture(scope="module")
def roomy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with an EXAM of a template of its own, for a class of which more than names is
    known; not to be changed.
    """
    folder = tmp_path_factory.mktemp("roomy")
    shipped = load_template("slider-crank").file.text
    (folder / "own.toml").write_text(shipped, encoding="utf-8")
    (folder / "bank.toml").write_text(f'title = "Quiz"\ncourse = "Mechanics"\n\n{OWN}')
    (folder / "roster.csv").write_text(ROSTER, encoding="utf-8")
    assert generate(folder, "--seed", "spring").exit_code == 0
    return folder


@pytest.fixture
def known(roomy: Path, tmp_path: Path) -> Path:
    """The same folder, to be changed."""
    return Path(shutil.copytree(roomy, tmp_path, dirs_exist_ok=True))


def test_the_same_roster_and_bank_change_nothing(known: Path) -> None:
    before = contents(known / "EXAM")
    result = generate(known, "--force")
    assert result.exit_code == 0
    assert contents(known / "EXAM") == before
    assert "the numbers stay" not in result.stderr


def test_a_roster_that_knows_less_takes_nothing_from_papers(known: Path) -> None:
    write_roster(known, "student,name\na,Student a\nb,Student b\nc,Student c\n")
    assert refused(known) == (
        f"error: {known}/EXAM: the numbers stay, and this would change: email of 2 students "
        "(a, b); room of 3 students (a, b, c); language of 1 student (a); extra-time of 1 student "
        "(a) - expected the papers as they may have been printed - give bank, templates, roster "
        "and options as they were (kinegrade reprint corrects a text), or add --accept-changes if "
        "no paper has been handed out"
    )


def test_what_changes_on_purpose_is_said_and_the_numbers_stay(known: Path) -> None:
    before = key_lines(known / "EXAM")
    write_roster(known, ROSTER.replace("H2", "H3"))
    result = generate(known, "--force", "--accept-changes")
    assert result.exit_code == 0
    assert "the numbers stay, and this changed: room of 1 student (c)\n" in result.stderr
    assert key_lines(known / "EXAM") == before
    head = json.loads((known / "EXAM" / "exam.json").read_text(encoding="utf-8"))
    assert head["students"][2]["room"] == "H3"


def test_an_address_that_was_not_known_changes_no_paper(known: Path) -> None:
    write_roster(known, ROSTER.replace("c,Student c,,", "c,Student c,c@example.org,"))
    assert generate(known, "--force").exit_code == 0
    assert "c@example.org" in (known / "EXAM" / "exam.json").read_text(encoding="utf-8")


def test_the_language_of_the_exam_is_that_of_its_papers(known: Path) -> None:
    assert "this would change: language of 2 students (b, c) - " in refused(known, "--lang", "zh")
    assert "this would change: the paper size, a4, to letter - " in refused(
        known, "--paper-size", "letter"
    )


def test_a_corrected_template_is_not_undone(known: Path) -> None:
    text = (known / "own.toml").read_text(encoding="utf-8")
    place = known / "corrected"
    place.mkdir()
    corrected = re.sub('en = "(?=[A-Z])', 'en = "Look: ', text)
    assert corrected != text
    (place / "own.toml").write_text(corrected, encoding="utf-8")
    again = kinegrade("reprint", known / "EXAM", "--template", place / "own.toml")
    assert again.exit_code == 0
    assert "this would change: templates/own.toml (" in refused(known)
    shutil.copy(place / "own.toml", known)
    assert generate(known, "--force").exit_code == 0


def test_a_bank_with_another_title_prints_other_papers(known: Path) -> None:
    bank = known / "bank.toml"
    text = bank.read_text(encoding="utf-8")
    bank.write_text(text.replace('"Quiz"', '"Test"') + "# a remark\n", encoding="utf-8")
    assert "this would change: bank.toml (title) - " in refused(known)
    assert generate(known, "--force", "--solutions", "--accept-changes").exit_code == 0
    bank.write_text(text, encoding="utf-8")
    result = generate(known, "--force", "--accept-changes")
    assert "this changed: bank.toml (title)\n" in result.stderr
    assert "solutions belonged to the papers that were replaced, and is gone" in result.stderr


def test_another_logo_prints_other_papers(known: Path) -> None:
    (known / "EXAM" / "logo.svg").write_text("<svg/>", encoding="utf-8")
    assert "this would change: logo.svg - " in refused(known)


def write_roster(folder: Path, rows: str) -> None:
    (folder / "roster.csv").write_text(rows, encoding="utf-8")
