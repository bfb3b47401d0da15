"""All proofs: how much of each `make prove` and `make test` run.

In full they take many hours. `make prove` takes one: each proof has shares of what is left of it by
its weight, and tries as many of its cases as that allows, from a seed that is new every time. Those
of which no case is like another have most: some twenty minutes of a core for "whole tests", five
for the next. "fair marks" looks at 160 papers of every template; `make fairness` at 1,000.
"""

from __future__ import annotations

from kinegrade.problem.template.library.library import find_template_names
from tests.by_hand.class_list import TAUGHT
from tests.prove import (
    accessible_pages,
    by_hand,
    clear_figures,
    damaged_files,
    dealt_values,
    described_figures,
    described_pictures,
    fair_marks,
    graded_figures,
    independent_positions,
    practice_access,
    practice_sheets,
    printed_figures,
    printed_mathematics,
    printed_pages,
    properties,
    resumed_papers,
    round_trips,
    solution_pages,
    sound_templates,
    sufficient_descriptions,
    tactile_sheets,
    unlike_figures,
    whole_papers,
    whole_tests,
)
from tests.prove.proof import Proof

EACH = len(find_template_names())  # so many seeds that follow each other fall on each template once

PROOFS = (
    Proof("damaged files", damaged_files.hold, cases=10_000, batch=100, sample=82),
    Proof("properties", properties.hold, cases=264, batch=1, sample=0),
    Proof(
        "whole tests", whole_tests.hold, cases=len(whole_tests.cases()), batch=1, sample=0, weight=8
    ),
    Proof("independent positions", independent_positions.hold, cases=5_000, batch=50, sample=25),
    Proof("sound templates", sound_templates.hold, cases=200, batch=10, sample=0),
    Proof("dealt values", dealt_values.hold, cases=EACH, batch=6, sample=1),
    Proof("clear figures", clear_figures.hold, cases=2_000, batch=100, sample=4),
    Proof("described figures", described_figures.hold, cases=20 * EACH, batch=51, sample=9),
    Proof(
        "sufficient descriptions",
        sufficient_descriptions.hold,
        cases=20 * EACH,
        batch=51,
        sample=0,
    ),
    Proof("described pictures", described_pictures.hold, cases=EACH, batch=4, sample=2),
    Proof("tactile sheets", tactile_sheets.hold, cases=5 * EACH, batch=31, sample=2),
    Proof("printed figures", printed_figures.hold, cases=1_020, batch=51, sample=9),
    Proof("printed mathematics", printed_mathematics.hold, cases=1_020, batch=51, sample=5),
    Proof("solution pages", solution_pages.hold, cases=510, batch=51, sample=0),
    Proof("short solutions", solution_pages.hold_short, cases=2, batch=1, sample=0),
    Proof("graded figures", graded_figures.hold, cases=51, batch=51, sample=0),
    Proof("unlike figures", unlike_figures.hold, cases=EACH, batch=6, sample=0),
    Proof("round trips", round_trips.hold, cases=500, batch=25, sample=1),
    Proof("by hand", by_hand.hold, cases=len(TAUGHT), batch=1, sample=0, weight=4),
    Proof("whole papers", whole_papers.hold, cases=10, batch=1, sample=0, weight=3),
    Proof("resumed papers", resumed_papers.hold, cases=1, batch=1, sample=0, weight=3),
    Proof("printed pages", printed_pages.hold, cases=32, batch=1, sample=0, weight=2),
    Proof("practice sheets", practice_sheets.hold, cases=EACH, batch=6, sample=0, weight=2),
    Proof("typed texts", practice_sheets.hold_texts, cases=200, batch=25, sample=1),
    Proof("practice sheet size", practice_sheets.hold_size, cases=1, batch=1, sample=0),
    Proof("practice access", practice_access.hold, cases=EACH, batch=8, sample=0),
    Proof("accessible pages", accessible_pages.hold, cases=20 * EACH, batch=51, sample=2),
    Proof("fair marks", fair_marks.hold, cases=400, batch=20, sample=1),
)
