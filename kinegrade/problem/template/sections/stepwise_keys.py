"""What an author may write of a question that has steps in place of a mechanism.

The comments that begin with `#:` say what each key is for; the reference of docs/ prints them.
"""

from __future__ import annotations

STEPWISE = (
    #: The whole question in Markdown and `$LaTeX$`, or one for each language. Every parameter
    #: stands in it as `{{ name }}`, which prints symbol, value and unit; `{{ name.value }}` prints
    #: the value with its unit.
    "statement",
    #: The givens, by name: `parameters.t = { unit = "s", draw = [4, 5, 6] }`.
    "parameters",
    #: What follows from the givens, by name, in order: `steps.v = "a*t"`. An expression may name
    #: givens, steps before it, and `pi`, and is in SI, whatever the units of the givens.
    "steps",
    #: What is asked: steps by name, each with its unit and points.
    "asks",
    #: What stands beside its number: a text, or one for each language.
    "title",
    #: Mistakes that you know, by identifiers of your own: credit is set and marks are explained by
    #: them, and draws at which one of them leads to a right answer are refused.
    "mistakes",
    #: What drawn values must fulfil: two expressions of givens with `<`, `<=`, `>`, `>=` or `==`
    #: between them.
    "conditions",
)
STEPWISE_PARAMETER = (
    #: The unit in which it is given.
    "unit",
    #: The values that may be drawn: a list, `[15, 30, "sqrt(3)"]`, or a range, `"0.1 .. 0.5 step
    #: 0.05"`.
    "draw",
    #: The symbol in LaTeX math, where it does not follow from the name.
    "symbol",
)
STEPWISE_ASK = (
    #: The unit of the answer.
    "unit",
    #: What it is, in a few words, beside its box on the paper.
    "means",
    #: What a positive answer means: a keyword, or words of your own by language. Where nothing is
    #: said, the answer is never negative.
    "sign",
    #: Whether an angle is right with up to three full turns more or less, `true` or `false`; where
    #: nothing is said it is if the step is `atan2(y, x)` or a sum with it.
    "cyclic",
    #: The symbol in LaTeX math, where it does not follow from the name of the step.
    "symbol",
)
STEPWISE_MISTAKE = (
    #: The steps that are mistaken, each with what it is taken for: `steps.s = "v*t"`.
    "steps",
    #: What is told to the student who makes it, in a sentence.
    "means",
)
