"""The recipes "Add a learning management system" of CONTRIBUTING, followed on a copy for a system
that does not exist; each of their steps left out, one by one, is refused by name.
"""

from __future__ import annotations

import csv
import shutil
from collections.abc import Mapping
from functools import partial
from pathlib import Path

import pytest

from tests.language.catalogue_faults import find_catalogue_faults
from tests.lms.marked_folder import write_marks
from tests.lms.proofs import find_unproved
from tests.recipes.recipe import Step, edit, follow_steps, read_titles, run

NAME = "scroll"
TABLE = """from kinegrade.lms.grades.dialect import Column, Dialect, NewFile

SCROLL = Dialect(
    name="Scroll",
    places=2,
    new_file=NewFile(
        columns=(Column("Pupil", "id"), Column("{title}", "grade")), key="id", title="Mark"
    ),
)
"""
WRITER = """from kinegrade.files.output import output_file
from kinegrade.lms.quiz.intervals import turn_next_to_zero
from kinegrade.lms.quiz.typing_words import write_rules


def write(quiz, target, *, force=False):
    with output_file(target, force=force) as partial, partial.open("x") as stream:
        for paper in quiz.papers:
            for question in paper.questions:
                print(write_rules(question, "scroll", quiz.language), file=stream)
                for ask in question.asks:
                    right = turn_next_to_zero(ask)
                    print(ask.identifier, right.low_text, right.high_text, file=stream)
    return []
"""
READER = """from kinegrade.language.message import Message
from kinegrade.lms.responses.forms.form_rows import form_rows

TITLE = Message("responses.scroll")


def recognises(header):
    return header[0] == "Scroll"


def read(table, head, attempts):
    return form_rows(table, head, questions=range(1, len(table.header)), known={})
"""
SENTENCE = "Carve <digits> digits."
NOUN = {"en": 0, "zh": 1, "de": 4}  # its forms; those of English stand in the msgid
TEXT = {"en": 0, "zh": 1, "de": 1}


def write_table(room: Path) -> None:
    (room / f"kinegrade/lms/grades/systems/{NAME}.py").write_text(TABLE, encoding="utf-8")


def add_system(room: Path) -> None:
    edit(
        room / "kinegrade/lms/grades/systems/__init__.py",
        (
            "\nSYSTEMS: Mapping[str, Dialect] = {\n",
            f"from kinegrade.lms.grades.systems.{NAME} import SCROLL\n\n"
            f'SYSTEMS: Mapping[str, Dialect] = {{\n    "{NAME}": SCROLL,\n',
        ),
    )


def prove_system(room: Path) -> None:
    for place in (f"golden/lms/{NAME}.csv", f"lms/test_{NAME}.py"):
        (room / "tests" / place).parent.mkdir(parents=True, exist_ok=True)
        (room / "tests" / place).touch()


def export(room: Path) -> str:
    return run(room, "export", "MARKS", "--to", NAME, "-o", "out.csv", "--force").stderr


def look_for_proofs(room: Path) -> str:
    return "\n".join(find_unproved((NAME,), room / "tests"))


GRADES = (
    Step("The table", write_table, "No module named 'kinegrade.lms.grades.systems.scroll'", export),
    Step("Its row", add_system, "'scroll' is not one of 'moodle', 'canvas'", export),
    Step("Its proof", prove_system, "golden/lms/scroll.csv: missing", look_for_proofs),
)


def write_writer(room: Path) -> None:
    (room / f"kinegrade/lms/quiz/{NAME}.py").write_text(WRITER, encoding="utf-8")


def add_typing(room: Path) -> None:
    edit(
        room / "kinegrade/lms/quiz/typing_words.py",
        ('Typing = Literal["moodle", ', f'Typing = Literal["{NAME}", "moodle", '),
        (
            "    match typing:\n",
            f'    match typing:\n        case "{NAME}":\n'
            f'            return Message("quiz.type-in-{NAME}", digits=digits)\n',
        ),
    )


def add_entries(domain: str, head: str, english: str, forms: Mapping[str, int], room: Path) -> None:
    """An entry of every catalogue, in as many forms as each has."""
    for language, count in forms.items():
        file = room / f"kinegrade/language/catalogues/{language}/{domain}.po"
        entry = f'\n{head}\nmsgid "{english}"\nmsgstr "{"|".join([english] * count)}"\n'
        file.write_text(file.read_text(encoding="utf-8") + entry, encoding="utf-8")


add_sentence = partial(add_entries, "quiz", f'msgctxt "type-in-{NAME}"', SENTENCE, TEXT)
add_title = partial(add_entries, "responses", f'#, noun\nmsgctxt "{NAME}"', "a scroll", NOUN)


def add_format(room: Path) -> None:
    edit(
        room / "kinegrade/lms/quiz/formats.py",
        (
            "\n\nclass Writer(Protocol)",
            f"from kinegrade.lms.quiz import {NAME}\n\n\nclass Writer(Protocol)",
        ),
        ('    "qti12":', f'    "{NAME}": _always({NAME}.write),\n    "qti12":'),
    )


