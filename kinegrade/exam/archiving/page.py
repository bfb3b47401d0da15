"""The page that is printed and kept with an archive: a lost folder is a lost key."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import assert_never

from kinegrade.exam.archiving.archive import Archived
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.exam_secret import ExamSecret, FromWords, RandomSecret
from kinegrade.language.catalogue import Catalogue, open_catalogue
from kinegrade.press.archive_page import ArchivePage
from kinegrade.press.typst.press import TypstPress

_GROUP = 8  # hexadecimal digits that stand together


def print_archive_page(exam: ExamFolder, archived: Archived, target: Path) -> bytes:
    """The page of the archive at `target` as PDF, in the language of the papers."""
    return TypstPress().archive_page(make_archive_page(exam, archived, target))


def make_archive_page(exam: ExamFolder, archived: Archived, target: Path) -> ArchivePage:
    """What the page states."""
    words, head = open_catalogue(exam.language), exam.head
    facts = (
        (words.text("archive.fact-exam"), " · ".join(filter(None, (head.course, head.date)))),
        (words.text("archive.fact-file"), target.name),
        (words.text("archive.fact-checksum"), _group(archived.checksum)),
        (words.text("archive.fact-files"), str(archived.files)),
        (words.text("archive.fact-papers"), str(len(head.everybody))),
        (words.text("archive.fact-version"), head.kinegrade),
    )
    return ArchivePage(
        exam.language,
        head.title,
        words.text("archive.warning"),
        tuple((label, stated) for label, stated in facts if stated),
        tuple(_list_secret(head.drawn_from, words)),
        (
            words.text("archive.step-unpack", file=target.name),
            words.text("archive.step-verify"),
            words.text("archive.step-go-on", version=head.kinegrade),
        ),
        tuple((each.student, each.paper) for each in head.everybody),
    )


def _list_secret(secret: ExamSecret | None, words: Catalogue) -> Iterator[tuple[str, str]]:
    """What the numbers were drawn from, line by line."""
    match secret:
        case RandomSecret(draws=draws, codes=codes, label=label):
            yield words.text("archive.secret-draws"), _group(draws)
            yield words.text("archive.secret-codes"), _group(codes)
            if label:
                yield words.text("archive.secret-label"), label
        case FromWords(words=stated):
            yield words.text("archive.secret-words"), stated
        case None:
            yield words.text("archive.secret-none"), ""
        case _:
            assert_never(secret)


def _group(digits: str) -> str:
    """Hexadecimal digits as people compare them.

    >>> _group("0123456789abcdef")
    '01234567 89abcdef'
    """
    return " ".join(digits[at : at + _GROUP] for at in range(0, len(digits), _GROUP))
