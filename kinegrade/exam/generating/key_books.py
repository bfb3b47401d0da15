"""The instructor's key of an exam folder: a book for the class, and one for papers that were made
without a student, so that to give one away prints only theirs again.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from pathlib import Path

from kinegrade.exam.folder.contents import KEY_BOOK, SPARE_KEY_BOOK
from kinegrade.exam.folder.records import ExamHead
from kinegrade.exam.printing.key_pages import make_key_book
from kinegrade.exam.printing.printed_files import write_key
from kinegrade.exam.printing.printing import PrintRun
from kinegrade.press.sheet import KeyPaper


def write_key_books(
    folder: Path, run: PrintRun, papers: Iterable[KeyPaper], spare: Collection[str]
) -> None:
    """Both books, from keys that may come one after another; those of `spare` by their ids.

    Where papers come in versions, one book has each version once. Raises TypesetError.
    """
    apart: list[KeyPaper] = []
    in_class = _set_apart(papers, () if run.bank.versions else spare, apart)
    _write(folder / KEY_BOOK, run, in_class)
    if apart:
        _write(folder / SPARE_KEY_BOOK, run, apart)


def write_spare_key(folder: Path, run: PrintRun, papers: Iterable[KeyPaper]) -> None:
    """The book of papers that were made without a student, alone; nothing where papers come in
    versions, as no key names a student then.

    Raises TypesetError.
    """
    if not run.bank.versions:
        _write(folder / SPARE_KEY_BOOK, run, papers)


def list_spare_ids(head: ExamHead) -> frozenset[str]:
    """The papers that were made without a student, by the ids of those who have them now."""
    assigned = (each for each in head.students if each.was_spare)
    return frozenset(each.student for each in (*assigned, *head.spares))


def _set_apart(
    papers: Iterable[KeyPaper], spare: Collection[str], apart: list[KeyPaper]
) -> Iterator[KeyPaper]:
    """The other papers; those of `spare` go to `apart`."""
    for paper in papers:
        if paper.student in spare:
            apart.append(paper)
        else:
            yield paper


def _write(file: Path, run: PrintRun, papers: Iterable[KeyPaper]) -> None:
    book = make_key_book(run.bank, papers, run.language, file.stem)
    write_key(file, run.press_order.press().key(book))
