"""Each flaw of a support is found where there is one, and none where there is none."""

from __future__ import annotations

import pytest

from tests.figures.support_flaws import find_support_flaws
from tests.figures.test_flaws import draw

# The hatching of a support about 20, at a height of 12, and of a floor
SUPPORT = (
    '<path d="M18 12L17 13M19 12L18 13M20 12L19 13M21 12L20 13M22 12L21 13" stroke-width="0.18"/>'
)
FLOOR = '<path d="M12 12L11 13M16 12L15 13M20 12L19 13M24 12L23 13" stroke-width="0.18"/>'
TOOTHED = '<path d="M12 6L28 6L28 12.5L12 12.5Z" fill="#ddd" stroke-width="0.2"/>'


def wheel(radius: float, fill: str = ' fill="#e8e8e8"') -> str:
    """A circle about a pin above the support."""
    return f'<circle cx="20" cy="8.4" r="{radius}"{fill} stroke-width="0.4"/>'


def find(*elements: str) -> list[str]:
    return [flaw.split(" at ")[0] for flaw in find_support_flaws(draw(*elements))]


@pytest.mark.parametrize("elements", [(wheel(5.2), SUPPORT), (TOOTHED, SUPPORT)])
def test_hatching_that_cuts_a_rim_is_found(elements: tuple[str, ...]) -> None:
    assert find(*elements) == ["hatching cuts a rim"]


@pytest.mark.parametrize(
    "elements",
    [
        (wheel(7.0), SUPPORT),
        (wheel(2.5), SUPPORT),
        (wheel(5.2, ""), SUPPORT),  # a circle that is no wheel
        (wheel(3.6), FLOOR),  # it rolls there
    ],
)
def test_a_support_within_a_wheel_or_clear_of_it_has_no_flaw(elements: tuple[str, ...]) -> None:
    assert find(*elements) == []
