"""What surrounds the quizzes of a package for Canvas: the resources of its manifest, and the
settings of each quiz.
"""

from __future__ import annotations

from fractions import Fraction

from kinegrade.lms.quiz.decimals import decimal_text
from kinegrade.lms.quiz.xml_text import Xml, document, element, on_lines

INSTANCE = "http://www.w3.org/2001/XMLSchema-instance"
CANVAS = "http://canvas.instructure.com/xsd/cccv1p0"
HEAD = (
    '<?xml version="1.0" encoding="UTF-8"?>\n'
    '<manifest identifier="kinegrade" xmlns="http://www.imsglobal.org/xsd/imsccv1p1/imscp_v1p1">\n'
    "<metadata><schema>IMS Content</schema><schemaversion>1.1.3</schemaversion></metadata>\n"
    "<organizations/>\n<resources>\n"
)
FOOT = "</resources>\n</manifest>\n"
META = "associatedcontent/imscc_xmlv1p1/learning-application-resource"


def quiz_meta(identifier: str, title: str, points: Fraction, *, assigned: bool) -> bytes:
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
        "points_possible": decimal_text(points),
        "allowed_attempts": "1",
        "only_visible_to_overrides": "true" if assigned else "false",
    }
    children = on_lines(element(tag, text) for tag, text in texts.items())
    schema = f"{CANVAS} https://canvas.instructure.com/xsd/cccv1p0.xsd"
    names = {"xmlns": CANVAS, "xmlns:xsi": INSTANCE, "xsi:schemaLocation": schema}
    return document(element("quiz", children, identifier=identifier, **names))


def assessment_resources(identifier: str) -> tuple[Xml, Xml]:
    """The resources of a quiz at `IDENTIFIER/IDENTIFIER.xml` with its meta data beside it."""
    meta, place = f"{identifier}-meta", f"{identifier}/assessment_meta.xml"
    return (
        element(
            "resource",
            element("file", href=f"{identifier}/{identifier}.xml"),
            element("dependency", identifierref=meta),
            identifier=identifier,
            type="imsqti_xmlv1p2",
        ),
        element("resource", element("file", href=place), identifier=meta, type=META, href=place),
    )


def picture_resource(identifier: str, place: str) -> Xml:
    """The resource of a figure."""
    return element(
        "resource",
        element("file", href=place),
        identifier=identifier,
        type="webcontent",
        href=place,
    )
