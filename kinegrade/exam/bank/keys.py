"""What an instructor may write in a bank's file: its keys, and those of its entries.

The comments that begin with `#:` say what each key is for; the reference of docs/ prints them.
"""

from __future__ import annotations

BANK = (
    #: What the exam is called: a text, or one for each language.
    "title",
    #: The course, in the same way.
    "course",
    #: The date, as it is printed: `2026-06-24`, or any text.
    "date",
    #: What is set: `"exam"`, where nothing is stated, or `"homework"`.
    "kind",
    #: The number of the sheet in a series, which `kinegrade series` writes here: the title becomes
    #: `Homework 3: ...` in every language.
    "sheet",
    #: When it is due, as it is printed: `2026-12-01T18:00:00`, or `"2026-12-01 18:00"`; with the
    #: difference from UTC, `"2026-12-01 18:00 +01:00"`, where answers come from a system that
    #: states it.
    "due",
    #: What else stands at the head of the papers: a table `[header]`.
    "header",
    #: How far an answer may be off; `"honest"` where nothing is stated.
    "tolerance",
    #: How many significant figures students are asked to carry in every value that they write down:
    #: 3 to 6, and 4 where nothing is stated. It is printed on the papers, and draws are refused at
    #: which work that carries so many could leave the tolerance.
    "carry",
    #: `true` gives every paper its own order of the questions, all papers of a version the same;
    #: questions that are marked by hand keep the number of their place in the bank.
    "shuffle",
    #: The room for working that is left between the statement of every question and its answers,
    #: `"6 cm"`, at least; what is left of a page is shared out among its questions besides.
    "space",
    #: The number of versions, `3` for A, B and C, in place of a paper for each student.
    "versions",
    #: What is bound behind every paper: a PDF of at most 10 pages and 5 MB beside the bank,
    #: `"formulas.pdf"`, or a text (`.md`, `.txt`) with bold, emphasis, lists and `$...$` formulas.
    #: The exam folder keeps it.
    "formula-sheet",
    #: What typesets the exam.
    "engine",
    #: Shares of the points for answers that are not right.
    "credit",
    #: Which grades totals earn: a table `[scale]`.
    "scale",
    #: `true` if feedback is to hold the worked solutions.
    "solutions",
    #: `true` ends all worked solutions with small graphs of their answers over the whole cycle, on
    #: which a dot marks the instant of the question.
    "cycle",
    #: The system that will mark typed answers, where it takes only some numbers: draws whose right
    #: answers it could not take are refused.
    "lms",
    #: The questions, each a table `[[questions]]`.
    "questions",
)
# The table [header]; its texts are texts, or one for each language
HEADER = (
    #: Who sets the exam: `"Department of Mechanics"`.
    "institution",
    #: A PNG, SVG or PDF file beside the bank, at most 500 kB: `"crest.svg"`. The exam folder keeps
    #: it.
    "logo",
    #: How long students have: `"120 minutes"`.
    "duration",
    #: What students may use: `"one sheet of notes, pocket calculator"`.
    "aids",
    #: What students are told before they begin.
    "instructions",
    #: `true` for a line on which students write the room; or a text that is printed there.
    "room",
    #: `true` for a line on which students write their seat; or a text.
    "seat",
    #: `true` for a line on which students sign.
    "signature",
)
# An entry [[questions]] names a template, or a family or tag to draw from
NAMED = (
    #: A shipped template by its name, or a file beside the bank: `"mine.toml"`.
    "template",
    #: What is asked, with points: `{ v_B = 3, omega_AB = 2 }`; for one kind alone, `"velocity"`,
    #: `"acceleration"` or `"position"`. What the template gives points is asked otherwise.
    "asks",
    #: Other values to draw for some parameters: `{ k = ["sqrt(3)", "2"] }`; a single one is
    #: the same on all papers: `{ k = 2 }`.
    "draw",
    #: The points of the question, shared out as the template weighs what it asks.
    "points",
    #: How far an answer to this question may be off.
    "tolerance",
    #: The room for working at this question, in place of the bank's.
    "space",
)
# How the numbers of any entry are dealt
DEALT = (
    #: `true` gives everybody the same numbers, in all versions.
    "same",
    #: `true` allows that some have the same numbers, where fewer combinations are fit than there
    #: are students; how many share theirs is said. Otherwise that is a complaint.
    "repeats",
)
# How the points of any entry count
COUNTED = (
    #: `true` makes it a bonus: its points come on top of the maximum.
    "bonus",
)
TEXT = (
    #: The text of a question without a mechanism, whose answer is marked by hand: Markdown with
    #: `$...$` LaTeX math, or one for each language.
    "text",
)
# An entry with `steps` is a question of the bank's own; the template's tables stand in it, too
OWN = (
    #: What the question is called in files, reports and messages, as a template is by its file:
    #: `"car-from-rest"`.
    "name",
    #: How far an answer to this question may be off.
    "tolerance",
    #: The room for working at this question, in place of the bank's.
    "space",
)
OWN_ASK = (
    #: The points of the ask.
    "points",
    #: How far the answer may be off.
    "tolerance",
)
BY_HAND = (
    #: What stands beside its number: a text, or one for each language.
    "title",
    #: Its points.
    "points",
    #: The room that students have for their answer, in place of the bank's.
    "space",
)
ANY = (
    #: Templates, of which each student gets one: `["slider-crank", "mine.toml"]`, shipped ones or
    #: files beside the bank, 2 to 26. All carry the same points.
    "any",
    #: The kind of asks: `"velocity"`, `"acceleration"` or `"position"`; all where it is not stated.
    "asks",
    #: The points of the question, shared out as each template weighs what it asks.
    "points",
    #: How far an answer to this question may be off.
    "tolerance",
    #: The room for working at this question, in place of the bank's.
    "space",
)
FAMILY = (
    #: Draws from the shipped templates of this family, once for the class.
    "family",
)
TAG = (
    #: Draws from the shipped templates with this tag, once for the class.
    "tag",
)
DRAWN = (
    #: How many different templates are drawn; one where it is not stated.
    "number",
    #: `true` draws for each student; then all templates carry the same points, and are 26 at most.
    "per-student",
    #: Templates that are not to be drawn: `["slider-crank"]`.
    "without",
    #: The kind of asks: `"velocity"`, `"acceleration"` or `"position"`; all where it is not stated.
    "asks",
    #: The points of each question, shared out as its template weighs what it asks.
    "points",
    #: How far an answer to these questions may be off.
    "tolerance",
    #: The room for working at each of them, in place of the bank's.
    "space",
)
# What a tolerance may state besides what policies may
TOLERANCE = (
    #: `true` widens the relative tolerance of an ask on each paper, where honest rounding takes
    #: more at that paper's numbers, to the next of 1, 1.5, 2, 3, 4, 5, 6, 8 and 10 %; the answer
    #: table of the paper states it in the row of the ask. `tolerance = "honest"` is
    #: `{ relative = "1 %", honest = true }`.
    "honest",
)
# An entry of `asks` that is a table
ASK = (
    #: The points of the ask; the template's where they are not stated.
    "points",
    #: How far the answer may be off.
    "tolerance",
)
