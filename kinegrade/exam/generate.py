"""`kinegrade generate`: the exam folder, written whole or not at all.

What students may see lies under `papers/` alone; everything else in the folder gives the key away and says so.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from kinegrade import __version__
from kinegrade.errors import BankError
from kinegrade.exam.blueprint import Blueprint, Tolerance
from kinegrade.exam.document import KeyPaper, PaperSize
from kinegrade.exam.join import join
from kinegrade.exam.pages import key_book, key_paper, paper_pages
from kinegrade.exam.roster import Roster
from kinegrade.exam.setting import SetAsk, SetPaper, SetQuestion, Setting, set_exam
from kinegrade.exam.typst import TypstPress
from kinegrade.exam.versions import version_letters
from kinegrade.files import output_folder
from kinegrade.problem.shared_mechanism import FOLDER
from kinegrade.problem.template import Language
from kinegrade.tables import neutralised, write_csv

FORMAT = 1
MARKER = "exam.json"
NOTICE = "INSTRUCTOR-ONLY.txt"
CONTENTS = (MARKER, NOTICE, "key.jsonl", "key.pdf", "bank.toml", "templates", "papers", "papers.pdf", "answers.csv")
WARNING = (
    "For the instructor only: this folder gives the key away. Students may see what is under papers/ and nothing else. "
    "仅供教师使用：本文件夹含全部答案，学生只能看到 papers/ 中的内容。"
)
Progress = Callable[[Iterator[SetPaper], int], Iterator[SetPaper]]


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


def generate(blueprint: Blueprint, roster: Roster, output: Path, secret: str, language: Language, *,
             force: bool = False, paper_size: PaperSize = "a4",
             progress: Progress = lambda papers, count: papers) -> Generated:
    """Write the exam folder `output`.

    Raises BankError, DrawError, TypesetError, OutputError; then nothing is written.
    """
    setting = set_exam(blueprint.bank(secret), roster, secret)
    sources, press = source_files(setting), TypstPress(paper_size)
    with output_folder(output, marker=MARKER, contents=CONTENTS, force=force) as folder:
        keys = write_papers(setting, press, folder, language, progress)
        join((folder / "papers" / f"{student.file_name}.pdf" for student in roster.students), folder / "papers.pdf")
        (folder / "key.pdf").write_bytes(press.key(key_book(setting.bank, keys, language)))
        write_sources(sources, folder)
        write_blank_answers(setting, folder / "answers.csv")
        write_json(folder / MARKER, exam_record(setting, keys, language))
        (folder / NOTICE).write_text(WARNING + "\n", encoding="utf-8")
    combinations = {name: deck.combinations() for name, deck in setting.decks.items()}
    return Generated(len(keys), drawn_templates(blueprint, setting), combinations, setting.refusals(),
                     complaints(roster, press))


def drawn_templates(blueprint: Blueprint, setting: Setting) -> dict[str, str]:
    """For each question that was drawn the name of its template."""
    return {slot.identifier: question.template.name
            for slot, question in zip(blueprint.slots, setting.bank.questions, strict=True) if slot.drawn}


def write_papers(setting: Setting, press: TypstPress, folder: Path, language: Language,
                 progress: Progress) -> list[KeyPaper]:
    """The papers as PDF and the key line by line; gives what the instructor's book needs."""
    (folder / "papers").mkdir()
    keys = []
    with (folder / "key.jsonl").open("w", encoding="utf-8", newline="\n") as lines:
        for paper in progress(setting.papers(), len(setting.roster.students)):
            lines.write(json.dumps(key_record(paper, shuffled=setting.bank.shuffle), ensure_ascii=False) + "\n")
            pdf = press.paper(paper_pages(setting.bank, paper, language))
            (folder / "papers" / f"{paper.student.file_name}.pdf").write_bytes(pdf)
            keys.append(key_paper(paper, language))
    return keys


def source_files(setting: Setting) -> dict[str, str]:
    """The bank, every template and every mechanism as they were, so that a newer kinegrade can mark the exam again.

    Raises BankError where two templates share different mechanisms of one name, as the folder keeps one file of a name.
    """
    templates = [question.template for question in setting.bank.questions]
    mechanisms: dict[str, str] = {}
    faults = {name: f'bank: templates of this bank share two different mechanisms named "{name}": rename one file'
              for name, text in (template.mechanism for template in templates if template.mechanism)
              if mechanisms.setdefault(name, text) != text}
    if faults:
        raise BankError(*faults.values())
    return {"bank.toml": setting.bank.text,
            **{f"templates/{template.name}.toml": template.text for template in templates},
            **{f"templates/{FOLDER}/{name}.toml": text for name, text in mechanisms.items()}}


