"""`kinegrade.Bank`: what an exam asks, for how many points."""

from __future__ import annotations

from dataclasses import dataclass
from os import PathLike
from pathlib import Path

from kinegrade.exam.bank.bank import find_bank, read_blueprint
from kinegrade.exam.bank.blueprint import Blueprint


@dataclass(frozen=True, repr=False)
class Bank:
    """An exam's questions, some of them perhaps still to be drawn, and what holds for all of
    them.
    """

    blueprint: Blueprint

    def __repr__(self) -> str:
        slots = self.blueprint.slots
        named = (
            "..." if each.drawn else " or ".join(one.template.name for one in each.candidates)
            for each in slots
        )
        return f"<{', '.join(map('{}: {}'.format, (each.identifier for each in slots), named))}>"

    @classmethod
    def read(cls, source: str | PathLike[str]) -> Bank:
        """The bank in a TOML file, or the shipped bank of that name. Raises BankError with all
        faults of the file.

        >>> len(Bank.read("demo").blueprint.slots)
        4
        >>> Bank.read("demmo")
        Traceback (most recent call last):
        kinegrade.errors.BankError: no bank "demmo": did you mean "demo"? ...
        """
        return cls(read_blueprint(find_bank(Path(source))))
