"""`kinegrade generate`: the exam folder, written whole or not at all.

What students may see lies under `papers/` alone; everything else in the folder gives the key away and says so.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, closing
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, TextIO

from kinegrade import __version__
from kinegrade.collection import seldom_collected
from kinegrade.csv_writing import neutralised, write_csv
from kinegrade.errors import BankError
from kinegrade.exam.blueprint import BankQuestion, Blueprint
from kinegrade.exam.document import KeyPaper, PaperSize
from kinegrade.exam.join import joining
from kinegrade.exam.key_record import amount
from kinegrade.exam.pages import key_book
from kinegrade.exam.press import Engine, Press
from kinegrade.exam.printing import Extras, PressOrder, Printed, PrintRun
from kinegrade.exam.roster import Roster, Student
from kinegrade.exam.setting import Setting, set_exam
from kinegrade.exam.versions import version_letters
from kinegrade.exam.workshop import printed
from kinegrade.files import output_folder
from kinegrade.problem.shared_mechanism import FOLDER
from kinegrade.problem.template import Language

FORMAT = 1
MARKER = "exam.json"
NOTICE = "INSTRUCTOR-ONLY.txt"
CONTENTS = (
    MARKER,
    NOTICE,
    "key.jsonl",
    "key.pdf",
    "bank.toml",
    "templates",
    "papers",
    "papers.pdf",
    "answers.csv",
    "solutions",
    "solutions.pdf",
    "tex",
)
WARNING = (
    "For the instructor only: this folder gives the key away. Students may see what is under papers/ and nothing else, "
    "and after the exam, if you hand them out, their own worked solutions under solutions/. "
    "仅供教师使用：本文件夹含全部答案，学生只能看到 papers/ 中的内容；考试结束后可由教师发放 solutions/ 中的题解。"
)
PLAIN = Extras()
Progress = Callable[[Iterator[Printed], int], Iterator[Printed]]


@dataclass(frozen=True)
class Generated:
    """What was written: how many papers, from how many combinations, and why draws were refused.

    `drawn` names the templates of the questions that the bank left to be drawn.
    """

    papers: int
    drawn: dict[str, str]
    combinations: dict[str, int]
    refusals: dict[str, dict[str, int]]
    complaints: tuple[str, ...]


def generate(
    blueprint: Blueprint,
    roster: Roster,
    output: Path,
    secret: str,
    language: Language,
    *,
    force: bool = False,
    paper_size: PaperSize = "a4",
    engine: Engine | None = None,
    jobs: int = 1,
    extras: Extras = PLAIN,
    progress: Progress = lambda papers, count: papers,
) -> Generated:
    """Write the exam folder `output`, by up to `jobs` processes; the engine is the bank's unless one is given.

    `extras` says what is written beside papers and key.
    Raises BankError, DrawError, TypesetError, OutputError; then nothing is written.
    """
    bank = blueprint.bank(secret)
    setting = set_exam(bank, roster, secret)
    sources = source_files(setting)
    with (
        seldom_collected(),
        output_folder(output, marker=MARKER, contents=CONTENTS, force=force) as folder,
    ):
        order = PressOrder(engine or bank.engine, paper_size, folder / "tex")
        press = order.press()
        run = PrintRun(bank, language, order, folder / "papers", folder / "solutions", extras)
        keys = write_papers(setting, run, press, folder, jobs=jobs, progress=progress)
        write_sources(sources, folder)
        write_blank_answers(setting, folder / "answers.csv")
        write_json(folder / MARKER, exam_record(setting, keys, language))
        (folder / NOTICE).write_text(WARNING + "\n", encoding="utf-8")
    drawn = drawn_templates(blueprint, setting)
    said = complaints(roster, press)
    return Generated(len(keys), drawn, setting.combinations(), setting.refusals(), said)


def drawn_templates(blueprint: Blueprint, setting: Setting) -> dict[str, str]:
    """For each question that was drawn the name of its template."""
    return {
        slot.identifier: question.template.name
        for slot, question in zip(blueprint.slots, setting.bank.questions, strict=True)
        if slot.drawn
    }


def write_papers(
    setting: Setting, run: PrintRun, press: Press, folder: Path, *, jobs: int, progress: Progress
) -> list[KeyPaper]:
    """The papers, and the solutions that are wanted, each alone and all in one file; and both keys.

    The instructor's book is typeset, and all in one file bound, while papers are printed. Gives the key of each paper
    without its questions.
    """
    printouts = [run.papers, run.solutions] if run.extras.solutions else [run.papers]
    for place in printouts:
        place.mkdir()
    keys: list[KeyPaper] = []
    with (
        closing(printed(run, setting, press, jobs)) as results,
        (folder / "key.jsonl").open("w", encoding="utf-8", newline="\n") as lines,
        ExitStack() as books,
    ):
        volumes = {
            place: books.enter_context(joining(place.with_suffix(".pdf"), duplex=True))
            for place in printouts
        }
        papers = noted(progress(results, len(setting.roster.students)), lines, keys)
        press.key(
            key_book(run.bank, bound(papers, setting.roster, volumes), run.language),
            folder / "key.pdf",
        )
    return keys


def noted(results: Iterator[Printed], lines: TextIO, keys: list[KeyPaper]) -> Iterator[KeyPaper]:
    """The keys of papers as they come; a line of each goes to `lines`, its head to `keys`."""
    for result in results:
        lines.write(result.record + "\n")
        keys.append(replace(result.key, entries=()))
        yield result.key


def bound(
    papers: Iterator[KeyPaper], roster: Roster, volumes: Mapping[Path, Callable[[Path], None]]
) -> Iterator[KeyPaper]:
    """The same keys; what was printed for each student goes into the volumes, by the folders where it lies."""
    for student, paper in zip(roster.students, papers, strict=True):
        for place, append in volumes.items():
            append(place / f"{student.file_name}.pdf")
        yield paper


def source_files(setting: Setting) -> dict[str, str]:
    """The bank, every template and every mechanism as they were, so that a newer kinegrade can mark the exam again.

    Raises BankError where two templates share different mechanisms of one name, as the folder keeps one file of a name.
    """
    templates = [question.template for question in setting.bank.questions]
    mechanisms: dict[str, str] = {}
    faults = {
        name: f'bank: templates of this bank share two different mechanisms named "{name}": rename one file'
        for name, text in (template.mechanism for template in templates if template.mechanism)
        if mechanisms.setdefault(name, text) != text
    }
    if faults:
        raise BankError(*faults.values())
    return {
        "bank.toml": setting.bank.text,
        **{f"templates/{template.name}.toml": template.text for template in templates},
        **{f"templates/{FOLDER}/{name}.toml": text for name, text in mechanisms.items()},
    }


def write_sources(sources: Mapping[str, str], folder: Path) -> None:
    """Texts by their path below the folder."""
    for name, text in sources.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8", newline="")


def write_blank_answers(setting: Setting, path: Path) -> None:
    """The blank answer sheet: a row for each student, a column for each ask."""
    columns = [
        f"{question.identifier}.{ask.name}"
        for question in setting.bank.questions
        for ask in question.asks
    ]
    rows = (
        [student.student, neutralised(student.name), *[""] * len(columns)]
        for student in setting.roster.students
    )
    write_csv(path, ["student", "name", *columns], rows)


def write_json(path: Path, record: dict[str, Any]) -> None:
    """A JSON file for people and programs."""
    path.write_text(json.dumps(record, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")


def exam_record(setting: Setting, keys: list[KeyPaper], language: Language) -> dict[str, Any]:
    """What exam.json holds."""
    bank = setting.bank
    return {
        "format": FORMAT,
        "kinegrade": __version__,
        "warning": WARNING,
        "title": bank.title.in_language(language),
        "course": bank.course.in_language(language),
        "date": bank.date,
        "language": language,
        "seed": setting.secret,
        **({"versions": list(version_letters(bank.versions))} if bank.versions else {}),
        **({"credit": bank.credit.record()} if bank.credit.record() else {}),
        **({"solutions": True} if bank.solutions else {}),
        "questions": [question_entry(setting, question) for question in bank.questions],
        "students": [
            student_entry(student, key)
            for student, key in zip(setting.roster.students, keys, strict=True)
        ],
    }


def question_entry(setting: Setting, question: BankQuestion) -> dict[str, Any]:
    """What exam.json holds of a question."""
    asks = question.template.asks
    return {
        "question": question.identifier,
        "template": question.template.name,
        "points": amount(question.points),
        "combinations": setting.decks[question.identifier].combinations(),
        "refused": setting.refusals()[question.identifier],
        "asks": [
            {
                "ask": ask.name,
                "unit": asks[ask.name].unit.text,
                "sign": asks[ask.name].sign.en,
                "points": amount(ask.points),
            }
            for ask in question.asks
        ],
    }


def student_entry(student: Student, key: KeyPaper) -> dict[str, Any]:
    """What exam.json holds of a student."""
    return {
        "student": student.student,
        "name": student.name,
        "email": student.email,
        "paper": key.code,
        **({"version": key.version} if key.version else {}),
        "file": f"papers/{student.file_name}.pdf",
    }


def complaints(roster: Roster, press: Press) -> tuple[str, ...]:
    """What a person should look at: the roster's oddities, and characters of names that no font has."""
    missing = press.unprintable(student.name for student in roster.students)
    letters = [
        f"{student.student}: the name has characters that no font prints, they stand as code points"
        for student in roster.students
        if missing & set(student.name)
    ]
    return (*map(str, roster.complaints), *letters)
