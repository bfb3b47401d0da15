"""Every picture in papers for the browser and Word, and in quizzes, has a short text in its place:
one, of at most 125 characters, that tells no value that is asked for.

The files are read by other programs' rules alone: HTML by the standard library, Word and packages
as ZIP files of XML.
"""

from __future__ import annotations

import re
import shutil
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from xml.etree import ElementTree
from zipfile import ZipFile

from kinegrade.problem.template.template import Template
from tests.prove.draws import seeded_template
from tests.small_class import asks_of, kinegrade

LONGEST = 125
ROSTER = "student,name\n007,Ann\n"
BANK = """title = "Pictures"
course = "Proof"
tolerance = "honest"
questions = [{{ template = "{}" }}]
"""
QUIZZES = {"moodle-xml": "quiz.xml", "qti12": "qti12.zip", "qti21": "qti21.zip"}
# In Word's drawings, the properties of what is seen; of the text beside it and of its data it has others
WORD_PICTURE = "{http://schemas.openxmlformats.org/drawingml/2006/wordprocessingDrawing}docPr"
DIGITS = (3, 4, 6)
NUMBER = re.compile(r"\d+(?:[.,]\d+)?")


class Pictures(HTMLParser):
    """The texts of the pictures of a page, None where one has none."""

    def __init__(self, html: str) -> None:
        super().__init__()
        self.texts: list[str | None] = []
        self.feed(html)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Notes an image, or a drawing within the page."""
        if tag in ("img", "svg"):
            found = dict(attrs)
            self.texts.append(found.get("alt" if tag == "img" else "aria-label"))


def hold(seed: int, folder: Path) -> None:
    """Write papers and quizzes of an instance in each language, and read their pictures."""
    template = seeded_template(seed)
    place = folder / "pictures"
    for language in template.words.statement.languages:
        place.mkdir()
        try:
            faults = list(_find_faults(seed, template, language, place))
        finally:
            shutil.rmtree(place)
        assert faults == [], f"{template.name} ({language}): {faults}"


def _list_numbers_in_names(template: Template, language: str) -> set[str]:
    """The numbers that an author wrote: they belong to names, as in O_1 and ring 1."""
    statement = dict(template.words.statement.by_language).get(language, "")
    title = dict(template.about.title.by_language).get(language, "")
    return set(NUMBER.findall(f"{statement} {title} {' '.join(template.scheme.points)}"))


def _find_faults(seed: int, template: Template, language: str, place: Path) -> Iterator[str]:
    exam = _set_exam(seed, template, language, place)
    answers = {
        f"{abs(float(ask['value'])):.{digits}g}"
        for ask in asks_of(exam).values()
        for digits in DIGITS
    }
    told = answers - _list_numbers_in_names(template, language)
    pictures = 1 if template.scheme.has_mechanism else 0
    for kind, texts in _read_files(exam, language, place):
        # QTI 1.2 has an item for each number, and the figure in each
        if len(texts) != pictures * (len(asks_of(exam)) if kind == "qti12" else 1):
            yield f"{kind}: {len(texts)} pictures"
        for text in texts:
            if not text or not text.strip() or len(text) > LONGEST:
                yield f"{kind}: no short text: {text}"
            elif told & {number.replace(",", ".") for number in NUMBER.findall(text)}:
                yield f"{kind}: an answer is told: {text}"


def _set_exam(seed: int, template: Template, language: str, place: Path) -> Path:
    (place / "bank.toml").write_text(BANK.format(template.name), encoding="utf-8")
    (place / "roster.csv").write_text(ROSTER, encoding="utf-8")
    files = place / "bank.toml", place / "roster.csv", "-o", place / "EXAM"
    made = kinegrade(
        *("generate", *files, "--reproducible", f"prove {seed}", "--lang", language),
        *("--also", "html", "--also", "docx", "--jobs", "1"),
    )
    assert made.exit_code < 2, made.stderr
    return place / "EXAM"


def _read_files(exam: Path, language: str, place: Path) -> Iterator[tuple[str, list[str | None]]]:
    """The kind of each file, and the texts of its pictures."""
    yield "html", Pictures((exam / "papers" / "007.html").read_text(encoding="utf-8")).texts
    yield "docx", _read_word(exam / "papers" / "007.docx")
    for kind, name in QUIZZES.items():
        target = place / name
        made = kinegrade(
            "quiz", exam, "--to", kind, "-o", target, "--lang", language, "--jobs", "1"
        )
        assert made.exit_code < 2, made.stderr
        yield kind, _read_quiz(target)


def _read_word(file: Path) -> list[str | None]:
    with ZipFile(file) as package:
        document = ElementTree.fromstring(package.read("word/document.xml"))
    return [picture.get("descr") for picture in document.iter(WORD_PICTURE)]


def _read_quiz(file: Path) -> list[str | None]:
    """Pictures that are elements of the file, and those of the pages that its texts are."""
    if file.suffix == ".xml":
        sources = [file.read_bytes()]
    else:
        with ZipFile(file) as package:
            names = [name for name in package.namelist() if name.endswith(".xml")]
            sources = [package.read(name) for name in names]
    texts: list[str | None] = []
    for source in sources:
        for element in ElementTree.fromstring(source).iter():
            if element.tag.rpartition("}")[2] == "img":
                texts.append(element.get("alt"))
            texts += Pictures(element.text or "").texts
    return texts
