"""Joints, inputs and sign conventions as templates write them."""

from __future__ import annotations

from typing import Any

import pytest

from kinegrade.errors import FieldError
from kinegrade.expressions.tree import Number
from kinegrade.problem.template.sections.asks import read_sign
from kinegrade.problem.template.sentences import read_driver, read_joint
from kinegrade.problem.template.translated import Translated


@pytest.mark.parametrize(
    ("text", "kind", "fields"),
    [
        ("pin A: OA AB", "pin", {"point": "A", "bodies": ("OA", "AB")}),
        ("pin A: OA, AB, AC", "pin", {"bodies": ("OA", "AB", "AC")}),
        ("B of AB slides on line(O, 0)", "slide", {"point": "B", "body": "AB", "of": "ground"}),
        ("A of AB slides on line(O, A) of OC", "slide", {"of": "OC"}),
        ("O of ground slides on line(O, A) of AB", "slide", {"body": "ground", "of": "AB"}),
        ("AB slides through sleeve along line(O, A)", "sleeve", {"body": "AB", "of": "sleeve"}),
        ("M stays on circle(O1, R) of ring1", "arc", None),
        (
            "M of rod stays on circle(O1, R) of ring1",
            "arc",
            {"point": "M", "body": "rod", "of": "ring1"},
        ),
        (
            "circle(C, R) of cam touches line(A, 0) of BC",
            "contact",
            {"body": "cam", "of": "BC", "options": set()},
        ),
        (
            "circle(C, R) of cam touches circle(D, r + 1) of BC inside",
            "contact",
            {"options": {"inside"}},
        ),
        (
            "circle(A, r2) of II rolls on circle(O, r1) inside",
            "roll",
            {"body": "II", "of": "ground", "options": {"inside"}},
        ),
        (
            "circle(A, (r1 + r2)/2) of II rolls on line(O, 0) of rack",
            "roll",
            {"of": "rack", "options": set()},
        ),
        (
            "circle(A, r1) of I meshes with circle(B, r2) of II on arm",
            "mesh",
            {"of": "II", "carrier": "arm", "options": set()},
        ),
        (
            "circle(A, r1) of I meshes with circle(B, r2) of ground on arm inside",
            "mesh",
            {"of": "ground", "options": {"inside"}},
        ),
        (
            "open belt: circle(A, r1) of I, circle(B, r2) of II on arm",
            "belt",
            {"body": "I", "of": "II", "carrier": "arm", "options": set()},
        ),
        (
            "crossed belt: circle(A, (r1 + r2)/2) of I, circle(B, r2) of ground on arm",
            "belt",
            {"of": "ground", "options": {"crossed"}},
        ),
        ("belt: circle(A, r1) of I, circle(B, r2) of II on arm", "belt", None),
        ("BC translates", "parallel", {"body": "BC", "of": "ground"}),
        ("rod turns with arm", "parallel", {"body": "rod", "of": "arm"}),
    ],
)
def test_joint_sentences(text: str, kind: str, fields: dict[str, Any] | None) -> None:
    if fields is None:
        with pytest.raises(FieldError, match="no such joint"):
            read_joint(text)
        return
    sentence = read_joint(f"  {text} ")
    assert sentence.kind == kind
    assert {name: getattr(sentence, name) for name in fields} == fields


@pytest.mark.parametrize(
    ("text", "kind", "fields"),
    [
        ("OA turns", "rotation", {"body": "OA", "of": "ground"}),
        ("AB turns relative to OA", "rotation", {"of": "OA"}),
        ("B of AB moves along -x", "component", {"point": "B", "body": "AB", "of": "ground"}),
        ("M of M moves along direction(O, A) relative to AE", "component", {"of": "AE"}),
        ("A of W circles O", "circulation", {"point": "A", "body": "W", "centre": "O"}),
    ],
)
def test_input_sentences(text: str, kind: str, fields: dict[str, str]) -> None:
    sentence = read_driver(text, Number(1), Number(0))
    assert sentence.kind == kind
    assert {name: getattr(sentence, name) for name in fields} == fields


def test_inputs_refused() -> None:
    with pytest.raises(
        FieldError,
        match='"OA moves": no such input - expected one of "OA turns", "AB turns relative to OA"',
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
