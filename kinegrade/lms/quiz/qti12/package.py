"""Quizzes as QTI 1.2 packages for Canvas, Classic and New Quizzes: a numerical question for every
ask.

Canvas has no question with several numbers, so every ask is a question with the statement and the
figure. A paper is an assessment; pooled questions are one assessment that draws one of the variants
for every ask.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from tempfile import TemporaryFile
from xml.sax.saxutils import quoteattr

from kinegrade.errors import Problem
from kinegrade.exam.quiz.document import Quiz, QuizAsk, QuizPaper, QuizQuestion
from kinegrade.files.zip_package import Package, open_package
from kinegrade.language.message import Fault, Message
from kinegrade.language.prose.plain import write_one_plain_line
from kinegrade.lms.quiz.manifest import Manifest
from kinegrade.lms.quiz.packaging import make_pool_name, make_stable_name
from kinegrade.lms.quiz.qti12 import manifest as qti12_manifest
from kinegrade.lms.quiz.qti12.groups import Groups
from kinegrade.lms.quiz.qti12.item import NumericalItem, write_item_element
from kinegrade.lms.quiz.qti12.questions import (
    Asking,
    make_numerical_items,
    name_picture,
    name_solution_picture,
)
from kinegrade.lms.quiz.qti12.units import choose_class_units
from kinegrade.lms.quiz.remarks import Remarks
from kinegrade.press.html.question import draw_picture

_HEAD = (
    '<?xml version="1.0" encoding="UTF-8"?>\n'
    '<questestinterop xmlns="http://www.imsglobal.org/xsd/ims_qtiasiv1p2" '
    'xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" '
    'xsi:schemaLocation="http://www.imsglobal.org/xsd/ims_qtiasiv1p2 '
    'http://www.imsglobal.org/xsd/ims_qtiasiv1p2p1.xsd">\n<assessment ident={} title={}>\n'
    "<qtimetadata><qtimetadatafield>"
    "<fieldlabel>cc_maxattempts</fieldlabel><fieldentry>1</fieldentry>"
    '</qtimetadatafield></qtimetadata>\n<section ident="root_section">\n'
)
_FOOT = "</section>\n</assessment>\n</questestinterop>\n"


def write(quiz: Quiz, target: Path, *, force: bool = False) -> list[Problem]:
    """Writes the package, with `force` over an existing plain file; gives what the instructor
    should know about it, one line for each point.

    Raises ExportError with everything that Canvas cannot keep, OutputError; `target` is then
    unchanged.
    """
    with (
        open_package(target, force=force) as parts,
        Groups(make_pool_name(quiz.identifier)) as groups,
        Manifest(qti12_manifest.HEAD, qti12_manifest.FOOT) as manifest,
    ):
        return _Writer(quiz, parts, groups, manifest).write()


class _Writer:
    """The state while papers are written one after another."""

    def __init__(self, quiz: Quiz, parts: Package, groups: Groups, manifest: Manifest) -> None:
        self._quiz, self._parts, self._groups, self._manifest = quiz, parts, groups, manifest
        self._remarks = Remarks()
        self._units = choose_class_units(quiz.asks)

    def write(self) -> list[Problem]:
        for paper in self._quiz.papers:
            if paper.student or paper.name:
                self._paper(paper)
            else:
                self._variants(paper)
        if self._groups:
            self._pool()
        self._remarks.raise_faults()
        self._parts.copy("imsmanifest.xml", self._manifest.finished())
        return self._remarks.complaints

    def _paper(self, paper: QuizPaper) -> None:
        asking = self._asking(paper)
        items = [item for question in paper.questions for _, item in self._items(question, asking)]
        if not items:
            return
        self._remarks.complain(Message("quiz-file.for-one"))
        identifier = f"{items[0].identifier}-paper"
        owner = " ".join(filter(None, (paper.code, paper.student, paper.name)))
        title = write_one_plain_line(f"{self._quiz.title_of(paper)} · {owner}")
        written = "".join(f"{write_item_element(item)}\n" for item in items)
        head = _HEAD.format(quoteattr(identifier), quoteattr(title))
        self._parts.add(f"{identifier}/{identifier}.xml", f"{head}{written}{_FOOT}".encode())
        points = sum((item.points for item in items), Fraction(0))
        self._describe(identifier, title, points, assigned=True)

    def _asking(self, paper: QuizPaper) -> Asking:
        """What holds for the questions of a paper."""
        return Asking(self._quiz.language_of(paper), self._units, self._remarks)

    def _variants(self, paper: QuizPaper) -> None:
        asking = self._asking(paper)
        for question in paper.questions:
            for ask, item in self._items(question, asking, pooled=True):
                worth = self._groups.add((question.sheet.identifier, ask.identifier), item)
                if worth != item.points:
                    uneven = Message("quiz-file.uneven", points=str(item.points), first=str(worth))
                    self._remarks.refuse(Fault(item.identifier, uneven))
            if len(question.asks) > 1:
                self._remarks.complain(Message("quiz-file.drawn-apart"))

    def _items(
        self, question: QuizQuestion, asking: Asking, *, pooled: bool = False
    ) -> Iterator[tuple[QuizAsk, NumericalItem]]:
        """The items of a question; its figure, and the pictures of its solution, are written into
        the package first.
        """
        found = make_numerical_items(question, asking, solution_with_each=pooled)
        name = make_stable_name(question.identifier)
        if question.sheet.figure is not None and found:
            self._picture(
                f"{name}-figure", name_picture(question), draw_picture(question.sheet.figure)
            )
        for number, picture in enumerate(question.solution.pictures if found else (), start=1):
            place = name_solution_picture(question, number)
            self._picture(f"{name}-solution-{number}", place, draw_picture(picture.scene))
        yield from found

    def _picture(self, identifier: str, place: str, content: bytes) -> None:
        """A picture, and its entry in the manifest."""
        self._parts.add(place, content)
        self._manifest.add(qti12_manifest.write_picture_resource(identifier, place))

    def _pool(self) -> None:
        identifier, title = (
            make_pool_name(self._quiz.identifier),
            write_one_plain_line(self._quiz.title),
        )
        with TemporaryFile() as stream:
            stream.write(_HEAD.format(quoteattr(identifier), quoteattr(title)).encode())
            self._groups.write(stream)
            stream.write(_FOOT.encode())
            self._parts.copy(f"{identifier}/{identifier}.xml", stream)
        self._describe(identifier, title, self._groups.points, assigned=False)

    def _describe(self, identifier: str, title: str, points: Fraction, *, assigned: bool) -> None:
        meta = qti12_manifest.write_quiz_meta(identifier, title, points, assigned=assigned)
        self._parts.add(f"{identifier}/assessment_meta.xml", meta)
        self._manifest.add(*qti12_manifest.write_assessment_resources(identifier))
