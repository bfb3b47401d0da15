"""The fixed words of papers, keys and galleries, one table per language."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Words:
    """What a layout prints in addition to the exam's texts; `{}` takes a number or a text."""

    name: str
    student: str
    paper: str
    total: str
    # Heads of the rows of the marker's table: numbers of questions, what they are worth, marks
    number_column: str
    out_of: str
    mark: str
    rules: str
    version: str
    # Takes the question's number in the answer sheet where it differs from that on the paper
    known: str
    point: str  # takes the number one
    points: str  # takes any other number
    asked: str
    answer: str
    unitless: str  # in the place of a unit
    symbol: str
    unit: str
    point_column: str
    source: str
    page: str  # takes the page's number and the number of pages
    turn: str
    key_page: str  # takes the page's number
    given: str
    exact: str
    decimal: str
    interval: str


ENGLISH = Words(
    name="Name",
    student="Student",
    paper="Paper",
    total="Total",
    number_column="Question",
    out_of="Out of",
    mark="Mark",
    rules="How to answer, and how answers are marked",
    version="Version {}",
    known="(no. {} in the answer sheet)",
    point="{} point",
    points="{} points",
    asked="Find",
    answer="Your answer",
    unitless="no unit",
    symbol="Quantity",
    unit="Unit",
    point_column="Points",
    source="Source: {}",
    page="page {} of {}",
    turn="please turn over",
    key_page="page {}",
    given="Given: ",
    exact="Exact",
    decimal="Decimal",
    interval="Marked right",
)

CHINESE = Words(
    name="姓名",
    student="学号",
    paper="试卷编号",
    total="总分",
    number_column="题号",
    out_of="满分",
    mark="得分",
    rules="作答与评分说明",
    version="{} 卷",
    known="（登分表第 {} 题）",
    point="{} 分",
    points="{} 分",
    asked="求",
    answer="答案",
    unitless="无单位",
    symbol="物理量",
    unit="单位",
    point_column="分值",
    source="来源：{}",
    page="第 {} 页，共 {} 页",
    turn="转下页",
    key_page="第 {} 页",
    given="已知：",
    exact="精确值",
    decimal="小数值",
    interval="判为正确的范围",
)


@dataclass(frozen=True)
class GalleryWords:
    """What the layout of a gallery prints in addition to the templates' texts."""

    title: str  # takes the number of templates
    page: str  # takes the page's number and the number of pages
    combinations: str  # takes their number
    asks: str
    on_request: str
    unshown: str
    unreadable: str


ENGLISH_GALLERY = GalleryWords(
    title="Problem templates ({})",
    page=ENGLISH.page,
    combinations="{} combinations",
    asks="Asked: ",
    on_request="On request: ",
    unshown="Cannot be shown: ",
    unreadable="Templates that cannot be read or printed",
)

CHINESE_GALLERY = GalleryWords(
    title="题目模板（{} 个）",
    page=CHINESE.page,
    combinations="{} 种组合",
    asks="所求：",
    on_request="可另选：",
    unshown="无法显示：",
    unreadable="无法读取或排版的模板",
)


def choose_words(language: str) -> Words:
    """The words of "en" or "zh".

    >>> choose_words("zh").student
    '学号'
    """
    return {"en": ENGLISH, "zh": CHINESE}[language]


def choose_gallery_words(language: str) -> GalleryWords:
    """The words of a gallery in "en" or "zh".

    >>> choose_gallery_words("zh").asks
    '所求：'
    """
    return {"en": ENGLISH_GALLERY, "zh": CHINESE_GALLERY}[language]
