"""The gallery of the site shows every template, each with a picture that is made."""

from __future__ import annotations

import re
from pathlib import Path

from docs.generator.gallery import write_gallery_page, write_pictures
from kinegrade.problem.template.library.library import find_template_names

PICTURE = re.compile(r'<img src="\.\./(?P<file>\S+)" alt="(?P<words>[^"]+)"')


def test_every_template_has_its_picture_said_in_words_too() -> None:
    pictures = list(PICTURE.finditer(write_gallery_page()))
    names = {f"gallery/{name}.svg" for name in find_template_names()}
    assert {picture["file"] for picture in pictures} == names
    assert len({picture["words"] for picture in pictures}) > len(names) // 2


def test_pictures_are_made_where_the_page_looks_for_them(tmp_path: Path) -> None:
    write_pictures(tmp_path, ["slider-crank", "geneva-drive"])
    made = {file.relative_to(tmp_path).as_posix() for file in tmp_path.rglob("*.svg")}
    assert made == {"gallery/slider-crank.svg", "gallery/geneva-drive.svg"}
    assert "<svg" in (tmp_path / "gallery" / "geneva-drive.svg").read_text(encoding="utf-8")
