"""The figures of a paper for the fingers: a ZIP file of sheets for swell paper, and their key."""

from __future__ import annotations

from dataclasses import dataclass
from io import BytesIO
from zipfile import ZipFile

from kinegrade.description.description import describe
from kinegrade.description.tactile_key import list_symbols, write_tactile_key
from kinegrade.exam.printing.pages import find_own_language
from kinegrade.exam.setting.setting import SetPaper, SetQuestion
from kinegrade.figure.back_ends.svg import to_svg
from kinegrade.figure.marks.names import write_point_symbol
from kinegrade.figure.scene import Scene
from kinegrade.figure.tactile.tactile import draw_tactile
from kinegrade.files.zip_package import Package
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.math.braille import label_in_braille, write_braille_number
from kinegrade.problem.printed_givens import mark_question
from kinegrade.problem.template.hints import FigureHints

KIND = "tactile.zip"
_KEY = "key.txt"


def make_tactile_sheets(paper: SetPaper, language: Language) -> bytes:
    """The ZIP file of a paper, in the student's language or else in that one: its sheets as SVG in
    the size of A4, and `key.txt`, which says what each label names and describes each figure.

    Raises TypesetError for a label that is no math.
    """
    language = find_own_language(paper, language)
    lines = [open_catalogue(language).text("tactile.reading")]
    buffer = BytesIO()
    with ZipFile(buffer, "x") as archive:
        package = Package(archive)
        for number, question in paper.numbered:
            if question.question.template.scheme.has_mechanism:
                sheets, said = _draw_question(number, question, language)
                for file, scene in sheets.items():
                    package.add(file, to_svg(scene).encode())
                lines += said
        package.add(_KEY, ("\n".join(lines) + "\n").encode())
    return buffer.getvalue()


def _draw_question(
    number: int, question: SetQuestion, language: Language
) -> tuple[dict[str, Scene], list[str]]:
    """The sheets of a question by their names, and the lines of its key."""
    template, solution = question.question.template, question.drawn.solution
    asks = tuple(entry.ask.name for entry in question.asks)
    hints, mechanism = mark_question(template, asks), solution.assembly.mechanism.map(float)
    labels = label_in_braille(list_symbols(hints, mechanism.points), language)

    def write_cells(symbol: str) -> str:
        return labels.get(symbol) or label_in_braille([symbol], language)[symbol]

    def write_number(place: int) -> str:
        return write_braille_number(number, place)

    figure = draw_tactile(mechanism, hints, write_cells, write_number)
    files = [f"q{number}-{place}.svg" for place in range(1, len(figure.sheets) + 1)]
    title = template.about.title.in_language(language)
    described = describe(solution, language, asks)
    key = write_tactile_key(figure, files, write_cells, _Letters(hints).find, language)
    lines = ["", open_catalogue(language).text("tactile.question", number=number, title=title)]
    lines += [*key, str(described)]
    return dict(zip(files, (sheet.scene for sheet in figure.sheets), strict=True)), lines


@dataclass(frozen=True)
class _Letters:
    """The letters of points, with those that the author has changed."""

    hints: FigureHints

    def find(self, point: str) -> str:
        """The letter of a point by its name."""
        return self.hints.labels.get(point) or write_point_symbol(point)
