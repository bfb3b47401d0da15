"""Figures for a grader, and the grades that were given, each for exactly the picture that was seen."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Sequence
from dataclasses import astuple, dataclass, fields
from hashlib import sha256
from pathlib import Path

import typst

from kinegrade.figure.back_ends.svg import to_svg
from kinegrade.figure.mechanism.view import crop_to_view
from kinegrade.figure.similar_mechanisms import Subject, normalise_subject
from kinegrade.figure.sketch import sketch
from kinegrade.language import ENGLISH
from kinegrade.language.prose.typst import write_prose
from kinegrade.problem.printed_givens import mark_question
from kinegrade.problem.solution import Solution
from kinegrade.problem.statement import write_statement
from kinegrade.problem.template.library.library import load_template
from tests.problem.draws import draw_filter, drawn

GRADES = Path(__file__).parent / "grades.csv"
DIGITS = 16  # of a hash, enough to tell pictures apart


@dataclass(frozen=True)
class Graded:
    """A row: the figure of a template at a seed, the hash of its SVG, its grade (A, B, C; "" where
    nobody has looked yet) and the reason.
    """

    template: str
    seed: str
    picture: str
    grade: str = ""
    reason: str = ""


def print_figure(template: str, seed: str) -> str:
    """The SVG of the first figure that is dealt at a seed."""
    return _draw(deal(template, seed))


def deal_figures(template: str, seed: str, papers: int) -> list[str]:
    """The SVG of the figure of each of so many papers that are dealt at a seed."""
    dealt = drawn(draw_filter(load_template(template), seed), papers)
    return [_draw(instance.solution) for instance in dealt]


def deal_subjects(template: str, seed: str, papers: int) -> list[Subject]:
    """What the figure of each of so many papers shows, which is not drawn."""
    dealt = drawn(draw_filter(load_template(template), seed), papers)
    return [_find_subject(instance.solution) for instance in dealt]


def _find_subject(solution: Solution) -> Subject:
    template = solution.template
    hints = mark_question(template, template.asked())
    mechanism = solution.motion.frames.mechanism.map(float)
    return normalise_subject(crop_to_view(mechanism, hints), hints)[0]


def deal(template: str, seed: str) -> Solution:
    """The first instance that is dealt at a seed."""
    [instance] = drawn(draw_filter(load_template(template), seed), 1)
    return instance.solution


def _draw(solution: Solution) -> str:
    mechanism = solution.motion.frames.mechanism.map(float)
    template = solution.template
    return to_svg(sketch(mechanism, mark_question(template, template.asked())))


def _state(solution: Solution) -> str:
    """The statement as Typst code: senses and givens are held against it."""
    template = solution.template
    text = write_statement(template, solution.parameters, ENGLISH, template.asked())
    return write_prose(text, template.name, ENGLISH)


def digest(svg: str) -> str:
    """What tells a picture from every other."""
    return sha256(svg.encode()).hexdigest()[:DIGITS]


def write_sheet(folder: Path, templates: Iterable[str], seeds: Sequence[str]) -> None:
    """A page for each template with a figure and its statement for each seed, and a table of grades
    to be filled in.
    """
    folder.mkdir(parents=True, exist_ok=True)
    rows, pages = [], []
    for name in templates:
        cells = []
        for seed in seeds:
            solution = deal(name, seed)
            svg = _draw(solution)
            picture = f"{name}-{seed}.svg"
            (folder / picture).write_text(svg, encoding="utf-8")
            rows.append(Graded(name, seed, digest(svg)))
            told = f"#text(8pt)[seed {seed}: ] #text(8pt, {_state(solution)})"
            cells.append(f'[#image("{picture}") {told}]')
        pages.append(f"= {name}\n#grid(columns: 2, gutter: 8mm, {', '.join(cells)})\n")
    write_grades(folder / "grades.csv", rows)
    (folder / "sheet.typ").write_text("#pagebreak()\n".join(pages), encoding="utf-8")
    typst.compile(folder / "sheet.typ", output=folder / "sheet.pdf")


def read_grades(file: Path) -> list[Graded]:
    """The rows of a table of grades."""
    with file.open(encoding="utf-8", newline="") as text:
        return [Graded(**row) for row in csv.DictReader(text)]


def write_grades(file: Path, rows: Iterable[Graded]) -> None:
    """A table of grades, sorted."""
    with file.open("w", encoding="utf-8", newline="") as text:
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(field.name for field in fields(Graded))
        writer.writerows(sorted(map(astuple, rows)))


def take_grades(filled: Path, grades: Path = GRADES) -> None:
    """Put the grades of a filled sheet into the table, in place of earlier ones of those figures.

    Raises ValueError for a grade that is none of A, B and C, before anything is written.
    """
    taken = [row for row in read_grades(filled) if row.grade]
    for row in taken:
        if row.grade not in ("A", "B", "C"):
            raise ValueError(f"{row.template} {row.seed}: grade {row.grade!r}, not A, B or C")
    kept = {(row.template, row.seed): row for row in [*read_grades(grades), *taken]}
    write_grades(grades, kept.values())


def has_changed(row: Graded) -> bool:
    """Whether the figure no longer is what was graded."""
    return digest(print_figure(row.template, row.seed)) != row.picture


def find_lost(rows: Iterable[Graded]) -> list[str]:
    """The figures that no longer are what was graded, by name."""
    return [
        f"{row.template} {row.seed}: graded {row.grade}, has changed"
        for row in rows
        if has_changed(row)
    ]


def forget_changed(grades: Path = GRADES) -> None:
    """Take out of the table what no longer is what was graded."""
    write_grades(grades, [row for row in read_grades(grades) if not has_changed(row)])
