"""How a number is typed, system by system: what each of them reads differently from what a paper
allows.

Tested in the systems themselves. Moodle: a comma, a superscript, a typographic minus or a
full-width digit earns nothing, a unit is ignored; the decimal point is right in all its languages.
Canvas reads numbers in the user's locale, in which 1.293 may be 1293, keeps four decimals, and
shows no unit beside its box.
"""

from __future__ import annotations

from collections.abc import Mapping

from kinegrade.exam.quiz_document import QuizQuestion
from kinegrade.exam.quiz_words import BETWEEN
from kinegrade.exam.rules import FEWEST_DIGITS, NUMERALS
from kinegrade.language import Language

Typing = Mapping[str, str]  # `{}` takes the number of significant digits

MOODLE: Typing = {
    "en": "Type one number into each box, in the stated unit and with at least {} significant "
    "digits. Use digits, a decimal point and a plain minus sign only, like -0.8660 or 1.25e-3: "
    "no comma, no unit, no superscripts, no other minus sign.",
    "zh": "每个输入框只填一个数，单位以题中所示为准，至少保留{}位有效数字。只用半角的数字、小数点和减号，如 -0.8660 或 "
    "1.25e-3：不要用逗号，不要写单位，不要用上标，不要用其他减号。",
}
CANVAS: Typing = {
    "en": "Type the number with four decimals, in the stated unit and without writing the unit, "
    "like -0.8660 or 12.3400. Where your Canvas shows decimals with a comma, type a comma: "
    "12,3400. Never type exactly three decimals: 1.234 or 1,234 may be taken for 1234. No "
    "powers of ten, no separators of thousands.",
    "zh": "填写一个数，保留四位小数，单位以题中所示为准，不要写单位，如 -0.8660 或 12.3400。若你的 Canvas 以逗号作小数点，"
    "请用逗号：12,3400。切勿恰好写三位小数：1.234 或 1,234 可能被当作 1234。不要用科学计数法，不要用千位分隔符。",
}
QTI21: Typing = {
    "en": "Type one number into each box, with a decimal point, in the stated unit and without "
    "writing the unit, with at least {} significant digits: -0.8660 or 1.25e-3.",
    "zh": "每个输入框只填一个数，单位以题中所示为准，不要写单位，小数点用半角句点，至少保留{}位有效数字，如 -0.8660 或 1.25e-3。",
}
BLACKBOARD: Typing = {
    "en": "Type the number with a decimal point, in the stated unit and without writing the unit, "
    "with at least {} significant digits: -0.8660. No powers of ten.",
    "zh": "填写一个数，单位以题中所示为准，不要写单位，小数点用半角句点，至少保留{}位有效数字，如 -0.8660。不要用科学计数法。",
}


def write_rules(question: QuizQuestion, typing: Typing, language: Language) -> str:
    """How to type the answers of a question, and when one is right: prose."""
    numerals = NUMERALS[language][question.digits - FEWEST_DIGITS :]
    shown = typing[language].format(numerals[0] if numerals else question.digits)
    return BETWEEN[language].join(filter(None, (shown, question.rule)))
