"""A page as a SCORM 1.2 package, which learning management systems run and take a score from."""

from __future__ import annotations

from pathlib import Path

from kinegrade.files.zip_package import open_package
from kinegrade.lms.quiz.packaging import make_stable_name
from kinegrade.lms.quiz.xml_text import Xml, write_document, write_element

_PAGE = "practice.html"
_CP = "http://www.imsproject.org/xsd/imscp_rootv1p1p2"
_ADLCP = "http://www.adlnet.org/xsd/adlcp_rootv1p2"


def write_scorm_package(page: str, title: str, target: Path, *, force: bool = False) -> None:
    """The page as the only object of a package, which reports its own score. Raises OutputError."""
    with open_package(target, force=force) as package:
        package.add("imsmanifest.xml", write_document(_make_manifest(title)))
        package.add(_PAGE, page.encode())


def _make_manifest(title: str) -> Xml:
    """The manifest; attributes whose names have a colon are given by a mapping."""
    item = write_element(
        "item", write_element("title", title), identifier="item", identifierref="sheet"
    )
    organization = write_element(
        "organization", write_element("title", title), item, identifier="organization"
    )
    resource = write_element(
        "resource",
        write_element("file", href=_PAGE),
        identifier="sheet",
        type="webcontent",
        href=_PAGE,
        **{"adlcp:scormtype": "sco"},
    )
    return write_element(
        "manifest",
        write_element(
            "metadata",
            write_element("schema", "ADL SCORM"),
            write_element("schemaversion", "1.2"),
        ),
        write_element("organizations", organization, default="organization"),
        write_element("resources", resource),
        identifier=make_stable_name(f"kinegrade-{title}"),
        version="1.0",
        xmlns=_CP,
        **{"xmlns:adlcp": _ADLCP},
    )
