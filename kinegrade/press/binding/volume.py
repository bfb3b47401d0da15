"""PDF files bound one after another, each written as it comes: a volume takes no more memory than
its largest part, and a few bytes for each object.

Every part keeps its objects, under new numbers; its tree of pages is a branch of the volume's.
"""

from __future__ import annotations

from typing import BinaryIO

from kinegrade.press.binding.packed import PackedFile
from kinegrade.press.binding.part import Part
from kinegrade.press.binding.structure import JoinedStructure
from kinegrade.press.binding.values import Dictionary, Reference, Value, write_value


class Volume:
    """A PDF that grows by parts, on a stream; same parts, same bytes."""

    def __init__(self, stream: BinaryIO) -> None:
        self._file = PackedFile(stream)
        self._catalogue, self._root = self._file.reserve(), Reference(self._file.reserve())
        self._structure = JoinedStructure(self._file)
        self._branches: list[Value] = []
        self._last_box: Value | None = None
        self.pages = 0

    def add(self, part: Part) -> None:
        """The pages of a part, with its structure."""
        first = self._file.reserve(max(part.objects) + 1)
        renumbering = self._structure.add(part, first)
        branch = part.catalogue[b"/Pages"]
        pages = branch.number if isinstance(branch, Reference) else None
        kept = {number: each for number, each in part.objects.items() if number not in part.about}
        texts = renumbering.write_all([text for text, _ in kept.values()])
        begin = b"<</Parent %b" % write_value(self._root)
        for (number, (_, data)), text in zip(kept.items(), texts, strict=True):
            own = begin + text.removeprefix(b"<<") if number == pages else text
            self._file.put(first + number, own, data)
        self._branches.append(renumbering.write(write_value(branch)))
        self.pages += part.count_pages()
        self._last_box = part.find_last_box()

    def add_blank_page(self) -> None:
        """A page without anything, as large as the last."""
        number = self._file.reserve()
        page: Dictionary = {b"/Type": b"/Page", b"/Parent": self._root, b"/Resources": {}}
        if self._last_box is not None:
            page[b"/MediaBox"] = self._last_box
        self._file.put(number, write_value(page))
        self._branches.append(Reference(number))
        self.pages += 1

    def close(self) -> None:
        """Write what holds all parts together."""
        pages: Dictionary = {b"/Type": b"/Pages", b"/Count": b"%d" % self.pages}
        self._file.put(self._root.number, write_value(pages | {b"/Kids": self._branches}))
        catalogue: Dictionary = {b"/Type": b"/Catalog", b"/Pages": self._root}
        self._file.put(self._catalogue, write_value(catalogue | self._structure.close()))
        self._file.close(self._catalogue)
