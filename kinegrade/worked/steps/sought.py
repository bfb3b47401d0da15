"""What is known and what is sought, the first sentence of a solution."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence, Set
from typing import assert_never

from kinegrade.language.math.tree import Fenced, Node, Row
from kinegrade.language.message import Message, Text, list_all
from kinegrade.mechanics.drivers.imposed import select_imposed
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import (
    Imposed,
    ImposedCircling,
    ImposedComponent,
    ImposedMotion,
    ImposedRotation,
)
from kinegrade.mechanics.plan import Step
from kinegrade.problem.template.signs import write_sign
from kinegrade.problem.template.template import Ask
from kinegrade.sign_conventions import UNSIGNED
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.symbols import read_symbol
from kinegrade.worked.rates.driven import is_assumed
from kinegrade.worked.unlettered import find_translating_body

_LENGTH = re.compile(r"\$[A-Z\d_{}']+\$")
_NARROWED = re.compile(r"([^()（）]+?)\s*[(（]([^()（）]+)[)）]")


def name_task(
    imposing: Iterable[Step], asked: Sequence[Ask], later: Iterable[Row], case: Case
) -> Message:
    """What is known and what is sought: a magnitude between bars where a formula `later` gives it
    so, as its letter alone has a sign.
    """
    signed = {line[0] for line in later if line and isinstance(line[0], Fenced)}
    sought = list_all(dict.fromkeys(_define(ask, signed, case) for ask in asked))
    relations = (index for step in imposing for index in step.relations)
    laws = (case.motion.frames.relations[index].source for index in dict.fromkeys(relations))
    imposed = [law for law in map(select_imposed, laws) if law is not None]
    known = dict.fromkeys(name for law in imposed for name in _name_given(law, case))
    if not known:
        return Message("solution.idea-sought", sought=sought)
    return Message("solution.idea-known", known=list_all(known), sought=sought)


def _define(ask: Ask, signed: Set[Node], case: Case) -> Text:
    """The symbol of what is sought, between bars only where that is never negative, with its
    meaning, where the author gives that in the language: what this has in brackets stands behind
    it, what names the symbol stands for both. The question's sense stands with it where the page
    counts the letter in the other one.
    """
    magnitude = abs(read_symbol(ask.symbol))
    bare = ask.sign not in UNSIGNED or magnitude.print(case.notation)[0] not in signed
    symbol = f"${ask.symbol if bare else case.text(magnitude)}$"
    if not ask.means.has(case.language):
        return symbol
    means = ask.means.in_language(case.language)
    if symbol in means and _LENGTH.fullmatch(symbol):
        return means
    if ask.name in case.findings.counted:
        sign = write_sign(ask.sign, case.language)
        return Message("solution.sought-of", symbol=symbol, means=means, of=sign)
    narrowed = _NARROWED.fullmatch(means)
    if narrowed is None:
        return Message("solution.sought", symbol=symbol, means=means)
    return Message("solution.sought-of", symbol=symbol, means=narrowed[1], of=narrowed[2])


def _name_given(law: Imposed, case: Case) -> Iterator[Message]:
    """The motion that a driver imposes."""
    match law:
        case ImposedRotation(body=body, of=of) if of == GROUND:
            if not is_assumed(law, case):
                yield Message("solution.rotation-of", body=case.naming.body(body))
        case ImposedRotation(body=body, of=of):
            name, other = map(case.naming.body, (body, of))
            yield Message("solution.rotation-relative-to", body=name, other=other)
        case ImposedMotion(point=point, of=of) if of != GROUND:
            moving, frame = case.naming.point(point), case.naming.body(of)
            yield Message("solution.motion-relative-to", point=moving, other=frame)
        case ImposedMotion(point=point) | ImposedComponent(point=point) if (
            carrier := find_translating_body(point, case)
        ):
            yield Message("solution.motion-of-body", body=case.naming.body(carrier))
        case ImposedMotion() | ImposedComponent() | ImposedCircling():
            yield Message("solution.motion-along-path", centre=case.naming.point(law.point))
        case _:
            assert_never(law)
