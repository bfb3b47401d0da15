"""Joints, inputs and sign conventions as templates write them."""

from __future__ import annotations

from typing import Any

import pytest

from kinegrade.errors import FieldError
from kinegrade.expressions.tree import Number
from kinegrade.mechanics.drivers import Circulation, Component, Rotation
from kinegrade.mechanics.joints import (
    Arc,
    Belt,
    Contact,
    Mesh,
    Parallel,
    Pin,
    Roll,
    Sleeve,
    Slide,
)
from kinegrade.problem.template.sections.asks import read_sign
from kinegrade.problem.template.sentences import read_driver, read_joint
from kinegrade.problem.template.translated import Translated


@pytest.mark.parametrize(
    ("text", "stated", "fields"),
    [
        ("pin A: OA AB", Pin, {"point": "A", "bodies": ("OA", "AB")}),
        ("pin A: OA, AB, AC", Pin, {"bodies": ("OA", "AB", "AC")}),
        ("B of AB slides on line(O, 0)", Slide, {"point": "B", "body": "AB", "of": "ground"}),
        ("A of AB slides on line(O, A) of OC", Slide, {"of": "OC"}),
        ("O of ground slides on line(O, A) of AB", Slide, {"body": "ground", "of": "AB"}),
        ("AB slides through sleeve along line(O, A)", Sleeve, {"body": "AB", "of": "sleeve"}),
        ("M stays on circle(O1, R) of ring1", Arc, None),
        (
            "M of rod stays on circle(O1, R) of ring1",
            Arc,
            {"point": "M", "body": "rod", "of": "ring1"},
        ),
        (
            "circle(C, R) of cam touches line(A, 0) of BC",
            Contact,
            {"body": "cam", "of": "BC", "options": set()},
        ),
        (
            "circle(C, R) of cam touches circle(D, r + 1) of BC inside",
            Contact,
            {"options": {"inside"}},
        ),
        (
            "circle(A, r2) of II rolls on circle(O, r1) inside",
            Roll,
            {"body": "II", "of": "ground", "options": {"inside"}},
        ),
        (
            "circle(A, (r1 + r2)/2) of II rolls on line(O, 0) of rack",
            Roll,
            {"of": "rack", "options": set()},
        ),
        (
            "circle(A, r1) of I meshes with circle(B, r2) of II on arm",
            Mesh,
            {"of": "II", "carrier": "arm", "options": set()},
        ),
        (
            "circle(A, r1) of I meshes with circle(B, r2) of ground on arm inside",
            Mesh,
            {"of": "ground", "options": {"inside"}},
        ),
        (
            "open belt: circle(A, r1) of I, circle(B, r2) of II on arm",
            Belt,
            {"body": "I", "of": "II", "carrier": "arm", "options": set()},
        ),
        (
            "crossed belt: circle(A, (r1 + r2)/2) of I, circle(B, r2) of ground on arm",
            Belt,
            {"of": "ground", "options": {"crossed"}},
        ),
        ("belt: circle(A, r1) of I, circle(B, r2) of II on arm", Belt, None),
        ("BC translates", Parallel, {"body": "BC", "of": "ground"}),
        ("rod turns with arm", Parallel, {"body": "rod", "of": "arm"}),
    ],
)
def test_joint_sentences(text: str, stated: type, fields: dict[str, Any] | None) -> None:
    if fields is None:
        with pytest.raises(FieldError, match="no such joint"):
            read_joint(text)
        return
    sentence = read_joint(f"  {text} ")
    assert sentence.stated is stated
    assert {name: getattr(sentence, name) for name in fields} == fields


@pytest.mark.parametrize(
    ("text", "stated", "fields"),
    [
        ("OA turns", Rotation, {"body": "OA", "of": "ground"}),
        ("AB turns relative to OA", Rotation, {"of": "OA"}),
        ("B of AB moves along -x", Component, {"point": "B", "body": "AB", "of": "ground"}),
        ("M of M moves along direction(O, A) relative to AE", Component, {"of": "AE"}),
        ("A of W circles O", Circulation, {"point": "A", "body": "W", "centre": "O"}),
    ],
)
def test_input_sentences(text: str, stated: type, fields: dict[str, str]) -> None:
    sentence = read_driver(text, Number(1), Number(0))
    assert sentence.stated is stated
    assert {name: getattr(sentence, name) for name in fields} == fields


def test_inputs_refused() -> None:
    with pytest.raises(
        FieldError,
        match='"OA moves": no such input - did you mean .*"B of AB moves along \\+x".*words inputs',
    ):
        read_driver("OA moves", Number(1), Number(0))
    with pytest.raises(FieldError, match="a sentence of 401 characters - expected at most 400"):
        read_driver("O" * 401, Number(1), Number(0))


def test_signs_in_words() -> None:
    assert read_sign("ccw") == "ccw"
    assert read_sign({"en": "up", "zh": "上"}) == Translated((("en", "up"), ("zh", "上")))
    assert read_sign({"en": "up"}) == Translated((("en", "up"),))
    with pytest.raises(FieldError, match='"ccv" - expected a keyword, or .* - did you mean "ccw"'):
        read_sign("ccv")
    with pytest.raises(FieldError, match='unknown: "ef" - expected a language'):
        read_sign({"ef": "up"})
