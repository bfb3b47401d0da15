"""Files bound one after another, from whatever program they come."""

from __future__ import annotations

from collections.abc import Callable
from io import BytesIO
from pathlib import Path

import pikepdf
import pytest
from pikepdf import Array, Dictionary, Name, ObjectStreamMode, String

from kinegrade.press.binding.part import count_pages, read_part
from kinegrade.press.binding.values import read_value, write_value
from kinegrade.press.join import join_pages, open_volume

Change = Callable[[pikepdf.Pdf], None]


def make_part(change: Change = lambda _: None, *, packed: bool = False) -> bytes:
    """A page with a link, as another program writes it."""
    part, written = pikepdf.new(), BytesIO()
    part.add_blank_page(page_size=(200, 300))
    link = Dictionary(Type=Name.Annot, Subtype=Name.Link, StructParent=1, Rect=Array([0, 0, 9, 9]))
    part.pages[0].obj.Annots = Array([part.make_indirect(link)])
    part.pages[0].obj.StructParents = 0
    change(part)
    mode = ObjectStreamMode.generate if packed else ObjectStreamMode.disable
    part.save(written, deterministic_id=True, object_stream_mode=mode)
    return written.getvalue()


def tag(part: pikepdf.Pdf) -> None:
    """Give a part a tree, with a header cell that has a name."""
    root = part.make_indirect(Dictionary(Type=Name.StructTreeRoot, ParentTreeNextKey=2))
    cell = Dictionary(Type=Name.StructElem, S=Name.TH, P=root, ID=String("a"), K=0)
    cell.A = Dictionary(O=Name.Table, Headers=Array([String("a")]))
    cell.Pg = part.pages[0].obj
    cell = part.make_indirect(cell)
    root.K = cell
    root.IDTree = Dictionary(Names=Array([String("a"), cell]))
    root.ParentTree = Dictionary(Nums=Array([0, Array([cell]), 1, cell]))
    part.Root.StructTreeRoot, part.Root.Lang = root, String("de")


def name_aloud(text: str) -> Change:
    """Write a text into the page."""

    def change(part: pikepdf.Pdf) -> None:
        tag(part)
        part.Root.StructTreeRoot.K.Alt = String(text)

    return change


@pytest.mark.parametrize("packed", [False, True])
def test_parts_of_other_programs_are_bound(packed: bool) -> None:
    whole = join_pages([make_part(tag, packed=packed), make_part(tag, packed=packed)])
    with pikepdf.open(BytesIO(whole)) as document:
        assert document.check_pdf_syntax() == []
        assert [int(page.obj.StructParents) for page in document.pages] == [0, 2]
        assert [int(page.obj.Annots[0].StructParent) for page in document.pages] == [1, 3]
        tree = document.Root.StructTreeRoot
        elements = list(tree.K[0].K)
        assert [str(each.ID) for each in elements] == ["0-a", "1-a"]
        assert [str(each.A.Headers[0]) for each in elements] == ["0-a", "1-a"]
        assert [each for each in elements if each.P.objgen != tree.K[0].objgen] == []
        assert elements[1].Pg.objgen == document.pages[1].obj.objgen
        parents = dict(pikepdf.NumberTree(tree.ParentTree).items())
        assert sorted(parents) == [0, 1, 2, 3]
        assert parents[3].objgen == elements[1].objgen
        assert dict(pikepdf.NameTree(tree.IDTree).items()).keys() == {"0-a", "1-a"}
        assert str(document.Root.Lang) == "de"


def test_a_volume_is_a_part_again() -> None:
    once = join_pages([make_part(tag), make_part(tag)])
    again = join_pages([once, make_part(tag)])
    with pikepdf.open(BytesIO(again)) as document:
        assert len(document.pages) == 3
        names = pikepdf.NameTree(document.Root.StructTreeRoot.IDTree)
        assert [name for name, _ in names.items()] == ["0-0-a", "0-1-a", "1-a"]


@pytest.mark.parametrize("text", ["see 1 0 R", "a (b) c", "((((1 0 R))))", "a ) b (", "\\ 1 0 R"])
def test_what_is_said_is_no_reference(text: str) -> None:
    with pikepdf.open(BytesIO(join_pages([make_part(name_aloud(text))] * 2))) as document:
        said = [str(each.Alt) for each in document.Root.StructTreeRoot.K[0].K]
    assert said == [text, text]


def test_a_string_with_parentheses_as_typst_writes_them_stays() -> None:
    escaped = make_part(name_aloud("a (b 1 0 R) c"))
    plain = escaped.replace(rb"a \(b 1 0 R\) c", b"a (b 1 0 R) c  ")
    assert plain != escaped
    with pikepdf.open(BytesIO(join_pages([plain]))) as document:
        assert str(document.Root.StructTreeRoot.K[0].K[0].Alt).strip() == "a (b 1 0 R) c"


def test_a_blank_page_is_as_large_as_the_last_even_where_the_tree_says_its_size(
    tmp_path: Path,
) -> None:
    def inherit(part: pikepdf.Pdf) -> None:
        part.Root.Pages.MediaBox = part.pages[0].obj.MediaBox
        del part.pages[0].obj["/MediaBox"]

    with open_volume(tmp_path / "whole.pdf", duplex=True) as append:
        append(make_part(inherit))
    with pikepdf.open(tmp_path / "whole.pdf") as document:
        assert [list(map(int, page.mediabox)) for page in document.pages] == [[0, 0, 200, 300]] * 2


def test_what_a_file_says_of_itself_is_left_out() -> None:
    def attach(part: pikepdf.Pdf) -> None:
        part.attachments["secret.txt"] = b"the secret"
        part.docinfo["/Title"] = "the secret"

    whole = join_pages([make_part(attach), make_part(attach, packed=True)])
    with pikepdf.open(BytesIO(whole)) as document:
        assert not document.attachments
        streams = [each for each in document.objects if isinstance(each, pikepdf.Stream)]
        assert [each for each in streams if b"secret" in each.read_bytes()] == []


def test_a_volume_may_have_what_stood_in_its_place_as_a_part(tmp_path: Path) -> None:
    target = tmp_path / "papers.pdf"
    target.write_bytes(make_part())
    with open_volume(target) as append:
        append(target.read_bytes())
        append(make_part())
    assert count_pages(target.read_bytes()) == 2


def test_nothing_is_written_where_a_part_fails(tmp_path: Path) -> None:
    with pytest.raises(pikepdf.PdfError), open_volume(tmp_path / "papers.pdf") as append:
        append(b"no PDF")
    assert list(tmp_path.iterdir()) == []


def test_no_file_is_bound_from_no_parts() -> None:
    with pikepdf.open(BytesIO(join_pages([]))) as document:
        assert len(document.pages) == 0


def test_values_are_written_as_they_are_read() -> None:
    text = rb"<</A [1 -0.5 12 0 R true] /B (a \) (b)) /C <</D <0aff> /E null>> /F []>>"
    assert write_value(read_value(text)) == text


def test_a_file_in_its_plain_form_is_not_written_anew(monkeypatch: pytest.MonkeyPatch) -> None:
    plain, packed = make_part(), make_part(packed=True)
    monkeypatch.setattr(pikepdf, "open", lambda *_: pytest.fail("opened"))
    assert read_part(plain).count_pages() == 1
    with pytest.raises(pytest.fail.Exception, match="opened"):
        read_part(packed)
