"""The keys of a question's draws: what is right, by which rule, and what known mistakes lead to."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from kinegrade.exam.setting.key_mistakes import WRONG_DIGITS, Mistaken
from kinegrade.exam.setting.setting import SetAsk
from kinegrade.language.html_text import write_unit_html
from kinegrade.language.prose.html import write_page_line
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.practice.document import PracticeAsk, PracticeKey, PracticeRule
from kinegrade.practice.drawn import DrawnQuestion
from kinegrade.press.html.short_texts import write_symbol_html
from kinegrade.press.places import locate_part
from kinegrade.press.sheet import AnswerRow
from kinegrade.problem.template.signs import Sign
from kinegrade.problem.template.translated import Translated
from kinegrade.stated_marking import find_identifier

_DIGITS = 12  # of right answers
_MOST_DIGITS = 12  # of ratios
_ZERO = 1e-12


@dataclass(frozen=True)
class KeyTable:
    """The keys of all draws of a question, and what they share."""

    asks: tuple[PracticeAsk, ...]
    rules: tuple[PracticeRule, ...]
    draws: tuple[tuple[PracticeKey, ...], ...]


def tabulate_keys(
    drawn: Sequence[DrawnQuestion], stages: Sequence[int], shares: Mapping[str, Fraction]
) -> KeyTable:
    """The keys of a question as several papers have it; its asks are of these `stages`, and
    `shares` of the points are given for known mistakes. Raises TypesetError.
    """
    first = drawn[0]
    template = first.question.question.template
    asks = tuple(
        replace(
            _make_ask(entry, row, template.asks[entry.ask.name].sign),
            stage=stage,
            mistakes=(labels := _list_labels(entry.ask.name, drawn)),
            credits=tuple(float(shares.get(find_identifier(each), 0)) for each in labels),
        )
        for entry, row, stage in zip(first.question.asks, first.sheet.rows, stages, strict=True)
    )
    rules = tuple(dict.fromkeys(ask.tolerance for each in drawn for ask in each.question.asks))
    draws = (
        tuple(
            _make_key(entry, rules.index(entry.tolerance), ask.mistakes, each.mistaken)
            for entry, ask in zip(each.question.asks, asks, strict=True)
        )
        for each in drawn
    )
    return KeyTable(asks, tuple(map(_make_rule, rules)), tuple(draws))


def _list_labels(ask: str, drawn: Sequence[DrawnQuestion]) -> tuple[str, ...]:
    """The labels of the mistakes that change the answer in any draw."""
    return tuple(dict.fromkeys(label for each in drawn for label in each.mistaken.get(ask, {})))


def _make_ask(entry: SetAsk, row: AnswerRow, sign: Sign) -> PracticeAsk:
    """An ask as papers have it."""
    where = locate_part(entry.ask.name, "meaning")
    meaning = write_page_line(f"{row.meaning[:1].upper()}{row.meaning[1:]}", where)
    words = write_page_line(row.sign, where)
    symbol = write_symbol_html(row.symbol)
    return PracticeAsk(
        name=entry.ask.name,
        label=f"{meaning} {symbol}{f' <small>({words})</small>' if words else ''}",
        unit=row.unit,
        shown=write_unit_html(row.unit),
        convention=None if isinstance(sign, Translated) else sign,
        sign=row.sign,
        points=float(entry.ask.points),
        period=float(entry.answer.full_turn) if entry.cyclic else 0.0,
    )


def _make_rule(tolerance: Tolerance) -> PracticeRule:
    return PracticeRule(float(tolerance.relative), float(tolerance.absolute), tolerance.figures)


def _make_key(entry: SetAsk, rule: int, labels: Sequence[str], mistaken: Mistaken) -> PracticeKey:
    known = mistaken.get(entry.ask.name, {})
    right = entry.answer.value
    shown = f"{right:.{_DIGITS}g}" if abs(right) > _ZERO else "0"
    unit = float(shown) or 1.0
    ratios = (_write_ratio(known[label], unit) if label in known else "" for label in labels)
    return shown, rule, " ".join(ratios)


def _write_ratio(wrong: str, unit: float) -> str:
    """The shortest ratio that gives the wrong value back, to as many digits as marks have of it."""
    ratio = float(wrong) / unit
    written = (f"{ratio:.{digits}g}" for digits in range(1, _MOST_DIGITS))
    same = (each for each in written if f"{float(each) * unit:.{WRONG_DIGITS}g}" == wrong)
    return next(same, f"{ratio:.{_MOST_DIGITS}g}")
