"""A quiz that is one student's paper is in the student's language."""

from __future__ import annotations

from pathlib import Path
from zipfile import ZipFile

import pytest

from kinegrade.lms.quiz.formats import FORMATS
from tests.small_class import generate, kinegrade, write_class

BANK = """title = { en = "Midterm", zh = "期中测验" }
course = { en = "Mechanics", zh = "力学" }
tolerance = { relative = "1 %" }
VERSIONS
[[questions]]
template = "slider-crank"
asks = { v_B = 3 }
"""
ROSTER = "student,name,language\n007,Ann,\n0012,Wei,zh\n"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return write_exam(tmp_path)


def write_exam(folder: Path, versions: str = "") -> Path:
    write_class(folder)
    (folder / "bank.toml").write_text(BANK.replace("VERSIONS", versions), encoding="utf-8")
    (folder / "roster.csv").write_text(ROSTER, encoding="utf-8")
    assert generate(folder, "EXAM", "--no-papers").exit_code == 0
    return folder


def put(folder: Path, system: str, *options: str) -> tuple[dict[str, str], list[str]]:
    """The texts of a quiz by their files, and what is said."""
    target = folder / "QUIZ"
    result = kinegrade("quiz", folder / "EXAM", "--to", system, "-o", target, *options)
    assert result.exit_code in (0, 1), result.stderr
    said = result.stderr.splitlines()
    if system in ("moodle-xml", "blackboard"):
        return {"": target.read_text(encoding="utf-8")}, said
    with ZipFile(target) as package:
        names = [name for name in package.namelist() if name.endswith((".xml", ".txt"))]
        return {name: package.read(name).decode() for name in names}, said


@pytest.mark.parametrize("system", FORMATS)
def test_each_student_has_it_in_the_own_language(folder: Path, system: str) -> None:
    texts, _ = put(folder, system)
    together = "\n".join(texts.values())
    assert "曲柄" in together
    assert "crank" in together
    chinese = [text for text in texts.values() if "曲柄" in text]
    if system == "qti12":
        assert ["期中测验 · " in text and "Midterm" not in text for text in chinese] == [True]


@pytest.mark.parametrize("system", FORMATS)
def test_another_language_is_for_everybody(folder: Path, system: str) -> None:
    texts, said = put(folder, system, "--lang", "en")
    assert [text for text in texts.values() if "曲柄" in text] == []
    assert [line for line in said if "in another language" in line] == []


@pytest.mark.parametrize("versions", ["", "versions = 2"])
def test_of_a_quiz_for_several_it_is_said_whose_language_it_has_not(
    tmp_path: Path, versions: str
) -> None:
    folder = write_exam(tmp_path, versions)
    texts, said = put(folder, "qti12", *(() if versions else ("--variants", "2")))
    assert [text for text in texts.values() if "曲柄" in text] == []
    assert [line for line in said if "in another language" in line] == [
        f"complaint: {folder}/QUIZ: 1 student has papers in another language (0012) than this quiz "
        "(en), which is put to several - write one in each language with --lang"
    ]
