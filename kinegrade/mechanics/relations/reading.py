"""What is taken of the terms and relations of a motion by a student who makes a mistake, goes on
from a value of their own, or rounds: a `Reading`.
"""

from __future__ import annotations

from dataclasses import replace

from kinegrade.mechanics.laws import Turning
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.relations.term_reading import TermReading
from kinegrade.mechanics.relations.terms import Chain, Term


class Reading(TermReading):
    """What is taken of the terms and relations of a motion: here all of them, as they are.

    Chains and relations as the joints and drivers state them.
    """

    def chain(self, chain: Chain) -> Chain:
        """The terms that are taken for the motion of a point."""
        return chain

    def velocity_chain(self, chain: Chain, *, whole: bool) -> Chain:
        """The terms, of those taken for the motion of a point, that are taken for its velocity; the
        `whole` one, or one of two of which the difference is taken.
        """
        return chain

    def absolute_chain(self, chain: Chain) -> Chain:
        """The terms, of those taken for the motion of a point, that are taken for its absolute
        motion where that is asked for.
        """
        return chain

    def turning(self, relation: Relation) -> Turning:
        """The rates that turn in a relation, with the factors that are taken."""
        return relation.turning

    def relation(self, relation: Relation) -> Relation:
        """The relation as it is taken."""
        left, right = self.chain(relation.left), self.chain(relation.right)
        return replace(relation, left=left, right=right, turning=self.turning(relation))

    def find_relative(self, point: str, frame: str) -> Term | None:
        """The term by which the motion of `point` relative to the body `frame` was solved for; None
        where it is found as a difference.
        """
        return None


PLAIN = Reading()
