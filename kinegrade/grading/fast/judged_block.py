"""The decisions on all answers of some rows, side by side: what `block_judge` fills in.

`marks` adds up the points, `answer_lines` writes them. They hold arrays rather than an object for
each answer, because a large class gives a million answers.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import get_args

import numpy as np
from numpy.typing import NDArray

from kinegrade.grading.fast.bounds import Flags, Numbers, Places
from kinegrade.grading.fast.comparison import Comparison
from kinegrade.grading.fast.mistaken import Leading
from kinegrade.grading.fast.reasons import Sentence, read_reasons
from kinegrade.grading.fast.typed_cells import TypedCells
from kinegrade.grading.judging.decision import Decision
from kinegrade.grading.judging.judge import Kind, Verdict
from kinegrade.grading.sheets.rows import Rows
from kinegrade.language import Language
from kinegrade.language.message import Text

NO_SHARE, FULL_SHARE = 0, 1  # indices into `JudgedBlock.credits`
USUAL_CREDITS = 2  # the length of `credits` if every answer has all or nothing
KINDS: tuple[Kind, ...] = get_args(Kind)
_NUMBERS = {kind: number for number, kind in enumerate(KINDS)}


@dataclass(frozen=True, slots=True)
class JudgedBlock:
    """All answers of some rows, row after row: the kinds of the verdicts, as indices into `KINDS`,
    and the shares of the points, as indices into `credits`, which holds the few distinct ones.

    Most reasons are one of few `sentences` of the `language`, whose number is `said` of the answer,
    filled in with the numbers that are `stated` of it, and worded otherwise where an answer is
    right `to_figures`. Where none is said, which is 0, `reasons` are those that are not empty, and
    `mistakes` those that lead to the answer. `by_policy` is where the rule was not the paper's.
    `worded` are reasons that have been put in words already; `accepted` are the numbers of the
    policy's answers that answers of this kind agree with, `rests_on` the asks from whose answers
    one follows.
    """

    rows: Rows
    cells: TypedCells
    comparison: Comparison
    language: Language
    kinds: NDArray[np.uint8]
    shares: NDArray[np.intp]
    said: Places
    stated: Numbers
    to_figures: Flags
    by_policy: Flags
    sentences: list[Sentence] = field(default_factory=lambda: [Sentence()])
    numbers: dict[Sentence, int] = field(default_factory=dict)
    reasons: dict[int, Text] = field(default_factory=dict)
    credits: list[Fraction] = field(default_factory=lambda: [Fraction(0), Fraction(1)])
    mistakes: dict[int, tuple[str, ...]] = field(default_factory=dict)
    worded: dict[int, str] = field(default_factory=dict)
    accepted: dict[int, int] = field(default_factory=dict)
    rests_on: dict[int, tuple[str, ...]] = field(default_factory=dict)

    @classmethod
    def begin(
        cls, rows: Rows, cells: TypedCells, comparison: Comparison, language: Language
    ) -> JudgedBlock:
        """A block in which every answer is blank."""
        count = len(cells.typed)
        blank = np.full(count, _NUMBERS["blank"], dtype=np.uint8)
        shares = np.full(count, NO_SHARE, dtype=np.intp)
        said, by_policy = np.zeros(count, dtype=np.intp), np.zeros(count, dtype=np.bool_)
        stated, to_figures = comparison.stated, comparison.bounds.to_figures.copy()
        return cls(
            *(rows, cells, comparison, language, blank, shares),
            *(said, stated, to_figures, by_policy),
        )

    def kind(self, place: int) -> Kind:
        """The kind of the verdict on an answer."""
        return KINDS[int(self.kinds[place])]

    def are(self, *kinds: Kind) -> Flags:
        """Where the verdict is of one of these kinds."""
        wanted = np.zeros(len(KINDS), dtype=np.bool_)
        wanted[[_NUMBERS[kind] for kind in kinds]] = True
        found: Flags = wanted[self.kinds]
        return found

    def put(self, place: int, decision: Decision) -> None:
        """Sets the decision on an answer."""
        verdict, share = decision
        self.kinds[place] = _NUMBERS[verdict.kind]
        self.said[place] = 0
        self.by_policy[place] = verdict.by_policy
        self.reasons[place] = verdict.reason
        self.mistakes[place] = verdict.mistakes
        if verdict.accepted:
            self.accepted[place] = verdict.accepted
        if verdict.rests_on:
            self.rests_on[place] = verdict.rests_on
        self.put_share(place, share)

    def put_unread(self, verdicts: Mapping[int, Verdict]) -> None:
        """Sets the verdicts on answers that are no numbers, which get no points."""
        places = [*verdicts]
        self.kinds[places] = [_NUMBERS[each.kind] for each in verdicts.values()]
        self.shares[places], self.said[places], self.by_policy[places] = NO_SHARE, 0, False
        self.reasons.update({place: each.reason for place, each in verdicts.items()})
        self.mistakes.update({place: each.mistakes for place, each in verdicts.items()})

    def put_mistakes(self, leading: Leading, ways: Places, said: Places) -> None:
        """Sets the answers to which these ways lead, without points; the numbers of the sentences
        are those that `find_sentence` gives.
        """
        chosen = leading.places[ways]
        self.kinds[chosen] = _NUMBERS["mistake"]
        self.shares[chosen] = NO_SHARE
        self.by_policy[chosen] = False
        self.said[chosen] = said
        self.stated[:, chosen] = leading.stated[:, ways]
        self.to_figures[chosen] = leading.to_figures[ways]

    def put_compared(self, places: Places, by_policy: Flags) -> None:
        """Sets answers that are certainly right or wrong by the key, or by the policy's rule."""
        right = self.comparison.right[places]
        self.kinds[places] = np.where(right, _NUMBERS["right"], _NUMBERS["wrong"])
        self.shares[places] = np.where(right, FULL_SHARE, NO_SHARE)
        self.by_policy[places] = by_policy
        by_rule = [self.find_sentence(Sentence(by_policy=rule)) for rule in (False, True)]
        self.said[places] = np.where(by_policy, by_rule[True], by_rule[False])

    def put_share(self, place: int, share: Fraction) -> None:
        """Sets the share of the points of an answer."""
        if not share:
            self.shares[place] = NO_SHARE
            return
        if share not in self.credits:
            self.credits.append(share)
        self.shares[place] = self.credits.index(share)

    def find_sentence(self, sentence: Sentence) -> int:
        """The number of a sentence, which may be said from then on."""
        if sentence not in self.numbers:
            self.numbers[sentence] = len(self.sentences)
            self.sentences.append(sentence)
        return self.numbers[sentence]

    def word(self, places: Places) -> None:
        """Puts the reasons at these places in words, all at once: one by one takes longer."""
        ways = 2 * self.said[places] + self.to_figures[places]
        for way in np.flatnonzero(np.bincount(ways)).tolist():
            said, to_figures = divmod(way, 2)
            if said:
                chosen = places[ways == way]
                forms = read_reasons(self.language, self.sentences[said])
                reasons = forms.choose(to_figures=bool(to_figures)).fill(self.stated[:, chosen])
                self.worded.update(zip(chosen.tolist(), reasons, strict=True))

    def reason(self, place: int) -> Text:
        """Why an answer is what it is."""
        if not self.said[place]:
            return self.reasons.get(place, "")
        if place not in self.worded:
            self.word(np.array([place]))
        return self.worded[place]

    def find_mistakes(self, place: int) -> tuple[str, ...]:
        """The mistakes that lead to an answer."""
        said = self.said[place]
        return self.sentences[said].mistakes if said else self.mistakes.get(place, ())

    def decision(self, place: int) -> Decision:
        """The decision on an answer."""
        verdict = Verdict(
            self.kind(place),
            self.reason(place),
            mistakes=self.find_mistakes(place),
            by_policy=bool(self.by_policy[place]),
            accepted=self.accepted.get(place, 0),
            rests_on=self.rests_on.get(place, ()),
        )
        return verdict, self.credits[self.shares[place]]