def quiz(room: Path) -> str:
    return run(room, "quiz", "EXAM", "--to", NAME, "-o", "quiz.txt", "--force", "--jobs", 1).stderr


QUIZ = (
    Step("The writer", write_writer, "cannot import name 'scroll'", quiz),
    Step("How a number is typed", add_typing, "unreachable, but got: 'scroll'", quiz),
    Step("Its sentence", add_sentence, "quiz.type-in-scroll", quiz),
    Step("Its row", add_format, "'scroll' is not one of 'moodle-xml', 'qti12'", quiz),
)


def write_reader(room: Path) -> None:
    (room / f"kinegrade/lms/responses/{NAME}.py").write_text(READER, encoding="utf-8")


def add_source(room: Path) -> None:
    edit(
        room / "kinegrade/lms/responses/detection.py",
        (
            "from kinegrade.lms.responses import canvas",
            f"from kinegrade.lms.responses import {NAME}, canvas",
        ),
        (
            '    "moodle": Dialect',
            f'    "{NAME}": Dialect({NAME}.TITLE, {NAME}.recognises, {NAME}.read),\n'
            '    "moodle": Dialect',
        ),
    )


def grade(room: Path) -> str:
    with (room / "EXAM" / "answers.csv").open(encoding="utf-8-sig", newline="") as stream:
        header, *rows = csv.reader(stream)
    asks = header[2:]
    with (room / "scroll.csv").open("w", encoding="utf-8", newline="") as stream:
        csv.writer(stream).writerow(["Scroll", "student", *(f"[{column}]" for column in asks)])
        csv.writer(stream).writerows([["1", row[0], *("1" for _ in asks)] for row in rows])
    return run(room, "grade", "EXAM", "scroll.csv", "--from", NAME, "-o", "MARKS", "--force").stderr


def detect(room: Path) -> str:
    grade(room)
    return run(room, "grade", "EXAM", "scroll.csv", "-o", "MARKS", "--force").stderr


RESPONSES = (
    Step("The reader", write_reader, "cannot import name 'scroll'", grade),
    Step(
        "What its files are called",
        add_title,
        "responses.scroll",
        detect,
    ),
    Step("Its row", add_source, "'scroll' is not one of 'moodle', 'canvas'", grade),
)


@pytest.mark.parametrize(
    ("heading", "steps"),
    [
        ("Grades for another system", GRADES),
        ("A quiz for another system", QUIZ),
        ("Answers from another system", RESPONSES),
    ],
)
def test_the_steps_are_those_of_the_recipe(heading: str, steps: tuple[Step, ...]) -> None:
    assert [step.title for step in steps] == read_titles(heading)


@pytest.fixture
def room(tmp_path: Path, small_class: Path) -> Path:
    """A folder with an EXAM and MARKS, into which the package will be copied."""
    shutil.copytree(small_class / "EXAM", tmp_path / "EXAM")
    write_marks(tmp_path / "MARKS")
    return tmp_path


@pytest.mark.left(beside="test_a_quiz_without_a_step")
def test_grades_quizzes_and_answers_of_the_new_system(room: Path) -> None:
    follow_steps(room, (*GRADES, *QUIZ, *RESPONSES))
    assert "out.csv: grades of 3 students for Scroll" in export(room)
    assert (room / "out.csv").read_text(encoding="utf-8").splitlines()[:2] == [
        "Pupil,Mark",
        "0012345,8.25",
    ]
    assert "quiz.txt: written" in quiz(room)
    assert "Carve four digits." in (room / "quiz.txt").read_text(encoding="utf-8")
    assert "scroll.csv: taken for a scroll" in detect(room)
    assert "--from {scroll|moodle|" in run(room, "grade", "--help").stdout.replace("[", "{")
    for language in ("zh", "de"):
        catalogues = room / "kinegrade/language/catalogues"
        assert list(find_catalogue_faults(catalogues / language, catalogues / "en")) == []


@pytest.mark.sampled(3, by="missing")
@pytest.mark.parametrize("missing", GRADES, ids=lambda step: step.title)
def test_grades_without_a_step(room: Path, missing: Step) -> None:
    assert missing.refused in missing.ask(follow_steps(room, GRADES, missing))


@pytest.mark.sampled(3, by="missing")
@pytest.mark.parametrize("missing", QUIZ, ids=lambda step: step.title)
def test_a_quiz_without_a_step(room: Path, missing: Step) -> None:
    assert missing.refused in missing.ask(follow_steps(room, QUIZ, missing))
    assert not (room / "quiz.txt").exists()


@pytest.mark.sampled(3, by="missing")
@pytest.mark.parametrize("missing", RESPONSES, ids=lambda step: step.title)
def test_answers_without_a_step(room: Path, missing: Step) -> None:
    assert missing.refused in missing.ask(follow_steps(room, RESPONSES, missing))
