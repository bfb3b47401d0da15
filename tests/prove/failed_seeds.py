"""Seeds at which a proof once failed, each with what it was; every `make test` tries them again."""

from __future__ import annotations

FAILED = {
    ("damaged files", 156): "report: a crash where read_as in marks.csv is no number",
    ("damaged files", 33124): "report: a crash where read_as in marks.csv is no number",
    ("damaged files", 250): "quiz: a crash where the tolerance of an ask is missing in the key",
    ("damaged files", 100279): "report: endless work on points of 1e9999999999 in marks.csv",
    ("damaged files", 200641372): "quiz: endless work on a tolerance of nothing in the key",
    ("damaged files", 200636443): "a workbook: a crash where packed bytes of a part are damaged",
    ("damaged files", 200636542): "a workbook: a crash where packed bytes of a part are damaged",
    ("damaged files", 159443907): "feedback: a crash where an exact answer is a number of JSON",
    ("damaged files", 888567026): "key: a crash where a given quantity has another name",
    ("damaged files", 700576): "quiz: a crash where the tolerance of an ask is missing in the key",
    ("printed figures", 666913698): "a letter at the beginning of an extension line",
    ("printed figures", 391559532): "the one pin that is a circle was taken for another point",
    ("printed figures", 391559534): "the one pin that is a circle was taken for another point",
    ("printed figures", 391559591): "a length between its crank and the arrow of a rotation",
    ("printed figures", 452640244): "a letter under the beginning of an extension line",
    ("printed figures", 391559609): "a length between its crank and the arrow of a rotation",
    ("printed mathematics", 411014085): "a coordinate was left out of which the square is used",
    ("printed mathematics", 181832623): "the reader took a Chinese semicolon for part of a unit",
    ("printed mathematics", 181832629): "-9.01 was no value of -9.013: the last digit is rounded",
    (
        "printed mathematics",
        181832525,
    ): "the reader saw no head of the arrow by which a symbol stood",
    (
        "printed mathematics",
        181832620,
    ): "the reader saw no head of the arrow by which a symbol stood",
    ("printed mathematics", 181832719): "the reader took an outline for a line through its middle",
    (
        "printed mathematics",
        181832662,
    ): "a polygon tore the two parts of one vector apart, and a letter had no corner",
    ("tactile sheets", 80): "scotch-yoke-driven-by-guide: a slot ran into the number of the sheet",
    ("described figures", 907070209): "an answer that equals a given by chance was taken as told",
    ("described figures", 907070514): "an answer that equals a given by chance was taken as told",
    (
        "solution pages",
        616978356,
    ): "bar-pushing-rolling-disc: a line on a third page, set with room",
    ("described figures", 460213439): "a right angle of 270 degrees was no number of the statement",
    ("printed mathematics", 66709691): "the reader took the words between two formulas for one",
    ("tactile sheets", 16): "pose-four-bar-coupler: labels of axes took the room of a letter",
    ("typed texts", 254360791): "a page multiplied what a raised dot stands between: 1∙1",
    (
        "typed texts",
        745403411,
    ): "a page took 1/Ⅳ behind a number for another number, not for a unit",
    ("typed texts", 745403413): "a page took (0010)^69, which is 10^69, for too high a power",
    (
        "unlike figures",
        145272829,
    ): "slotted-link-on-cylinder: the figure refused two of its four angles in every paper",
    ("typed texts", 2): "2π*0/5 was read as 2, its first number",
    ("described pictures", 54839449): "numbers of names, as of ring 1, were taken for answers",
}
