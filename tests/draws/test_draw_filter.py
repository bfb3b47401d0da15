"""What the filter of a question keeps, so that no combination is solved twice without need."""

from __future__ import annotations

import pytest

from kinegrade.draws import dealt as dealing
from tests.problem.crank import crank
from tests.problem.draws import draw_filter


def test_what_the_filter_found_is_set_without_being_solved_again(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    draws = draw_filter(crank())
    verdicts = draws.verdicts(range(draws.deck.size))
    good = [place for place, verdict in enumerate(verdicts) if verdict is None]
    combinations = [draws.deck.combination(place) for place in good]
    monkeypatch.setattr(dealing, "_KEPT", 1)  # the others are set in between
    monkeypatch.setattr(dealing, "solve_template", lambda *_: pytest.fail("solved again"))
    for values in reversed(combinations):
        assert draws.dealt.solved(values) is draws.dealt._find_dealt(values).solution
    assert len(combinations) > 1
    with pytest.raises(pytest.fail.Exception, match="solved again"):
        draws.dealt.solved(combinations[-1])  # it was set long ago
