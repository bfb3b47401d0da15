"""What surrounds the quizzes of a package for Canvas: the resources of its manifest, and the
settings of each quiz.
"""

from __future__ import annotations

from fractions import Fraction

from kinegrade.lms.quiz.decimals import write_decimal
from kinegrade.lms.quiz.xml_text import Xml, write_document, write_element, write_on_lines

_INSTANCE = "http://www.w3.org/2001/XMLSchema-instance"
_CANVAS = "http://canvas.instructure.com/xsd/cccv1p0"
HEAD = (
    '<?xml version="1.0" encoding="UTF-8"?>\n'
    '<manifest identifier="kinegrade" xmlns="http://www.imsglobal.org/xsd/imsccv1p1/imscp_v1p1">\n'
    "<metadata><schema>IMS Content</schema><schemaversion>1.1.3</schemaversion></metadata>\n"
    "<organizations/>\n<resources>\n"
)
FOOT = "</resources>\n</manifest>\n"
_META = "associatedcontent/imscc_xmlv1p1/learning-application-resource"


def write_quiz_meta(identifier: str, title: str, points: Fraction, *, assigned: bool) -> bytes:
    """The `assessment_meta.xml` of a quiz: graded, one attempt, in the order given.

    An `assigned` quiz is visible only to the students to whom the instructor assigns it; any other
    to the whole course.
    """
    texts = {
        "title": title,
        "description": "",
        "shuffle_answers": "false",
        "scoring_policy": "keep_highest",
        "quiz_type": "assignment",
        "points_possible": write_decimal(points),
        "allowed_attempts": "1",
        "only_visible_to_overrides": "true" if assigned else "false",
    }
    children = write_on_lines(write_element(tag, text) for tag, text in texts.items())
    schema = f"{_CANVAS} https://canvas.instructure.com/xsd/cccv1p0.xsd"
    names = {"xmlns": _CANVAS, "xmlns:xsi": _INSTANCE, "xsi:schemaLocation": schema}
    return write_document(write_element("quiz", children, identifier=identifier, **names))


def write_assessment_resources(identifier: str) -> tuple[Xml, Xml]:
    """The resources of a quiz at `IDENTIFIER/IDENTIFIER.xml` with its meta data beside it."""
    meta, place = f"{identifier}-meta", f"{identifier}/assessment_meta.xml"
    return (
        write_element(
            "resource",
            write_element("file", href=f"{identifier}/{identifier}.xml"),
            write_element("dependency", identifierref=meta),
            identifier=identifier,
            type="imsqti_xmlv1p2",
        ),
        write_element(
            "resource", write_element("file", href=place), identifier=meta, type=_META, href=place
        ),
    )


def write_picture_resource(identifier: str, place: str) -> Xml:
    """The resource of a figure."""
    return write_element(
        "resource",
        write_element("file", href=place),
        identifier=identifier,
        type="webcontent",
        href=place,
    )
