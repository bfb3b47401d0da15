"""The fixed words of the class report, one table per language; `{}` takes a number or a text."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class ReportWords:
    """The texts in the layout of the class report, besides the exam's own."""

    language: str  # as HTML names it
    report: str
    counted: str  # takes how many answered anything, and the size of the roster
    silent: str  # takes how many answered nothing
    nobody: str
    few: str
    totals: str
    mean: str
    sd: str
    median: str
    quartiles: str
    span: str
    reliability: str
    of_points: str  # takes the maximum
    students: str
    percent_axis: str
    marks_on_axis: str
    asks: str
    question: str
    numbered: str  # takes a question's number in the bank's order, which applies to the whole class
    ask: str
    points: str
    facility: str
    discrimination: str
    answers: str
    note: str
    hard: str
    easy: str
    flat: str
    negative: str
    losses: str
    losses_about: str
    reason: str
    count: str
    where: str
    no_losses: str
    hardness: str
    version: str
    test_of_versions: str  # takes H, p, number of shuffles
    versions_differ: str
    versions_alike: str
    too_few: str  # takes the number of students that would be enough
    trends: str  # takes the number of drawn numbers examined
    trend_found: str
    no_trend: str
    parameter: str
    thirds: str
    rank_correlation: str
    p_value: str
    adjusted: str
    same_papers: str
    complaints: str
    no_complaints: str
    more_complaints: str  # takes how many are shown, how many there are, and the full file's name
    line: str
    column: str
    content: str
    problem: str
    done: str
    definitions: str
    small_print: tuple[str, ...]
    verdicts: Mapping[str, str]
    reasons: Mapping[str, str]


ENGLISH = ReportWords(
    language="en",
    report="Class report",
    counted="{} of {} students answered",
    silent="{} answered nothing and are left out of all figures below.",
    nobody="Nobody answered anything, so there is nothing to report.",
    few="Few students: take every figure below with care.",
    totals="Totals",
    mean="mean",
    sd="standard deviation",
    median="median",
    quartiles="quartiles",
    span="lowest to highest",
    reliability="reliability (α)",
    of_points="of {} points",
    students="students",
    percent_axis="total, % of the points",
    marks_on_axis="▲ median   ○ mean",
    asks="The asks one by one",
    question="Question",
    numbered="Question {}",
    ask="Asked",
    points="Points",
    facility="Facility",
    discrimination="Discrimination",
    answers="Answers",
    note="Worth a look",
    hard="hard",
    easy="easy",
    flat="hardly tells strong papers from weak ones",
    negative="strong papers do worse here: check key and wording",
    losses="Where points were lost",
    losses_about="Every answer that did not get all its points, by what probably went wrong. "
    "Reasons marked * are guesses from the number alone.",
    reason="What went wrong",
    count="Answers",
    where="Asked for",
    no_losses="No points were lost.",
    hardness="Were all papers equally hard?",
    version="Version",
    test_of_versions="Kruskal-Wallis: H = {}, p = {} ({} permutations).",
    versions_differ="The versions differ by more than chance would easily explain. Look at the "
    "questions whose facilities differ before you compare students.",
    versions_alike="The differences between the versions are of a size that often arises by "
    "chance alone.",
    too_few="Too few to say: with fewer than {} students, such figures are mostly chance.",
    trends="Every paper has its own numbers. For each of the {} numbers drawn: do students with "
    "larger ones do better or worse in that question? The clearest first.",
    trend_found="Where the adjusted p is below 0.05, look at that question: some of its papers may "
    "have been harder. It is a hint, not a proof.",
    no_trend="No drawn number stands out once it is taken into account how many were looked at.",
    parameter="Number",
    thirds="Facility by thirds: lowest · middle · highest numbers",
    rank_correlation="Rank correlation",
    p_value="p",
    adjusted="adjusted p",
    same_papers="All papers had the same numbers.",
    complaints="Complaints",
    no_complaints="There are none.",
    more_complaints="The first {} of {}; all are in {}.",
    line="Line",
    column="Column",
    content="Content",
    problem="Problem",
    done="What was done",
    definitions="How the figures are defined",
    small_print=(
        "Facility: the mean share of an ask's points that students got. Hard is below 30 %, easy "
        "above 90 %.",
        "Discrimination: the corrected item-total correlation, that is Pearson's correlation "
        "between the points of the ask and the points of all other asks together. Above 0.3 is "
        "usual for a good ask; values below 0.1 are noted, and values below −2/√n noted as negative.",
        "Standard deviation: with n − 1. Quartiles: by linear interpolation. Reliability: "
        "Cronbach's α of the asks.",
        "Versions are compared by the Kruskal-Wallis rank test on totals, drawn numbers by "
        "Spearman's rank correlation with the share of the question's points. p is by random "
        "permutations (always the same ones): the share in which chance does at least as much. "
        "Adjusted p: by Holm's method, for the number of tests.",
    ),
    verdicts={
        "right": "right",
        "accepted": "accepted",
        "follow-through": "follows from an earlier answer",
        "mistake": "known mistake",
        "wrong": "wrong",
        "wrong unit": "wrong unit",
        "blank": "blank",
        "unreadable": "unreadable",
        "void": "void",
    },
    reasons={
        "opposite": "sign opposite*",
        "power of ten": "off by a power of ten*",
        "twice": "twice the right value*",
        "half": "half the right value*",
        "degrees for radians": "degrees in place of radians*",
        "radians for degrees": "radians in place of degrees*",
        "revolutions per minute": "revolutions per minute in place of rad/s*",
        "revolutions per second": "revolutions per second in place of rad/s*",
        "another ask": "the value of another quantity asked for*",
        "close": "close, but outside the tolerance",
        "unexplained": "wrong, not explained",
        "wrong unit": "unit of another kind of quantity",
        "unreadable": "not a readable number",
        "blank": "left blank",
        "accepted": "accepted in part",
        "follow-through": "follows from an earlier wrong answer",
        "mistake": "known mistake",
        "void": "void",
    },
)

