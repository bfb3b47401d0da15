"""The fixed words of feedback sheets, one table per language; `{}` takes a number or a text."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

FULL = "void, full points"  # in `explained`: for a void ask that still gives its points


@dataclass(frozen=True)
class FeedbackWords:
    """What a feedback sheet tells a student besides the exam's own texts; hints are prose with
    `$...$` math.
    """

    language: str  # as HTML names it
    feedback: str
    name: str
    student: str
    paper: str
    question: str  # takes the number on the paper
    question_known: str  # takes the number, and that in the answer sheet if different
    asked: str
    yours: str
    read_as: str  # takes the number that was read
    right: str
    verdict: str
    points: str
    total: str
    kept: str
    none: str  # in place of an answer
    about_hints: str
    solution: str
    page: str  # takes the page's number and the number of pages
    verdicts: Mapping[str, str]
    explained: Mapping[str, str]  # by verdict, where the verdict alone needs explaining
    # Whether the note made on reading a cell, which is English, suits this language
    reasons_are_shown: bool
    or_else: str  # between sentences on mistakes, any of which may have been made
    hints: Mapping[str, str]
    turned: str  # after a hint, where the sign is opposite as well
    too_large: str  # takes the factor, 10 or 1,000
    too_small: str
    close: str  # takes the difference and the tolerance, in per cent or in the words of the next
    by_policy: str
    other_ask: str  # takes the symbol


_ENGLISH = FeedbackWords(
    language="en",
    feedback="Feedback",
    name="Name",
    student="Student",
    paper="Paper",
    question="Question {}",
    question_known="Question {} (no. {} in the answer sheet)",
    asked="Asked for",
    yours="Your answer",
    read_as="read as {}",
    right="Right answer",
    verdict="Verdict",
    points="Points",
    total="Total",
    kept="The total is that of an earlier marking: it stands because it was higher.",
    none="none",
    about_hints="A remark that says “perhaps” was guessed from the number alone; compare it with "
    "your own working.",
    solution="Worked solution",
    page="page {} of {}",
    verdicts={
        "right": "right",
        "accepted": "accepted",
        "follow-through": "follows",
        "mistake": "wrong",
        "wrong": "wrong",
        "wrong unit": "wrong unit",
        "blank": "no answer",
        "unreadable": "not readable",
        "void": "not marked",
    },
    explained={
        "wrong unit": "The unit belongs to another kind of quantity.",
        "unreadable": "This could not be read as one number.",
        "accepted": "This answer was accepted as well.",
        "follow-through": "This follows from your own answer to an earlier part, which was wrong.",
        "void": "This was taken out of the marking.",
        FULL: "This was not marked: everybody who handed in gets the points.",
    },
    reasons_are_shown=True,
    or_else=" Or: ",
    hints={
        "opposite": "The size is right, the sign is opposite: perhaps the sense was reversed, or "
        "the sign convention overlooked.",
        "twice": "This is twice the right value: perhaps a factor 2 too many, or a diameter for a "
        "radius.",
        "half": "This is half the right value: perhaps a factor 2 was forgotten, or a radius taken "
        "for a diameter.",
        "degrees for "
        "radians": "This is the right value times 180/π: perhaps degrees were used in place of "
        "radians.",
        "radians for "
        "degrees": "This is the right value times π/180: perhaps radians were used in place of "
        "degrees.",
        "revolutions per "
        "minute": "This is the right value in revolutions per minute: perhaps it was not "
        "converted.",
        "revolutions per "
        "second": "This is the right value in revolutions per second: perhaps it was not "
        "converted.",
    },
    turned="The sign is opposite as well.",
    too_large="This is the right value times {}: perhaps the decimal point slipped, or a unit was "
    "not converted.",
    too_small="This is the right value divided by {}: perhaps the decimal point slipped, or a unit "
    "was not converted.",
    close="Close: off by {} where {} is allowed; perhaps an intermediate value was rounded too "
    "early.",
    by_policy="less",
    other_ask="This is the right value of ${}$: perhaps it went into the wrong box.",
)

_CHINESE = FeedbackWords(
    language="zh-CN",
    feedback="答卷反馈",
    name="姓名",
    student="学号",
    paper="试卷编号",
    question="第 {} 题",
    question_known="第 {} 题（登分表第 {} 题）",
    asked="所求",
    yours="你的答案",
    read_as="读作 {}",
    right="正确答案",
    verdict="评判",
    points="得分",
    total="总分",
    kept="总分沿用较早一次评分的结果，因其较高。",
    none="无",
    about_hints="说明中凡写“可能”之处，均仅由数值推测，请对照自己的解题过程。",
    solution="题解",
    page="第 {} 页，共 {} 页",
    verdicts={
        "right": "正确",
        "accepted": "认可",
        "follow-through": "推得",
        "mistake": "错误",
        "wrong": "错误",
        "wrong unit": "单位不符",
        "blank": "未作答",
        "unreadable": "无法识别",
        "void": "不计分",
    },
    explained={
        "wrong unit": "所写单位属于另一种物理量。",
        "unreadable": "所填内容无法读作一个数。",
        "accepted": "该答案也予以认可。",
        "follow-through": "该答案由你前一问的错误答案正确推得。",
        "void": "该小问不参与评分。",
        FULL: "该小问不评分，凡交卷者均得满分。",
    },
    reasons_are_shown=False,
    or_else="或者：",
    hints={
        "opposite": "数值大小正确，符号相反：可能把转向（方向）弄反了，或没有注意正负号的约定。",
        "twice": "等于正确值的两倍：可能多乘了系数 2，或把直径当成了半径。",
        "half": "等于正确值的一半：可能漏乘了系数 2，或把半径当成了直径。",
        "degrees for radians": "等于正确值的 180/π 倍：可能应当用弧度而用了度。",
        "radians for degrees": "等于正确值的 π/180 倍：可能应当用度而用了弧度。",
        "revolutions per minute": "等于以转每分表示的正确值：可能没有换算单位。",
        "revolutions per second": "等于以转每秒表示的正确值：可能没有换算单位。",
    },
    turned="此外符号也相反。",
    too_large="等于正确值的 {} 倍：可能小数点错位，或没有换算单位。",
    too_small="等于正确值的 {} 分之一：可能小数点错位，或没有换算单位。",
    close="很接近：相差 {}，而允许误差为 {}。可能是中间结果过早取了近似值。",
    by_policy="更小",
    other_ask="这是 ${}$ 的正确值：可能填错了位置。",
)


def choose_feedback_words(language: str) -> FeedbackWords:
    """The words in "en" or "zh".

    >>> choose_feedback_words("zh").right
    '正确答案'
    """
    return {"en": _ENGLISH, "zh": _CHINESE}[language]
