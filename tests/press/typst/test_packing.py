"""A packed PDF holds what the plain one holds, object by object."""

from __future__ import annotations

from collections.abc import Mapping
from io import BytesIO

import pikepdf
import pytest

from kinegrade.press.join import join_pages
from kinegrade.press.sheet import Paper
from kinegrade.press.typst.compiler import make_compiler
from kinegrade.press.typst.packing import pack
from kinegrade.press.typst.paper import write_paper_source
from tests.press.papers import CHINESE, ENGLISH


def read_objects(pdf: bytes) -> Mapping[int, bytes]:
    """Every object by its number."""
    with pikepdf.open(BytesIO(pdf)) as document:
        assert document.check_pdf_syntax() == []
        return {
            each.objgen[0]: each.unparse(resolved=True)
            + (each.read_raw_bytes() if isinstance(each, pikepdf.Stream) else b"")
            for each in document.objects
        }


@pytest.mark.parametrize("paper", [ENGLISH, CHINESE], ids=["en", "zh"])
def test_nothing_is_lost(paper: Paper) -> None:
    source = write_paper_source(paper).encode()
    plain = make_compiler().compile(source, format="pdf", pdf_standards="ua-1", timestamp=0)
    assert isinstance(plain, bytes)
    packed = pack(plain)
    assert packed == pack(plain)
    before, after = read_objects(plain), read_objects(packed)
    assert {number: after[number] for number in before} == before
    assert len(packed) < 0.8 * len(plain)


def test_what_is_written_in_another_way_stays_as_it_is() -> None:
    source = write_paper_source(ENGLISH).encode()
    plain = make_compiler().compile(source, format="pdf", timestamp=0)
    assert isinstance(plain, bytes)
    for pdf in (pack(plain), join_pages([plain])):
        assert pack(pdf) == pdf


def test_a_damaged_table_is_no_reason_to_guess() -> None:
    source = write_paper_source(ENGLISH).encode()
    plain = make_compiler().compile(source, format="pdf", timestamp=0)
    assert isinstance(plain, bytes)
    with pytest.raises(ValueError, match="no object of a PDF at"):
        pack(plain.replace(b"\nendobj", b"\nendobk", 1))
