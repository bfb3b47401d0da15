"""The structure trees of bound files as one, so that a volume can be heard as its parts can.

The trees are those that Typst writes: pages refer to them, tables name their header cells. A part
without a tree, such as a formula sheet that somebody brought, leaves the volume without the
statement that all of it is tagged.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain

from kinegrade.press.binding.packed import PackedFile
from kinegrade.press.binding.part import Part
from kinegrade.press.binding.renumbering import Renumbering
from kinegrade.press.binding.values import Dictionary, Reference, Value, write_value


class JoinedStructure:
    """The tree of a volume that grows by parts; what they add to its indices is written at once."""

    def __init__(self, file: PackedFile) -> None:
        self._file = file
        self._root, self._document = file.reserve(), file.reserve()
        self._next_key = 0
        self._documents: list[Value] = []
        self._parents: list[Value] = []
        self._names: list[tuple[bytes, bytes, Value]] = []  # first and last of each branch
        self._roles: Dictionary = {}
        self._is_tagged = True
        self._about: Dictionary = {}  # what the first part says of itself

    def add(self, part: Part, first: int) -> Renumbering:
        """Take over the tree of a part. Gives how the part is numbered from `first` on."""
        root = part.catalogue.get(b"/StructTreeRoot")
        moved = {root.number: self._document} if isinstance(root, Reference) else {}
        prefix = b"%d" % len(self._documents)
        renumbering = Renumbering(first, moved, self._next_key, prefix)
        tree = part.look_up_dictionary(root)
        if tree:
            self._take(part, tree, renumbering)
        else:
            self._is_tagged = False
        return renumbering

    def close(self) -> Dictionary:
        """Write the tree into the volume. Gives what its catalogue says."""
        if not self._documents:
            return {}
        root, document = Reference(self._root), Reference(self._document)
        element: Dictionary = {b"/Type": b"/StructElem", b"/S": b"/Document", b"/P": root}
        tree: Dictionary = {
            b"/Type": b"/StructTreeRoot",
            b"/K": [document],
            b"/ParentTree": {b"/Kids": self._parents},
            b"/ParentTreeNextKey": b"%d" % self._next_key,
            b"/RoleMap": self._roles,
        }
        if self._names:
            tree[b"/IDTree"] = {b"/Kids": [branch for _, _, branch in sorted(self._names)]}
        self._file.put(self._document, write_value(element | {b"/K": self._documents}))
        self._file.put(self._root, write_value(tree))
        return self._about | {
            b"/StructTreeRoot": root,
            b"/MarkInfo": {b"/Marked": b"true" if self._is_tagged else b"false"},
            b"/ViewerPreferences": {b"/DisplayDocTitle": b"true"},
        }

    def _take(self, part: Part, tree: Dictionary, renumbering: Renumbering) -> None:
        if not self._documents:
            self._about = self._copy_about(part)
        leaves = _list_leaves(part, tree.get(b"/ParentTree"), b"/Nums")
        keys = [(self._next_key + int(key), value) for key, value in leaves]
        if keys:  # an empty page has none
            numbers = [(b"%d" % key, value) for key, value in keys]
            self._parents.append(self._put_branch(b"/Nums", numbers, renumbering))
            self._next_key = max(key for key, _ in keys) + 1
        leaves = _list_leaves(part, tree.get(b"/IDTree"), b"/Names")
        if names := [(renumbering.name(name), value) for name, value in leaves]:
            branch = self._put_branch(b"/Names", names, renumbering)
            self._names.append((names[0][0], names[-1][0], branch))
        self._roles |= part.look_up_dictionary(tree.get(b"/RoleMap"))
        kids = part.look_up(tree[b"/K"])
        documents = kids if isinstance(kids, list) else [tree[b"/K"]]
        self._documents += [renumbering.write(write_value(kid)) for kid in documents]

    def _copy_about(self, part: Part) -> Dictionary:
        """The language of a part, and its title and what standard it keeps, in the volume."""
        about = {b"/Lang": part.look_up(part.catalogue.get(b"/Lang"))}
        metadata = part.catalogue.get(b"/Metadata")
        if isinstance(metadata, Reference):
            number = self._file.reserve()
            self._file.put(number, *part.objects[metadata.number])
            about[b"/Metadata"] = Reference(number)
        return {key: value for key, value in about.items() if value is not None}

    def _put_branch(
        self, kind: bytes, entries: list[tuple[bytes, Value]], renumbering: Renumbering
    ) -> Reference:
        """Write a branch of an index."""
        limits: list[Value] = [entries[0][0], entries[-1][0]]
        branch: Dictionary = {b"/Limits": limits, kind: list(chain.from_iterable(entries))}
        number = self._file.reserve()
        self._file.put(number, renumbering.write(write_value(branch)))
        return Reference(number)


def _list_leaves(part: Part, tree: Value | None, kind: bytes) -> Iterator[tuple[bytes, Value]]:
    """What an index has, by its keys, in order."""
    node = part.look_up_dictionary(tree)
    entries, branches = part.look_up(node.get(kind)), part.look_up(node.get(b"/Kids"))
    if isinstance(entries, list):
        keys = (key for key in entries[::2] if isinstance(key, bytes))
        yield from zip(keys, entries[1::2], strict=True)
    for branch in branches if isinstance(branches, list) else ():
        yield from _list_leaves(part, branch, kind)
