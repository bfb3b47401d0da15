"""The structure trees of joined PDF files as one, so that a volume can be heard as its parts can.

The trees are those that Typst writes: pages refer to them, tables name their header cells. A part
without a tree, such as a formula sheet that somebody brought, leaves the volume without the
statement that all of it is tagged.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import pikepdf
from pikepdf import Array, Dictionary, Name, NumberTree, Object, String


class JoinedStructure:
    """The tree of a PDF that grows by parts."""

    def __init__(self, whole: pikepdf.Pdf) -> None:
        self._whole = whole
        self._next_key = 0
        self._parents: list[Object | int] = []
        self._documents: list[Object] = []
        self._header_cells: list[tuple[str, Object]] = []
        self._roles: dict[str, Object] = {}
        self._is_tagged = True

    def add(self, part: pikepdf.Pdf, pages: Sequence[pikepdf.Page]) -> None:
        """Take over the tree of a part, whose pages in the whole are `pages`."""
        root = part.Root.get(Name.StructTreeRoot)
        if root is None:
            self._is_tagged = False
            return
        if not self._documents:
            self._take_catalogue(part)
        tree = self._whole.copy_foreign(root)
        for page in pages:
            if Name.StructParents in page.obj:
                page.obj.StructParents += self._next_key
        if Name.ParentTree in tree:  # an empty page has none
            for key, parents in NumberTree(tree.ParentTree).items():
                self._parents += (key + self._next_key, parents)
            self._next_key += int(tree.ParentTreeNextKey)
        self._roles |= dict(tree.get(Name.RoleMap, Dictionary()).items())
        self._name_header_cells(tree, f"{len(self._documents)}-")
        self._documents += _list_kids(tree)

    def close(self) -> None:
        """Write the tree into the whole."""
        if not self._documents:
            return
        root = self._whole.make_indirect(Dictionary(Type=Name.StructTreeRoot))
        document = self._whole.make_indirect(
            Dictionary(Type=Name.StructElem, S=Name.Document, P=root, K=Array(self._documents))
        )
        for part in self._documents:
            part.P = document
        root.K = Array([document])
        root.ParentTree = self._whole.make_indirect(Dictionary(Nums=Array(self._parents)))
        root.ParentTreeNextKey = self._next_key
        root.RoleMap = Dictionary(self._roles)
        if self._header_cells:
            names = [each for cell in sorted(self._header_cells, key=_by_name) for each in cell]
            root.IDTree = self._whole.make_indirect(_make_name_tree(names))
        self._whole.Root.StructTreeRoot = root
        self._whole.Root[Name.MarkInfo] = Dictionary(Marked=self._is_tagged)

    def _take_catalogue(self, part: pikepdf.Pdf) -> None:
        """The language, the title and what standard is kept, as the first part has them."""
        catalogue = self._whole.Root
        catalogue.Lang = String(str(part.Root.Lang))
        catalogue.Metadata = self._whole.copy_foreign(part.Root.Metadata)
        catalogue[Name.ViewerPreferences] = Dictionary(DisplayDocTitle=True)

    def _name_header_cells(self, tree: Object, prefix: str) -> None:
        """Header cells have names that their tables refer to, each of its own in a volume."""
        names = tree.get(Name.IDTree)
        tables: dict[tuple[int, int], Object] = {}
        for cell in _list_named(names) if names is not None else ():
            cell.ID = String(f"{prefix}{cell.ID}")
            self._header_cells.append((str(cell.ID), cell))
            table = _find_table(cell)
            tables[table.objgen] = table
        for table in tables.values():
            for cell in _list_cells(table):
                _rename_headers(cell, prefix)


def _by_name(cell: tuple[str, Object]) -> bytes:
    return cell[0].encode()


def _make_name_tree(names: Sequence[str | Object]) -> Dictionary:
    """A tree of names that are sorted, each followed by what bears it."""
    limits = Array([String(str(names[0])), String(str(names[-2]))])
    listed = Array([String(each) if isinstance(each, str) else each for each in names])
    return Dictionary(Kids=Array([Dictionary(Names=listed, Limits=limits)]))


def _list_kids(element: Object) -> list[Object]:
    kids = element.get(Name.K)
    found = list(kids) if isinstance(kids, Array) else [kids]
    return [kid for kid in found if isinstance(kid, Dictionary) and Name.S in kid]


def _list_named(names: Object) -> Iterator[Object]:
    """What bears the names of a tree."""
    yield from list(names.get(Name.Names, Array()))[1::2]
    for branch in names.get(Name.Kids, Array()):
        yield from _list_named(branch)


def _find_table(cell: Object) -> Object:
    element = cell
    while Name.S not in element or (Name.Table != element.S and Name.P in element):
        element = element.P
    return element


def _list_cells(element: Object) -> Iterator[Object]:
    """The cells below an element of a table."""
    for kid in _list_kids(element):
        if kid.S in (Name.TD, Name.TH):
            yield kid
        else:
            yield from _list_cells(kid)


def _rename_headers(cell: Object, prefix: str) -> None:
    attributes = cell.get(Name.A, Array())
    for each in attributes if isinstance(attributes, Array) else (attributes,):
        if Name.Headers in each:
            each.Headers = Array([String(f"{prefix}{name}") for name in each.Headers])
