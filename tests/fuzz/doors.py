"""The doors through which files come in: for each the file that is damaged, and the command that
reads it.
"""

from __future__ import annotations

import csv
import shutil
from dataclasses import dataclass
from pathlib import Path
from random import Random
from zipfile import ZIP_DEFLATED, ZipFile

from openpyxl import Workbook

from tests.fuzz.mutations import mutated
from tests.problem.crank import crank_text
from tests.small_class import kinegrade

STUDENTS = ("007", "0012", "S9", "x-4")
ROSTER = 'student,name,email\n007,王伟,wei@example.org\n0012,"O\'Neil, Zoë",\nS9,Bo,\nx-4,Ann,\n'
BANK = """title = { en = "Midterm", zh = "期中测验" }
course = "Mechanics"
date = 2026-05-01
tolerance = { relative = "1 %" }

[[questions]]
template = "crank.toml"
draw = { h = [1, 2], r = [3, 4, 5], omega = [2, 3, 4] }
asks = { v_x = 1, v_y = { points = 2, tolerance = { absolute = 0.25 } } }
"""
POLICY = """tolerance = { relative = "2 %" }

[questions.q1]
tolerance = { figures = 2 }

[questions.q1.asks.v_x]
void = "full"
"""
ANSWERS = "student,name,q1.v_x,q1.v_y\n007,x,-2,7.7\n0012,,1.5e1,\nS9,,abc,0.5\nx-4,,-3 m/s,\n"
MANUAL = 'student,question,points,comment\n007,q1,2.5,neat\n0012,1a,1,\nS9,bonus,"1,5",=why\n'
LONG = "student,ask,answer\nS9,1b,0.5\n007,q1.v_x,-2\nx-4,v_x,-3 m/s\n"
MOODLE = (
    '"Last name","First name","ID number","Email address",Status,Grade/3.00,"Response 1"\n'
    '王,伟,007,wei@example.org,Finished,3.00,"part 1: -2; part 2: 7.7"\n'
    'Bo,A,S9,,Finished,1.00,"part 1: 3; part 2: "\n'
    'Ann,B,x-4,,"In progress",-,"part 1: ; part 2: "\n'
)
GRADEBOOK = (
    '"First name","Last name","ID number","Email address","Assignment: Midterm (Real)"\n'
    "伟,王,007,wei@example.org,-\nBo,A,S9,,1.00\nAnn,B,x-4,,\nNo,One,99,,-\n"
)


@dataclass(frozen=True)
class Door:
    """A file below the folder of a case, and the command that reads it; OUT is what it writes."""

    name: str
    file: str
    command: tuple[str, ...]


GENERATE = (
    "generate",
    "bank.toml",
    "roster.csv",
    "-o",
    "OUT",
    "--reproducible",
    "x",
)
GRADE = ("grade", "EXAM", "answers.csv", "-o", "OUT")
BOOK = ("grade", "EXAM", "answers.xlsx", "-o", "OUT")
MOODLE_GRADE = ("grade", "EXAM", "moodle.csv", "-o", "OUT", "--from", "moodle", "--unfinished")
POLICY_GRADE = (*GRADE, "--policy", "policy.toml")
INTO = ("export", "MARKS", "--to", "moodle", "--into", "gradebook.csv", "-o", "OUT")
REPORT = ("report", "EXAM", "MARKS", "-o", "OUT")
FEEDBACK = ("feedback", "EXAM", "MARKS", "-o", "OUT", "--format", "md")
EXPORT = ("export", "MARKS", "--to", "generic", "-o", "OUT")
QUIZ = ("quiz", "EXAM", "--to", "moodle-xml", "-o", "OUT")
BY_HAND = (*GRADE, "--manual", "manual.csv")
LONG_GRADE = ("grade", "EXAM", "long.csv", "-o", "OUT")
NEVER_LOWER = (*GRADE, "--never-lower", "MARKS")

DOORS = (
    Door("roster", "roster.csv", GENERATE),
    Door("bank", "bank.toml", GENERATE),
    Door("template", "crank.toml", ("solve", "crank.toml")),
    Door("shown", "crank.toml", ("show", "crank.toml")),
    Door("answers", "answers.csv", GRADE),
    Door("by hand", "manual.csv", BY_HAND),
    Door("long", "long.csv", LONG_GRADE),
    Door("workbook", "answers.xlsx", BOOK),
    Door("moodle", "moodle.csv", MOODLE_GRADE),
    Door("sheet", "answers.csv", (*GRADE, "--from", "sheet")),
    Door("policy", "policy.toml", POLICY_GRADE),
    Door("gradebook", "gradebook.csv", INTO),
    *(Door("exam.json", "EXAM/exam.json", each) for each in (GRADE, REPORT, FEEDBACK, QUIZ)),
    *(Door("key", "EXAM/key.jsonl", each) for each in (GRADE, GRADE, FEEDBACK, QUIZ)),
    *(Door("old template", "EXAM/templates/crank.toml", each) for each in (GRADE, QUIZ, FEEDBACK)),
    Door("old bank", "EXAM/bank.toml", FEEDBACK),
    *(Door("marks", "MARKS/marks.csv", each) for each in (REPORT, FEEDBACK, EXPORT, NEVER_LOWER)),
    *(Door("grades", "MARKS/grades.csv", each) for each in (REPORT, FEEDBACK, EXPORT)),
    Door("sharing", "MARKS/marks.csv", ("sharing", "EXAM", "MARKS", "-o", "OUT")),
    Door("diff", "MARKS/marks.csv", ("diff", "MARKS", "MARKS")),
)


def write_material(folder: Path) -> None:
    """A valid file for every door, and the exam and the marks made from them."""
    texts = {
        "roster.csv": ROSTER,
        "bank.toml": BANK,
        "crank.toml": crank_text(),
        "policy.toml": POLICY,
        "answers.csv": ANSWERS,
        "manual.csv": MANUAL,
        "long.csv": LONG,
        "moodle.csv": MOODLE,
        "gradebook.csv": GRADEBOOK,
    }
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8")
    book = Workbook()
    for row in csv.reader(ANSWERS.splitlines()):
        book.active.append(row)
    book.save(folder / "answers.xlsx")
    exam, marks = folder / "EXAM", folder / "MARKS"
    made = kinegrade(
        *("generate", folder / "bank.toml", folder / "roster.csv", "-o", exam),
        *("--reproducible", "x"),
    )
    marked = kinegrade("grade", exam, folder / "answers.csv", "-o", marks)
    if made.exit_code != 0 or marked.exit_code != 1:
        raise RuntimeError(made.stderr + marked.stderr)


def damage(chance: Random, file: Path) -> None:
    """Mutate a file; of a workbook, as often as not, a part of it, so that it stays an archive."""
    if file.suffix == ".xlsx" and chance.random() < 0.8:
        with ZipFile(file) as archive:
            parts = {name: archive.read(name) for name in archive.namelist()}
        name = chance.choice([name for name in parts if name.startswith("xl/") or "Types" in name])
        parts[name] = mutated(chance, parts[name])
        with ZipFile(file, "w", ZIP_DEFLATED) as archive:
            for name, content in parts.items():
                archive.writestr(name, content)
        return
    file.write_bytes(mutated(chance, file.read_bytes()))


def copy_material(material: Path, folder: Path) -> None:
    """The material of one case, to be damaged."""
    shutil.copytree(material, folder)
