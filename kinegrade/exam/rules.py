"""The rules printed on a paper: how to write answers, and when an answer is right."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from decimal import Decimal
from fractions import Fraction
from math import sqrt

from kinegrade.exact.figures import figures_interval
from kinegrade.exam.blueprint import Bank, BankQuestion
from kinegrade.language import Language
from kinegrade.problem.tolerance import Tolerance

_WRITING = {
    "en": "Write one number into each box, in the unit printed there, with at least {digits} "
    "significant digits: {point} or {comma}. Do not separate thousands.",
    "zh": "每个答案框内填写一个数，单位已印在框内，至少保留{digits}位有效数字，写成 {point} 或 {comma} 均可；"
    "不要使用千位分隔符。",
}
_AXES = {
    "en": "The $x$ axis points to the right, the $y$ axis upwards; counter-clockwise is positive "
    "unless stated otherwise. Figures are drawn to scale.",
    "zh": "$x$ 轴向右，$y$ 轴向上；除另有说明外，均以逆时针为正。附图按比例绘制。",
}
_RELATIVE = {
    "en": "An answer is right if it differs from the exact value by at most {relative} of that "
    "value{absolute}. {zero}",
    "zh": "答案与精确值之差不超过精确值的 {relative}{absolute}即判为正确。{zero}",
}
_FIGURES = {
    "en": "An answer is right if it agrees with the exact value to {figures} significant digits "
    "(where that is {example}, from {low} to {high}){others}. {zero}",
    "zh": "答案与精确值在 {figures} 位有效数字内一致（如精确值为 {example} 时，从 {low} 到 {high}）{others}即判为正确。"
    "{zero}",
}
_ZERO = {
    "en": "Where the exact value is zero, or less than {share} of the largest quantity of its kind "
    "in the mechanism, {share} of that quantity is allowed.",
    "zh": "精确值为零或小于该机构中同类量最大值的 {share} 时，允许偏差为该最大值的 {share}。",
}
_ABSOLUTE = {
    "en": "An answer is right if it differs from the exact value by at most {amount}{table}.",
    "zh": "答案与精确值之差不超过 {amount}{table}即判为正确。",
}
# Four significant digits of 11.186 may leave an allowance of 0.002: then decimals are asked for.
_WRITE_DECIMALS = {
    "en": " Write at least {decimals}.",
    "zh": "至少写出{decimals}。",
}
_TO_THE_UNIT = {"en": "every digit before the decimal point", "zh": "整数部分的各位数字"}
_ONE_DECIMAL = {"en": "one decimal", "zh": " 1 位小数"}
_DECIMALS = {"en": "{count} decimals", "zh": " {count} 位小数"}
_OR_ABSOLUTE = {
    "en": ", or by at most {amount}{table}, whichever is more",
    "zh": "（或不超过 {amount}{table}，取其大者）",
}
_OR_WITHIN = {
    "en": ", or differs from it by at most {amounts}",
    "zh": "，或与其之差不超过{amounts}，",
}
_OF_VALUE = {"en": "{relative} of it", "zh": "精确值的 {relative}"}
_IN_UNIT = {"en": "{amount}{table}", "zh": " {amount}{table}"}
_IN_TABLE = {"en": " in the unit of the table", "zh": "（以表中单位计）"}
_IN_TABLE_ASIDE = {"en": " in the unit of the table", "zh": "，以表中单位计"}  # inside brackets
_OR = {"en": " or ", "zh": "或"}
NUMERALS = {"en": ("four", "five", "six", "seven", "eight", "nine", "ten"), "zh": "四五六七八九十"}
FEWEST_DIGITS = 4
EXCEPTION = {"en": "For {what}: {rule}", "zh": "{what}：{rule}"}
_WHOLE = {"en": "question {number}", "zh": "第 {number} 题"}
_PART = {"en": "question {number}, ${symbol}$", "zh": "第 {number} 题 ${symbol}$"}


def write_rules(bank: Bank, language: Language, order: Sequence[str] = ()) -> tuple[str, ...]:
    """The sentences of the rules box, with the tolerances of single questions and asks where they
    differ.

    `order` holds the identifiers of the questions in their order on the paper, which gives their
    numbers there; by default it is the bank's.
    """
    places = order or [question.identifier for question in bank.questions]
    numbers = {identifier: number for number, identifier in enumerate(places, start=1)}
    sentences = [
        _write_writing_rule(bank, language),
        _AXES[language],
        write_marking_rule(bank.tolerance, language),
    ]
    for question in sorted(bank.questions, key=lambda each: numbers[each.identifier]):
        number = numbers[question.identifier]
        for tolerance, what in _find_exceptions(bank, question, number, language):
            rule = write_marking_rule(tolerance, language)
            sentences.append(EXCEPTION[language].format(what=what, rule=rule[0].lower() + rule[1:]))
    return tuple(sentences)


def _find_exceptions(
    bank: Bank, question: BankQuestion, number: int, language: Language
) -> Iterator[tuple[Tolerance, str]]:
    """The tolerances of a question that are not the bank's, with what they apply to: all of it, or
    single asks.
    """
    tolerances = {ask.tolerance for ask in question.asks}
    if len(tolerances) == 1 and tolerances != {bank.tolerance}:
        yield tolerances.pop(), _WHOLE[language].format(number=number)
        return
    for ask in question.asks:
        if ask.tolerance != bank.tolerance:
            symbol = question.template.asks[ask.name].symbol
            yield ask.tolerance, _PART[language].format(number=number, symbol=symbol)


def _write_writing_rule(bank: Bank, language: Language) -> str:
    """How to write answers: with four digits, or as many as it takes to judge an answer by the
    strictest tolerance.
    """
    carried = [
        ask.tolerance.carried(Fraction(0)) for question in bank.questions for ask in question.asks
    ]
    digits = max((FEWEST_DIGITS, *carried))
    point = f"{sqrt(3) / 2:.{digits}f}"
    numerals = NUMERALS[language][digits - FEWEST_DIGITS :]
    return _WRITING[language].format(
        digits=numerals[0] if numerals else str(digits), point=point, comma=point.replace(".", ",")
    )


def write_marking_rule(tolerance: Tolerance, language: Language, unit: str = "") -> str:
    """When an answer is right, in words a first-year reads.

    An amount is in the unit of the paper's table, or in `unit`, which is named with it, where there
    is no table.
    """
    zero = _ZERO[language].format(share=write_percent(tolerance.share))
    if tolerance.figures:
        return _write_figures_rule(tolerance, tolerance.figures, zero, language, unit)
    amount = _write_amount_text(tolerance.absolute, unit)
    if tolerance.relative == 0:
        rule = _ABSOLUTE[language].format(amount=amount, table="" if unit else _IN_TABLE[language])
        return rule + write_decimals_rule(tolerance.absolute, language)
    aside = "" if unit else _IN_TABLE_ASIDE[language]
    absolute = _OR_ABSOLUTE[language].format(amount=amount, table=aside)
    also = absolute if tolerance.absolute else ""
    return _RELATIVE[language].format(
        relative=write_percent(tolerance.relative), absolute=also, zero=zero
    )


def write_decimals_rule(allowed: Fraction, language: Language) -> str:
    """How many decimals to write where an amount is allowed, whatever the size of the answer.

    Rounding to them takes at most half of what is allowed. Empty where nothing is allowed, as in a
    damaged key.

    >>> write_decimals_rule(Fraction(1, 500), "en"), write_decimals_rule(Fraction(2), "en")
    (' Write at least 3 decimals.', ' Write at least every digit before the decimal point.')
    """
    if allowed <= 0:
        return ""
    count = 0
    while Fraction(1, 10**count) > allowed:
        count += 1
    match count:
        case 0:
            decimals = _TO_THE_UNIT[language]
        case 1:
            decimals = _ONE_DECIMAL[language]
        case _:
            decimals = _DECIMALS[language].format(count=count)
    return _WRITE_DECIMALS[language].format(decimals=decimals)


def _write_figures_rule(
    tolerance: Tolerance, figures: int, zero: str, language: Language, unit: str = ""
) -> str:
    """The rule of significant figures, by an example: to 3 of them, 1.2304 allows 1.225 to
    1.235.
    """
    example = f"{'1.23456'[: figures + 1]}04"
    low, high = figures_interval(Fraction(example), figures)
    amounts = []
    if tolerance.relative:
        amounts.append(_OF_VALUE[language].format(relative=write_percent(tolerance.relative)))
    if tolerance.absolute:
        amount = _write_amount_text(tolerance.absolute, unit)
        table = "" if unit else _IN_TABLE[language]
        amounts.append(_IN_UNIT[language].format(amount=amount, table=table))
    others = _OR_WITHIN[language].format(amounts=_OR[language].join(amounts)) if amounts else ""
    return _FIGURES[language].format(
        figures=figures,
        example=example,
        low=write_plain(low),
        high=write_plain(high),
        others=others,
        zero=zero,
    )


def _write_amount_text(amount: Fraction, unit: str) -> str:
    r"""A tolerance as prose, with its unit where one is named: a pure number has none.

    >>> _write_amount_text(Fraction(1, 4), "m/s"), _write_amount_text(Fraction(1, 4), "deg")
    ('$0.25\\,\\unit{m/s}$', '$0.25^\\circ$')
    """
    match unit:
        case "" | "1":
            return write_plain(amount)
        case "deg":
            return rf"${write_plain(amount)}^\circ$"
        case _:
            return rf"${write_plain(amount)}\,\unit{{{unit}}}$"


def write_percent(share: Fraction) -> str:
    """A share in per cent.

    >>> write_percent(Fraction(1, 100))
    '1 %'
    """
    return f"{write_plain(share * 100)} %"


def write_plain(number: Fraction) -> str:
    """A decimal without trailing zeros or power of ten; tolerances have at most 13 digits.

    >>> write_plain(Fraction(1, 8)), write_plain(Fraction(1, 100000))
    ('0.125', '0.00001')
    """
    return f"{Decimal(f'{float(number):.15g}'):f}"
