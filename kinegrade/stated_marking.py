"""What a bank and a policy state about marking in the same words: tolerances, and credit for
answers that are not right.

    tolerance = { relative = "1 %", absolute = 0.01, figures = 3 }
    credit = { follow-through = "1/2", wrong-unit = "50 %", mistakes = { coriolis-halved = 0.5 } }
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction

from msgspec import Struct, field

from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import Read, amount, share
from kinegrade.language.message import Message, list_choices

TOLERANCE = (
    #: A share of the right answer: `"1 %"`, `0.01` or `"1/100"`.
    "relative",
    #: An amount in the unit of the ask.
    "absolute",
    #: A number of significant figures: right is what agrees with the exact value rounded to them.
    "figures",
)
CREDIT = (
    #: For an answer that follows from the student's own wrong answer to an earlier ask; all the
    #: points where it is not stated, none for `0`. Where nothing is charged for that earlier
    #: answer, as it is void or has all its points, all the points in any case.
    "follow-through",
    #: For the right number in a wrong unit of motion, `0.55 s` for 0.55 m; with a unit that is not
    #: known, as in `0.55 kg`, an answer is unreadable and has no credit.
    "wrong-unit",
    #: For known mistakes, by their identifiers: `{ coriolis-halved = "1/2" }`.
    "mistakes",
)
# What is shown where one of them is no table
_TOLERANCES = '{ relative = "1 %" }', "{ absolute = 0.01 }", "{ figures = 3 }"
HONEST = "honest"  # in place of a table, and the key of one
HONESTLY = '{ relative = "1 %", honest = true }'
_CREDIT = '{ follow-through = "1/2" }'
_MISTAKES = '{ coriolis-halved = "1/2" }'


class StatedTolerance(Struct, frozen=True):
    """A tolerance as stated; None for what is not stated. `relative` is a share, `absolute` in the
    ask's unit, `figures` a number of significant figures.
    """

    relative: Fraction | None = None
    absolute: Fraction | None = None
    figures: int | None = None

    def over(self, wider: StatedTolerance) -> StatedTolerance:
        """This, and where it states nothing what `wider` states."""
        return StatedTolerance(
            wider.relative if self.relative is None else self.relative,
            wider.absolute if self.absolute is None else self.absolute,
            wider.figures if self.figures is None else self.figures,
        )


class StatedCredit(Struct, frozen=True):
    """Shares of the points, from 0 to 1, as stated; None for what is not stated.

    `follow_through` is for what follows from an earlier mistake, `wrong_unit` for the right number
    in a wrong unit, `mistakes` for known mistakes by identifier.
    """

    follow_through: Fraction | None = None
    wrong_unit: Fraction | None = None
    mistakes: Mapping[str, Fraction] = field(default_factory=dict)

    def over(self, wider: StatedCredit) -> StatedCredit:
        """This, and where it states nothing what `wider` states."""
        return StatedCredit(
            wider.follow_through if self.follow_through is None else self.follow_through,
            wider.wrong_unit if self.wrong_unit is None else self.wrong_unit,
            {**wider.mistakes, **self.mistakes},
        )

    def record(self) -> dict[str, object]:
        """The credit as exam.json keeps it and `read_credit` reads it; empty if none is stated."""
        record: dict[str, object] = {}
        if self.follow_through is not None:
            record["follow-through"] = str(self.follow_through)
        if self.wrong_unit is not None:
            record["wrong-unit"] = str(self.wrong_unit)
        if self.mistakes:
            record["mistakes"] = {name: str(share) for name, share in self.mistakes.items()}
        return record


def read_tolerance(
    table: Table, figures: Read[int], further: tuple[str, ...] = ()
) -> StatedTolerance:
    """What `tolerance` in a table states; `further` keys may stand there, or in place of it."""
    like = list_choices((*_TOLERANCES, *(f'"{word}"' for word in further)))
    stated = table.table("tolerance", like).only(*TOLERANCE, *further)
    return StatedTolerance(
        stated.optional("relative", share),
        stated.optional("absolute", amount),
        stated.optional("figures", figures),
    )


def read_credit(table: Table, known_mistakes: Callable[[], Iterable[str]]) -> StatedCredit:
    """What `credit` in a table states; the known mistakes are asked for only where it names one."""
    stated = table.table("credit", _CREDIT).only(*CREDIT)
    mistakes = stated.table("mistakes", _MISTAKES)
    if mistakes:
        mistakes = mistakes.only(*known_mistakes(), unknown=Message("fields.unknown-mistake"))
    return StatedCredit(
        stated.optional("follow-through", share),
        stated.optional("wrong-unit", share),
        mistakes.entries(share),
    )


def join_label(identifier: str, given: str) -> str:
    """What tells mistakes of one identifier apart in a key: the identifier and what is misread."""
    return f"{identifier}.{given}" if given else identifier


def find_identifier(label: str) -> str:
    """The identifier of the mistake with this label.

    >>> find_identifier("supplementary-angle.phi")
    'supplementary-angle'
    """
    return label.partition(".")[0]
