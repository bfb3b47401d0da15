"""Which tests one worker of the suite runs: those of a group together, those that share what is made
once for their module, and the others in parts of those that stand together. A test that is sent to
a worker alone costs three milliseconds for sending it, and what it shares with the next one is found
by both workers.

`--part 2/6` runs every sixth group, from the third: six runs that differ in the part alone run each
test once.
"""

from __future__ import annotations

import pytest

GROUP = "xdist_group"
PART = 16  # tests; a part takes a second or some, so that no worker waits long at the end


def group_tests(items: list[pytest.Item]) -> None:
    """Let every test be of a group; those that have groups of their own begin, as the longest of
    them are longer than any part.
    """
    for item in items:
        if isinstance(item, pytest.Function) and _shares(item):
            item.add_marker(pytest.mark.xdist_group(item.module.__name__))
    others = [item for item in items if item.get_closest_marker(GROUP) is None]
    for place, item in enumerate(others):
        item.add_marker(pytest.mark.xdist_group(f"part {place // PART}"))
    last = set(map(id, others))
    items.sort(key=lambda item: id(item) in last)


def keep_part(config: pytest.Config, items: list[pytest.Item], part: str) -> None:
    """Leave the tests of other parts out of a run; those of a group stand together."""
    group_tests(items)
    groups: dict[object, list[pytest.Item]] = {}
    for item in items:
        name = next(mark.args[0] for mark in item.iter_markers(GROUP))
        groups.setdefault(name, []).append(item)
    number, parts = map(int, part.split("/"))
    kept = [item for group in list(groups.values())[number::parts] for item in group]
    chosen = set(map(id, kept))
    config.hook.pytest_deselected(items=[item for item in items if id(item) not in chosen])
    items[:] = kept


def _shares(item: pytest.Function) -> bool:
    """Whether a test uses a fixture of its module, and is in no other group."""
    if item.get_closest_marker(GROUP) is not None:
        return False
    definitions = item._fixtureinfo.name2fixturedefs.values()
    return any(one.scope == "module" for each in definitions for one in each)
