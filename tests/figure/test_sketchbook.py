"""Figures that processes share: the same as ever, drawn once, kept whole."""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.figure import sketchbook
from kinegrade.figure.scene import Scene
from kinegrade.figure.similar_mechanisms import Subject
from kinegrade.figure.sketch import sketch
from kinegrade.figure.sketchbook import choose_sketcher, open_sketchbook, sketch_once
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template


@pytest.mark.parametrize(
    "name", ["slider-crank", "flat-faced-follower-curvature-radius", "pin-in-two-rings"]
)
def test_a_figure_from_the_book_is_the_figure(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    template = load_template(name)
    mechanism = solve_template(template, {}, []).assembly.mechanism.map(float)
    expected = sketch(mechanism, template.figure)
    assert sketch_once(tmp_path, mechanism, template.figure) == expected
    assert len(list(tmp_path.iterdir())) == 1
    sketchbook._read_kept.cache_clear()  # as another process has it
    monkeypatch.setattr(sketchbook, "draw_unit_figure", refuse)
    assert repr(sketch_once(tmp_path, mechanism, template.figure)) == repr(expected)


def test_a_book_is_private_to_several_processes_and_goes_with_them() -> None:
    with open_sketchbook(2) as book:
        assert book is not None
        assert list(book.iterdir()) == []
        assert choose_sketcher(book) is not sketch
    assert not book.exists()
    with open_sketchbook(1) as none:
        assert choose_sketcher(none) is sketch


def refuse(shown: Subject) -> Scene:
    raise AssertionError(shown.text)
