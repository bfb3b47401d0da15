"""The rules printed on a paper: how to write answers, and when an answer is right."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal
from fractions import Fraction

from kinegrade.exam.blueprint import Bank, BankQuestion, Tolerance
from kinegrade.problem.template import Language

WRITING = {
    "en": "Write one number into each box, in the unit printed there, with at least four significant digits: "
          "0.8660 or 0,8660. Do not separate thousands.",
    "zh": "每个答案框内填写一个数，单位已印在框内，至少保留四位有效数字，写成 0.8660 或 0,8660 均可；"
          "不要使用千位分隔符。",
}
AXES = {
    "en": "The $x$ axis points to the right, the $y$ axis upwards; counter-clockwise is positive unless stated "
          "otherwise. Figures are drawn to scale.",
    "zh": "$x$ 轴向右，$y$ 轴向上；除另有说明外，均以逆时针为正。附图按比例绘制。",
}
RELATIVE = {
    "en": "An answer is right if it differs from the exact value by at most {relative} of that value{absolute}. Where "
          "the exact value is zero, it may differ by at most {relative} of the largest quantity of its kind in the "
          "mechanism.",
    "zh": "答案与精确值之差不超过精确值的 {relative}{absolute}即判为正确；"
          "精确值为零时，允许的偏差为该机构中同类量最大值的 {relative}。",
}
ABSOLUTE = {
    "en": "An answer is right if it differs from the exact value by at most {amount} in the unit of the table.",
    "zh": "答案与精确值之差不超过 {amount}（以表中单位计）即判为正确。",
}
OR_ABSOLUTE = {
    "en": ", or by at most {amount} in the unit of the table, whichever is more",
    "zh": "（或不超过 {amount}，以表中单位计，取其大者）",
}
EXCEPTION = {"en": "For {what}: {rule}", "zh": "{what}：{rule}"}


def rules(bank: Bank, language: Language) -> tuple[str, ...]:
    """The sentences of the rules box, with the tolerances of single questions and asks where they differ."""
    sentences = [WRITING[language], AXES[language], marking_rule(bank.tolerance, language)]
    for question in bank.questions:
        for tolerance, what in exceptions(bank, question):
            rule = marking_rule(tolerance, language)
            sentences.append(EXCEPTION[language].format(what=what, rule=rule[0].lower() + rule[1:]))
    return tuple(sentences)


def exceptions(bank: Bank, question: BankQuestion) -> Iterator[tuple[Tolerance, str]]:
    """The tolerances of a question that are not the bank's, with what they hold for: all of it, or single asks."""
    tolerances = {ask.tolerance for ask in question.asks}
    if len(tolerances) == 1 and tolerances != {bank.tolerance}:
        yield tolerances.pop(), question.identifier
        return
    for ask in question.asks:
        if ask.tolerance != bank.tolerance:
            yield ask.tolerance, f"{question.identifier}, ${question.template.asks[ask.name].symbol}$"


def marking_rule(tolerance: Tolerance, language: Language) -> str:
    """When an answer is right, in words a first-year reads."""
    if tolerance.relative == 0:
        return ABSOLUTE[language].format(amount=plain(tolerance.absolute))
    also = OR_ABSOLUTE[language].format(amount=plain(tolerance.absolute)) if tolerance.absolute else ""
    return RELATIVE[language].format(relative=percent(tolerance.relative), absolute=also)


def percent(share: Fraction) -> str:
    """A share in per cent.

    >>> percent(Fraction(1, 100))
    '1 %'
    """
    return f"{plain(share * 100)} %"


def plain(number: Fraction) -> str:
    """A decimal without trailing zeros or power of ten; tolerances have at most 13 digits.

    >>> plain(Fraction(1, 8)), plain(Fraction(1, 100000))
    ('0.125', '0.00001')
    """
    return f"{Decimal(f'{float(number):.15g}'):f}"
