"""Quizzes as QTI 2.1 packages: one item for every mechanism, one test for every paper or one that
draws variants.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from kinegrade.errors import Problem, TypesetError
from kinegrade.exam.quiz.document import Quiz, QuizPaper, QuizQuestion
from kinegrade.files.zip_package import Package, open_package
from kinegrade.language import Language
from kinegrade.language.message import Message
from kinegrade.language.prose.plain import write_one_plain_line
from kinegrade.lms.quiz.manifest import Manifest
from kinegrade.lms.quiz.packaging import make_pool_name, make_stable_name
from kinegrade.lms.quiz.qti21.item import NAMES, name_picture, write_item_document
from kinegrade.lms.quiz.remarks import Remarks
from kinegrade.lms.quiz.xml_text import Xml, write_document, write_element, write_on_lines
from kinegrade.press.html.question import draw_picture

_HEAD = (
    '<?xml version="1.0" encoding="UTF-8"?>\n'
    '<manifest identifier="kinegrade" xmlns="http://www.imsglobal.org/xsd/imscp_v1p1">\n'
    "<metadata><schema>QTIv2.1 Package</schema><schemaversion>1.0.0</schemaversion></metadata>\n"
    "<organizations/>\n<resources>\n"
)
_FOOT = "</resources>\n</manifest>\n"


def write(quiz: Quiz, target: Path, *, force: bool = False) -> list[Problem]:
    """Writes the package, with `force` over an existing plain file; gives what the instructor
    should know about it, one line for each point.

    Raises ExportError with every text that cannot be shown, OutputError; `target` is then
    unchanged.
    """
    with open_package(target, force=force) as parts, Manifest(_HEAD, _FOOT) as manifest:
        return _Writer(quiz, parts, manifest).write()


class _Writer:
    """The state while papers are written one after another."""

    def __init__(self, quiz: Quiz, parts: Package, manifest: Manifest) -> None:
        self._quiz, self._parts, self._manifest = quiz, parts, manifest
        self._remarks = Remarks()
        self._pool: dict[str, list[str]] = {}  # identifiers of the variants, by question

    def write(self) -> list[Problem]:
        self._remarks.complain(Message("quiz-file.latex-math"))
        self._remarks.complain(Message("quiz-file.not-canvas"))
        for paper in self._quiz.papers:
            language = self._quiz.language_of(paper)
            owned = bool(paper.student or paper.name)
            code = paper.code if owned else ""
            written = [each for each in paper.questions if self._item(each, language, code)]
            if owned:
                self._remarks.complain(Message("quiz-file.qti21-for-one"))
                self._paper(paper, written)
            else:
                for question in written:
                    self._pool.setdefault(question.sheet.identifier, []).append(
                        make_stable_name(question.identifier)
                    )
        if self._pool:
            name = make_pool_name(self._quiz.identifier)
            self._test(name, self._quiz.title, list(self._pool.values()))
        self._remarks.raise_faults()
        self._parts.copy("imsmanifest.xml", self._manifest.finished())
        return self._remarks.complaints

    def _paper(self, paper: QuizPaper, questions: Sequence[QuizQuestion]) -> None:
        if questions:
            owner = " ".join(filter(None, (paper.code, paper.student, paper.name)))
            names = [make_stable_name(question.identifier) for question in questions]
            title = f"{self._quiz.title_of(paper)} · {owner}"
            self._test(f"{names[0]}-paper", title, [[name] for name in names])

    def _item(self, question: QuizQuestion, language: Language, paper: str) -> bool:
        """Writes the question, the code of its paper in its title, its figure and the pictures of
        its solution; gives whether its texts could be shown.
        """
        name = make_stable_name(question.identifier)
        try:
            content = write_item_document(question, language, "../", paper)
        except TypesetError as fault:
            self._remarks.refuse_texts(fault)
            return False
        files = [f"items/{name}.xml"]
        self._parts.add(files[0], content)
        figure, drawn = question.sheet.figure, question.solution.pictures
        pictures = {name_picture(question): figure} if figure is not None else {}
        pictures |= {
            name_picture(question, number): picture.scene
            for number, picture in enumerate(drawn, start=1)
        }
        for place, scene in pictures.items():
            self._parts.add(place, draw_picture(scene))
        files += pictures
        self._manifest.add(_write_resource(name, "imsqti_item_xmlv2p1", files))
        return True

    def _test(self, identifier: str, title: str, variants: Sequence[Sequence[str]]) -> None:
        place = f"tests/{identifier}.xml"
        self._parts.add(
            place, _write_test_document(identifier, write_one_plain_line(title), variants)
        )
        used = [name for names in variants for name in names]
        self._manifest.add(_write_resource(identifier, "imsqti_test_xmlv2p1", [place], used))


def _write_test_document(identifier: str, title: str, variants: Sequence[Sequence[str]]) -> bytes:
    """A test of all questions in their order, each drawn from its variants where it has several."""
    sections = (_write_section(place, names) for place, names in enumerate(variants, start=1))
    part = write_element(
        "testPart",
        write_on_lines(sections),
        identifier="PART",
        navigationMode="nonlinear",
        submissionMode="simultaneous",
    )
    score = write_element(
        "outcomeDeclaration", identifier="SCORE", cardinality="single", baseType="float"
    )
    total = write_element("sum", write_element("testVariables", variableIdentifier="SCORE"))
    processing = write_element(
        "outcomeProcessing", write_element("setOutcomeValue", total, identifier="SCORE")
    )
    parts = write_on_lines((score, part, processing))
    return write_document(
        write_element("assessmentTest", parts, identifier=identifier, title=title, **NAMES)
    )


def _write_section(place: int, names: Sequence[str]) -> Xml:
    drawn = [write_element("selection", select="1")] if len(names) > 1 else []
    items = (
        write_element("assessmentItemRef", identifier=name, href=f"../items/{name}.xml")
        for name in names
    )
    return write_element(
        "assessmentSection",
        *drawn,
        *items,
        identifier=f"SECTION_{place}",
        title=str(place),
        visible="false",
    )


def _write_resource(
    identifier: str, kind: str, files: Sequence[str], uses: Sequence[str] = ()
) -> Xml:
    children = (write_element("file", href=name) for name in files)
    needed = (write_element("dependency", identifierref=name) for name in uses)
    return write_element(
        "resource", *children, *needed, identifier=identifier, type=kind, href=files[0]
    )
