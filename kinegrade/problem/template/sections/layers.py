"""A template's file laid over that of a mechanism which it shares with other templates.

Entries of `[parameters]`, `[lengths]`, `[reasons]`, `[points]` and `[bodies]` are the mechanism's,
then the template's; of one name the template's wins, and a parameter is laid over key by key.
Joints and conditions are the mechanism's followed by the template's; the keys of `[figure]` are the
template's where it has them.
"""

from __future__ import annotations

from collections.abc import Mapping

from msgspec import Struct

from kinegrade.files.fields.place import Place, Source, Where
from kinegrade.problem.template.sections.keys import SHARED_LISTS, SHARED_TABLES

Content = Mapping[str, object]


class Layer(Struct, frozen=True):
    """The tables of one file, and the lines on which they stand."""

    content: Content
    document: Source


class Layers(Struct, frozen=True):
    """The tables of a template's file over those of its mechanism, as one source of faults."""

    template: Layer
    shared: Layer

    def content(self) -> dict[str, object]:
        """The tables together."""
        template, shared = self.template.content, _require_sharable(self.shared.content)
        both = {
            key: _lay_over(key, shared[key], template[key]) for key in shared if key in template
        }
        return {**shared, **template, **both}

    def where(self, place: Place) -> Where:
        """The file and the line of what stands at a place of the tables together; where both files
        have it, in the template's.
        """
        in_template = self._template_place(place)
        entry = 3 if place[:1] == ("parameters",) else 2
        shared_depth = _count_depth(self.shared.content, place[:entry])
        if shared_depth > _count_depth(self.template.content, in_template[:entry]):
            return self.shared.document.where(place)
        return self.template.document.where(in_template)

    def _template_place(self, place: Place) -> Place:
        """A place as counted in the template's file; below 0 where it is the mechanism's."""
        match place:
            case (str() as key, int() as number, *inside) if key in SHARED_LISTS:
                listed = self.shared.content.get(key)
                before = len(listed) if isinstance(listed, list) else 0
                return (key, number - before, *inside)
            case _:
                return place


def is_sharable(key: str, value: object) -> bool:
    """Whether templates can share what stands under a key of a mechanism's file."""
    if key in SHARED_LISTS:
        return isinstance(value, list)
    return key in SHARED_TABLES and isinstance(value, dict)


def _require_sharable(content: Content) -> Content:
    return {key: value for key, value in content.items() if is_sharable(key, value)}


def _lay_over(key: str, shared: object, template: object) -> object:
    """A table or list over the mechanism's; one of the wrong kind is kept, to be refused later."""
    match shared, template:
        case list(), list():
            return [*shared, *template]
        case dict(), dict():
            merged = {
                name: {**shared[name], **template[name]}
                for name in _find_in_both(key, shared, template)
            }
            return {**shared, **template, **merged}
        case _:
            return template


def _find_in_both(key: str, shared: Content, template: Content) -> list[str]:
    """The parameters that both files describe."""
    if key != "parameters":
        return []
    return [
        name
        for name in shared
        if isinstance(shared[name], dict) and isinstance(template.get(name), dict)
    ]


def _count_depth(content: Content, place: Place) -> int:
    """How many steps of a place lead to something."""
    inside: object = content
    for depth, step in enumerate(place):
        match inside, step:
            case dict(), str() if step in inside:
                inside = inside[step]
            case list(), int() if 0 <= step < len(inside):
                inside = inside[step]
            case _:
                return depth
    return len(place)