def write_sources(sources: Mapping[str, str], folder: Path) -> None:
    """Texts by their path below the folder."""
    for name, text in sources.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8", newline="")


def write_blank_answers(setting: Setting, path: Path) -> None:
    """The blank answer sheet: a row for each student, a column for each ask."""
    columns = [f"{question.identifier}.{ask.name}" for question in setting.bank.questions for ask in question.asks]
    rows = ([student.student, neutralised(student.name), *[""] * len(columns)] for student in setting.roster.students)
    write_csv(path, ["student", "name", *columns], rows)


def write_json(path: Path, record: dict[str, Any]) -> None:
    """A JSON file for people and programs."""
    path.write_text(json.dumps(record, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")


def exam_record(setting: Setting, keys: list[KeyPaper], language: Language) -> dict[str, Any]:
    """What exam.json holds."""
    bank = setting.bank
    return {
        "format": FORMAT, "kinegrade": __version__, "warning": WARNING, "title": bank.title.in_language(language),
        "course": bank.course.in_language(language), "date": bank.date, "language": language, "seed": setting.secret,
        **({"versions": list(version_letters(bank.versions))} if bank.versions else {}),
        "questions": [
            {"question": question.identifier, "template": question.template.name, "points": amount(question.points),
             "combinations": setting.decks[question.identifier].combinations(),
             "refused": setting.refusals()[question.identifier],
             "asks": [{"ask": ask.name, "unit": question.template.asks[ask.name].unit.text,
                       "points": amount(ask.points)} for ask in question.asks]}
            for question in bank.questions],
        "students": [{"student": student.student, "name": student.name, "email": student.email, "paper": key.code,
                      **({"version": key.version} if key.version else {}), "file": f"papers/{student.file_name}.pdf"}
                     for student, key in zip(setting.roster.students, keys, strict=True)],
    }


def key_record(paper: SetPaper, *, shuffled: bool = False) -> dict[str, Any]:
    """One line of key.jsonl; the questions stand in the bank's order, `printed` tells the paper's."""
    return {"student": paper.student.student, "paper": paper.code,
            **({"version": paper.version} if paper.version else {}),
            **({"printed": [question.question.identifier for question in paper.printed]} if shuffled else {}),
            "questions": [question_record(question) for question in paper.questions]}


def question_record(question: SetQuestion) -> dict[str, Any]:
    """One question of a key line: what was drawn, and what is right within which tolerance."""
    parameters = {name: quantity.record() for name, quantity in question.drawn.solution.parameters.items()}
    for record in parameters.values():
        del record["decimal"]
    return {"question": question.question.identifier, "template": question.question.template.name,
            "parameters": parameters,
            "asks": {entry.ask.name: ask_record(entry) for entry in question.asks}}


def ask_record(entry: SetAsk) -> dict[str, Any]:
    """One ask of a key line; `decimal` has 40 correct digits, by which marks are decided."""
    turn = {"period": entry.answer.full_turn} if entry.cyclic else {}
    return {**entry.answer.record(), "tolerance": tolerance_record(entry.tolerance), **turn,
            "points": amount(entry.ask.points)}


def tolerance_record(tolerance: Tolerance) -> dict[str, Any]:
    """Right within max(relative*|exact value|, absolute)."""
    return {"relative": amount(tolerance.relative), "absolute": amount(tolerance.absolute)}


def amount(number: Any) -> int | float:
    """A decimal of few digits as JSON writes it; whole numbers without a point."""
    return int(number) if number == int(number) else float(number)


def complaints(roster: Roster, press: TypstPress) -> tuple[str, ...]:
    """What a person should look at: the roster's oddities, and characters of names that no font has."""
    missing = press.unprintable(student.name for student in roster.students)
    letters = [f"{student.student}: the name has characters that no font prints, they stand as code points"
               for student in roster.students if missing & set(student.name)]
    return (*map(str, roster.complaints), *letters)