CHINESE = ReportWords(
    language="zh-CN",
    report="班级成绩分析",
    counted="{} 人作答，名单共 {} 人",
    silent="{} 人未作答，以下统计均不计入。",
    nobody="无人作答，没有可统计的内容。",
    few="人数较少，以下各项数字仅供参考。",
    totals="总分",
    mean="平均分",
    sd="标准差",
    median="中位数",
    quartiles="四分位数",
    span="最低至最高",
    reliability="信度（α）",
    of_points="满分 {}",
    students="人数",
    percent_axis="总分占满分的百分比",
    marks_on_axis="▲ 中位数   ○ 平均分",
    asks="各小问分析",
    question="题目",
    numbered="第 {} 题",
    ask="所求",
    points="分值",
    facility="得分率",
    discrimination="区分度",
    answers="作答情况",
    note="值得注意",
    hard="偏难",
    easy="偏易",
    flat="几乎不能区分好卷与差卷",
    negative="总分高者反而失分：请检查答案与题意",
    losses="失分原因",
    losses_about="所有未得满分的作答，按可能的原因归类。带 * 的原因仅由数值推测。",
    reason="原因",
    count="次数",
    where="所在小问",
    no_losses="没有失分。",
    hardness="各份试卷难度是否相当？",
    version="卷别",
    test_of_versions="Kruskal-Wallis 检验：H = {}，p = {}（{} 次置换）。",
    versions_differ="各卷之间的差异较大，难以仅用偶然解释。比较学生成绩之前，请查看得分率相差较大的题目。",
    versions_alike="各卷之间的差异在偶然波动的常见范围之内。",
    too_few="人数太少，无法判断：不足 {} 人时，这类数字多半出于偶然。",
    trends="每份试卷的数据各不相同。下面考察抽取的 {} 个数据："
    "数值较大的学生在该题得分是否偏高或偏低（最明显的排在前面）。",
    trend_found="校正后的 p 小于 0.05 的题目值得检查：其中部分试卷可能偏难。这只是提示，不是证明。",
    no_trend="考虑到所考察数据的个数，没有哪个数据的影响明显。",
    parameter="数据",
    thirds="按数值三等分的得分率：较小 · 居中 · 较大",
    rank_correlation="秩相关系数",
    p_value="p",
    adjusted="校正后 p",
    same_papers="所有试卷的数据相同。",
    complaints="需人工查看的问题",
    no_complaints="没有。",
    more_complaints="此处列出前 {} 条，共 {} 条；全部见 {}。",
    line="行",
    column="列",
    content="内容",
    problem="问题",
    done="处理方式",
    definitions="各项数字的定义",
    small_print=(
        "得分率：该小问平均得分与满分之比。低于 30 % 记为偏难，高于 90 % 记为偏易。",
        "区分度：校正的题总相关，即该小问得分与其余各小问总得分的 Pearson 相关系数。好题一般在 0.3 以上；低于 0.1 时加以提示，低于 −2/√n 时视为负相关。",
        "标准差：分母为 n − 1。四分位数：线性插值。信度：各小问的 Cronbach α 系数。",
        "各卷总分用 Kruskal-Wallis 秩检验比较；抽取的数据用其与该题得分率的 Spearman 秩相关考察。p "
        "由随机置换得到（每次所用置换相同），即偶然情形下差异不小于实际差异的比例；校正后 p 按检验个数用 Holm 法校正。",
    ),
    verdicts={
        "right": "正确",
        "accepted": "认可",
        "follow-through": "由前一答案推得",
        "mistake": "已知错误",
        "wrong": "错误",
        "wrong unit": "单位不符",
        "blank": "空白",
        "unreadable": "无法识别",
        "void": "作废",
    },
    reasons={
        "opposite": "符号相反*",
        "power of ten": "相差 10 的幂次*",
        "twice": "为正确值的两倍*",
        "half": "为正确值的一半*",
        "degrees for radians": "应为弧度而用了度*",
        "radians for degrees": "应为度而用了弧度*",
        "revolutions per minute": "应为 rad/s 而用了转每分*",
        "revolutions per second": "应为 rad/s 而用了转每秒*",
        "another ask": "填成了本题另一个所求量的值*",
        "close": "接近，但超出允许误差",
        "unexplained": "错误，原因不明",
        "wrong unit": "单位属于另一种物理量",
        "unreadable": "不是可识别的数",
        "blank": "未作答",
        "accepted": "部分认可",
        "follow-through": "由前面的错误答案推得",
        "mistake": "已知错误",
        "void": "作废",
    },
)


def choose_report_words(language: str) -> ReportWords:
    """The words in "en" or "zh".

    >>> choose_report_words("zh").facility
    '得分率'
    """
    return {"en": ENGLISH, "zh": CHINESE}[language]
