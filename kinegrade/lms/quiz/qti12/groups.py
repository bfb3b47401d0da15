"""Pooled questions of QTI 1.2: for every ask a group of variants, kept on disk until all papers
have been read.
"""

from __future__ import annotations

import shutil
from fractions import Fraction
from tempfile import TemporaryFile
from typing import IO
from xml.sax.saxutils import quoteattr

from kinegrade.lms.quiz.decimals import write_decimal
from kinegrade.lms.quiz.packaging import make_stable_name
from kinegrade.lms.quiz.qti12.item import NumericalItem, write_item_element

_HEAD = (
    "<section ident={} title={}>\n"
    "<selection_ordering><selection><selection_number>1</selection_number>"
    "<selection_extension><points_per_item>{}</points_per_item></selection_extension>"
    "</selection></selection_ordering>\n"
)
_FOOT = "</section>\n"


class Groups:
    """Variants by question and ask, in the order of their first appearance; a context manager, for
    its temporary files.
    """

    def __init__(self, identifier: str) -> None:
        self._identifier = identifier  # of the pool
        self._first: dict[tuple[str, str], NumericalItem] = {}
        self._streams: dict[tuple[str, str], IO[bytes]] = {}

    def __enter__(self) -> Groups:
        return self

    def __exit__(self, *_: object) -> None:
        for stream in self._streams.values():
            stream.close()

    def add(self, place: tuple[str, str], item: NumericalItem) -> Fraction:
        """Appends a variant; gives the points of the first one in its group."""
        if place not in self._first:
            self._first[place] = item
            self._streams[place] = TemporaryFile()  # noqa: SIM115 - closed on leaving the context
        self._streams[place].write(f"{write_item_element(item)}\n".encode())
        return self._first[place].points

    def __bool__(self) -> bool:
        """Whether there is any variant."""
        return bool(self._first)

    @property
    def points(self) -> Fraction:
        """The points of one variant of each group, added up."""
        return sum((item.points for item in self._first.values()), Fraction(0))

    def write(self, target: IO[bytes]) -> None:
        """The sections of all groups."""
        for place, item in self._first.items():
            head = _HEAD.format(
                quoteattr(make_stable_name("-".join((self._identifier, *place)))),
                quoteattr(item.title),
                write_decimal(item.points),
            )
            target.write(head.encode())
            self._streams[place].seek(0)
            shutil.copyfileobj(self._streams[place], target)
            target.write(_FOOT.encode())
