"""The verdict on an answer that was typed into the page: what marking would say of it."""

from __future__ import annotations

from functools import partial

from kinegrade.grading.judging.decision import decide
from kinegrade.grading.policy.policy import Ruling
from kinegrade.grading.typed.answers import PAPERS_RULE, read
from kinegrade.grading.verdict_names import name_verdict
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Text
from kinegrade.preview.instance import Instance
from kinegrade.preview.subject import Subject
from kinegrade.students.mistaking.mistake_names import describe_all_mistakes


def judge_typed(subject: Subject, asked: str, typed: str, language: Language) -> tuple[str, ...]:
    """What an answer is called, why, and a sentence for each mistake that leads to it; nothing for
    an ask that there is not. Raises KinegradeError where the instance cannot be solved.
    """
    instance, template = Instance(subject.question), subject.question.template
    found = next((pair for pair in instance.make_keys(language) if pair[0].ask == asked), None)
    if found is None:
        return ()
    ask, key = found
    reread = partial(
        read, unit=ask.unit, style=PAPERS_RULE, convention=ask.convention, sign=ask.sign
    )
    verdict, _ = decide(reread(typed), key, Ruling(), (), reread)
    words, sentences = open_catalogue(language), describe_all_mistakes([template], language)
    said: list[Text] = [name_verdict(verdict.kind), verdict.reason]
    said += [sentences[name] for name in verdict.mistakes if name in sentences]
    return tuple(words.write(each) for each in said if each)
