"""The places at which a translation of a template may have texts."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from kinegrade.files.fields.place import Place


def list_translated_places(content: Mapping[str, object]) -> dict[Place, Place]:
    """Each place of a text in a translation, with the place of the same text in the template."""
    return dict(_list_places(content))


def open_bodies(content: Mapping[str, object]) -> Mapping[str, object]:
    """The tables of a template in which each body has room for its name beside its points."""
    bodies = content.get("bodies")
    if not isinstance(bodies, dict):
        return content
    opened = {name: _open_body(entry) for name, entry in bodies.items()}
    return {**content, "bodies": opened}


def _open_body(entry: object) -> object:
    match entry:
        case str():
            return {"points": entry, "called": {}}
        case dict() if "called" not in entry:
            return {**entry, "called": {}}
        case _:
            return entry


def _list_places(content: Mapping[str, object]) -> Iterator[tuple[Place, Place]]:
    for key in ("title", "statement"):
        if key in content:
            yield (key,), (key,)
    for name, entry in _list_entries(content, "parameters"):
        if isinstance(entry, dict) and "means" in entry:
            yield ("parameters", name), ("parameters", name, "means")
    for name, entry in _list_entries(content, "bodies"):
        if isinstance(entry, dict):
            yield ("bodies", name), ("bodies", name, "called")
    for name, entry in _list_entries(content, "asks"):
        yield from _list_places_of_ask(name, entry)
    for name, entry in _list_entries(content, "reasons"):
        if isinstance(entry, dict | str):
            yield ("reasons", name), ("reasons", name)
    for name, wordings in _list_entries(content, "text"):
        for number in range(len(wordings) if isinstance(wordings, list) else 0):
            yield ("text", name, number), ("text", name, number)


def _list_places_of_ask(name: str, entry: object) -> Iterator[tuple[Place, Place]]:
    if not isinstance(entry, dict) or "means" not in entry:
        return
    place = ("asks", name, "means")
    yield ("asks", name), place
    yield place, place
    if isinstance(entry.get("sign"), dict):
        yield ("asks", name, "sign"), ("asks", name, "sign")


def _list_entries(content: Mapping[str, object], key: str) -> Iterator[tuple[str, object]]:
    table = content.get(key)
    yield from table.items() if isinstance(table, dict) else ()
