"""The rules printed on a paper: how to write answers, and when an answer is right."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from math import sqrt

from kinegrade.exam.bank.blueprint import Bank
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.math.units import append_unit
from kinegrade.language.message import Message, Part, list_choices
from kinegrade.numbers.decimals import figures_interval
from kinegrade.numbers.tolerance import Tolerance

_NUMERALS: Mapping[int, Message] = {
    3: Message("paper.three"),
    4: Message("paper.four"),
    5: Message("paper.five"),
    6: Message("paper.six"),
    7: Message("paper.seven"),
}


def write_rules(bank: Bank, language: Language) -> tuple[str, ...]:
    """The sentences of the rules box, the same on all papers of an exam: how far an answer may be
    off stands in its row.
    """
    asked = [ask.tolerance for question in bank.questions for ask in question.asks]
    right = Message("paper.rule-of-rows")
    shares = sorted({tolerance.share for tolerance in asked if tolerance.share})
    if shares:
        near_zero = _make_rule_near_zero(shares)
        right = Message("paper.sentences", first=right, second=near_zero)
    figures = sorted({each.figures for each in asked if each.figures})
    rules = (
        _make_writing_rule(bank, asked),
        *_find_rule_of_axes(bank),
        right,
        *(Message("paper.rule-of-figures", **_give_example(each)) for each in figures),
    )
    of_bonus = (Message("paper.rule-of-bonus"),) if bank.has_bonus else ()
    return tuple(map(open_catalogue(language).write, (*rules, *of_bonus)))


def _find_rule_of_axes(bank: Bank) -> Iterator[Message]:
    """How axes and senses are counted, where something moves."""
    if any(question.template.scheme.has_mechanism for question in bank.questions):
        yield Message("paper.rule-of-axes")


def _make_writing_rule(bank: Bank, asked: Iterable[Tolerance]) -> Message:
    """How to work and how to write answers: with the digits that are to be carried."""
    digits = count_digits(bank.carry, asked)
    point = write_example(digits)
    writing = Message(
        "paper.rule-of-writing",
        digits=spell_out(digits),
        more=spell_out(digits + 1),
        point=point,
        comma=point.replace(".", ","),
    )
    return Message("paper.sentences", first=make_carrying_rule(digits), second=writing)


def write_example(digits: int) -> str:
    """A number with so many significant digits, for people to see what that is.

    >>> write_example(4)
    '0.8660'
    """
    return f"{sqrt(3) / 2:.{digits}f}"


def make_carrying_rule(digits: int) -> Message:
    """How many significant digits to carry."""
    return Message("paper.rule-of-carrying", digits=spell_out(digits))


def count_digits(carry: int, tolerances: Iterable[Tolerance]) -> int:
    """The significant digits to be carried: as the bank says; or, in exams of earlier versions, as
    many more as it takes to judge an answer by the strictest tolerance.
    """
    return max((carry, *(each.carried(Fraction(0)) for each in tolerances)))


def spell_out(number: int) -> Part:
    """A small number as a word, a larger one as it is."""
    return _NUMERALS.get(number, number)


def make_marking_rule(tolerance: Tolerance, unit: str, stated: Tolerance | None = None) -> Message:
    """When an answer in `unit` is right, in words a first-year reads, where no row states it.

    Next to zero the share that the bank has `stated` holds, where the tolerance is one paper's own.
    The sentence begins with a small letter, to follow a colon: `paper.rule` has it alone.
    """
    if tolerance.figures:
        return _make_figures_rule(tolerance, tolerance.figures, unit)
    if tolerance.relative == 0:
        return _make_amount_rule(tolerance.absolute, unit)
    share, zero = (
        make_percent(tolerance.relative),
        _make_rule_near_zero([(stated or tolerance).share]),
    )
    if not tolerance.absolute:
        return Message("paper.right-within-share", share=share, zero=zero)
    amount = _make_amount(tolerance.absolute, unit)
    return Message("paper.right-within-share-or-amount", share=share, amount=amount, zero=zero)


def _make_rule_near_zero(shares: Sequence[Fraction]) -> Message:
    """What is allowed where terms cancel, by the shares in ascending order that asks state: a row
    may show a wider one, which does not hold there.
    """
    share = make_percent(shares[0])
    if len(shares) == 1:
        return Message("paper.near-zero", share=share)
    return Message("paper.near-zero-least", share=share)


def _make_amount_rule(allowed: Fraction, unit: str) -> Message:
    rule = Message("paper.right-within-amount", amount=_make_amount(allowed, unit))
    decimals = make_decimals_rule(allowed)
    return Message("paper.sentences", first=rule, second=decimals) if decimals else rule


def make_decimals_rule(allowed: Fraction) -> Message | None:
    """How many decimals to write where an amount is allowed, whatever the size of the answer: four
    significant digits of 11.186 may leave an allowance of 0.002.

    Rounding to them takes at most half of what is allowed. None where nothing is allowed, as in a
    damaged key.

    >>> make_decimals_rule(Fraction(1, 500)), make_decimals_rule(Fraction(2))
    (Message('paper.write-decimals', count=3), Message('paper.write-whole'))
    """
    if allowed <= 0:
        return None
    count = 0
    while Fraction(1, 10**count) > allowed:
        count += 1
    return Message("paper.write-decimals", count=count) if count else Message("paper.write-whole")


def _make_figures_rule(tolerance: Tolerance, figures: int, unit: str) -> Message:
    """The rule of significant figures, by an example: to 3 of them, 1.2304 allows 1.225 to
    1.235.
    """
    parts = _give_example(figures) | {"zero": _make_rule_near_zero([tolerance.share])}
    amounts = []
    if tolerance.relative:
        amounts.append(Message("paper.share-of-value", share=make_percent(tolerance.relative)))
    if tolerance.absolute:
        amounts.append(_make_amount(tolerance.absolute, unit))
    if not amounts:
        return Message("paper.right-to-figures", **parts)
    return Message("paper.right-to-figures-or-within", amounts=list_choices(amounts), **parts)


def _give_example(figures: int) -> dict[str, Part]:
    """A value with what agrees with it to so many significant digits."""
    example = f"{'1.23456'[: figures + 1]}04"
    low, high = figures_interval(Fraction(example), figures)
    return {"figures": figures, "example": Decimal(example), "low": low, "high": high}


def _make_amount(amount: Fraction, unit: str) -> Message:
    return Message("paper.amount", number=write_amount(amount, unit))


def write_amount(amount: Fraction, unit: str, sign: str = "") -> str:
    r"""An amount as prose, with its unit and behind its sign: a pure number has no unit.

    >>> write_amount(Fraction(1, 4), "m/s"), write_amount(Fraction(1, 2), "deg", r"\pm")
    ('$0.25\\,\\unit{m/s}$', '$\\pm0.5^\\circ$')
    """
    return f"${append_unit(f'{sign}{write_plain(amount)}', unit)}$"


def make_percent(share: Fraction) -> Message:
    """A share in per cent.

    >>> open_catalogue(Language("en")).write(make_percent(Fraction(1, 100)))
    '1 %'
    """
    return Message("grammar.percent", number=share * 100)


def write_plain(number: Fraction) -> str:
    """A decimal without trailing zeros or power of ten; tolerances have at most 13 digits.

    >>> write_plain(Fraction(1, 8)), write_plain(Fraction(1, 100000))
    ('0.125', '0.00001')
    """
    return f"{Decimal(f'{float(number):.15g}'):f}"
