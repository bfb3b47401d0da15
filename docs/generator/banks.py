"""The pages about the files of an instructor: banks and policies."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from docs.generator.described import read_words
from docs.generator.markdown import write_code, write_page, write_table, write_words
from kinegrade.exam.bank.bank import read_bank
from kinegrade.exam.bank.blueprint import Bank
from kinegrade.language import ENGLISH
from kinegrade.press.protocol import ENGINES
from kinegrade.problem.template.library.library import find_shipped, list_names

_BANK = "kinegrade.exam.bank.keys"
_STEPWISE = "kinegrade.problem.template.sections.stepwise_keys"
_POLICY = "kinegrade.grading.policy.keys"
_STATED = "kinegrade.stated_marking"
_LATENESS = "kinegrade.grading.lateness.reading"
_PLAN = "kinegrade.reports.term.plan"
_SCALE = "kinegrade.grade_scale.stated"
_BANK_EXAMPLE = """```toml
title = { en = "Kinematics midterm", zh = "运动学期中测验" }
course = "Theoretical mechanics"
tolerance = { relative = "1 %" }
carry = 4
shuffle = true
credit = { follow-through = "1/2" }

[[questions]]
template = "slider-crank"
asks = { v_B = 3, omega_AB = 2 }
draw = { k = ["sqrt(3)", "2"] }
tolerance = { relative = "2 %" }

[[questions]]
family = "rolling"
number = 2
without = ["rolling-wheel-rim-points"]
asks = "velocity"
points = 10
```"""
_POLICY_EXAMPLE = """```toml
attempts = "best"
tolerance = { relative = "2 %" }
credit = { follow-through = "1/2", wrong-unit = "50 %", mistakes = { sense-reversed = 0.5 } }

[questions.q1]
void = "drop"

[questions.q2.asks.v_B]
tolerance = { figures = 2 }
points = 3
accept = [
  { value = "2*sqrt(3)", unit = "m/s" },
  { value = "-v_B", student = ["007", "0012"] },
]
```"""
_PLAN_EXAMPLE = """```toml
[parts.homework]
marks = ["HW1", "HW2", "HW3", "HW4", "HW5", "HW6"]
best = 5
weight = "30 %"

[parts.FINAL]
weight = "70 %"

[scale]
kind = "german"
```"""


def write_bank_page() -> str:
    """What may be written in a bank, and the banks that are shipped."""
    return write_page(
        "# Banks",
        "A bank is a TOML file: the blueprint of an exam. Where `generate` takes BANK, the name of "
        "a shipped bank will do.",
        _BANK_EXAMPLE,
        write_words("key", read_words(_BANK, "BANK")),
        f"Engines: {', '.join(map(write_code, ENGINES))}. Translations of `title` and `course` may "
        "also stand in a file beside the bank: `midterm.zh.toml` beside `midterm.toml`.",
        *_list_entries(),
        *_stated(read_words(_BANK, "TOLERANCE")),
        "## Shipped banks",
        _write_shipped_banks(),
    )


def _list_entries() -> tuple[str, ...]:
    """What an entry of a bank may be, kind by kind."""
    return (
        "## Questions",
        "An entry `[[questions]]` names a template:",
        write_words("key", read_words(_BANK, "NAMED")),
        "or several, of which each student gets one:",
        write_words("key", read_words(_BANK, "ANY")),
        "or a family or a tag to draw from:",
        write_words(
            "key",
            {
                **read_words(_BANK, "FAMILY"),
                **read_words(_BANK, "TAG"),
                **read_words(_BANK, "DRAWN"),
            },
        ),
        "How the numbers of any of them are dealt:",
        write_words("key", read_words(_BANK, "DEALT")),
        "How the points of any entry count, one with a text as well:",
        write_words("key", read_words(_BANK, "COUNTED")),
        "An entry may also be a text, whose answers are marked by hand:",
        write_words("key", {**read_words(_BANK, "TEXT"), **read_words(_BANK, "BY_HAND")}),
        "An entry may also have steps in place of a mechanism:",
        write_words("key", {**read_words(_BANK, "OWN"), **read_words(_STEPWISE, "STEPWISE")}),
        "There each given has",
        write_words("key", read_words(_STEPWISE, "STEPWISE_PARAMETER")),
        "each ask",
        write_words(
            "key", {**read_words(_STEPWISE, "STEPWISE_ASK"), **read_words(_BANK, "OWN_ASK")}
        ),
        "and each mistake",
        write_words("key", read_words(_STEPWISE, "STEPWISE_MISTAKE")),
        "In `asks` of the other entries, an ask is followed by its points, or by a table:",
        write_words("key", read_words(_BANK, "ASK")),
    )


def write_policy_page() -> str:
    """What may be written in a policy."""
    return write_page(
        "# Policies",
        "A policy is a TOML file that `kinegrade grade --policy` marks by, in place of what the "
        "papers say. A setting nearer to the ask overrides one further out, number by number; the "
        "bank's own `credit` is furthest out. Of everything that applies to an answer, the best "
        "credit counts.",
        _POLICY_EXAMPLE,
        write_words("key", read_words(_POLICY, "POLICY")),
        "## Questions",
        "In a table `[questions.q1]`:",
        write_words("key", read_words(_POLICY, "QUESTION")),
        "For a question that is marked by hand:",
        write_words("key", read_words(_POLICY, "QUESTION_BY_HAND")),
        "## Asks",
        "In a table `[questions.q1.asks.v_B]`:",
        write_words("key", read_words(_POLICY, "ASK")),
        "## Accepted answers",
        "In each entry of `accept`:",
        write_words("key", read_words(_POLICY, "ACCEPTED")),
        "## Lateness",
        "In a table `[late]`; what is subtracted is never more than the points that were reached:",
        write_words("key", read_words(_LATENESS, "LATE")),
        "## Tries",
        "In a table `[tries]`:",
        write_words("key", read_words(_LATENESS, "TRIES")),
        *_stated({}),
    )


def write_plan_page() -> str:
    """What may be written in the plan of a term."""
    return write_page(
        "# Plans of a term",
        "The plan of a term is a TOML file that `kinegrade term --plan` puts exams together by.",
        _PLAN_EXAMPLE,
        write_words("key", read_words(_PLAN, "PLAN")),
        "## Parts",
        "In a table `[parts.homework]`:",
        write_words("key", read_words(_PLAN, "PART")),
        "## Scale",
        write_words("key", read_words(_SCALE, "SCALE")),
    )


def _stated(further: Mapping[str, str]) -> Iterator[str]:
    """Tolerances, with what else one of the two may state, and credit, which banks and policies
    state alike.
    """
    yield "## Tolerance"
    yield "The bounds are included. Where several are stated, the one that allows most holds."
    yield write_words("key", {**read_words(_STATED, "TOLERANCE"), **further})
    yield "## Credit"
    yield 'Each is a share of the points: `"1/2"`, `"50 %"` or `0.5`.'
    yield write_words("key", read_words(_STATED, "CREDIT"))
    yield "The identifiers of mistakes are listed under [Known mistakes](mistakes.md)."
    yield "## Scale"
    yield "Which grades totals earn: a table `[scale]`. Bounds are included."
    yield write_words("key", read_words(_SCALE, "SCALE"))


def _write_shipped_banks() -> str:
    folder = find_shipped("banks")
    banks = {name: read_bank(folder / f"{name}.toml", "sample") for name in list_names(folder)}
    return write_table(
        ("bank", "title", "questions", "points"),
        [
            (
                write_code(name),
                bank.title.in_language(ENGLISH),
                str(len(bank.questions)),
                str(_count_points(bank)),
            )
            for name, bank in banks.items()
        ],
    )


def _count_points(bank: Bank) -> object:
    return sum(ask.points for question in bank.questions for ask in question.asks)
