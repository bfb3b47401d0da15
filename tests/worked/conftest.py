"""All tests of one template's solutions share a worker, one after another: its solutions are written
once, and forgotten when the next template's are.
"""

from __future__ import annotations

from pathlib import Path

import pytest

HERE = Path(__file__).parent


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        name = _template(item)
        if HERE in item.path.parents and name is not None:
            item.add_marker(pytest.mark.xdist_group(f"solutions of {name}"))


def _template(item: pytest.Item) -> str | None:
    """The name of the template that a test is tried with."""
    call = getattr(item, "callspec", None)
    name = None if call is None else call.params.get("name")
    return name if isinstance(name, str) else None
