"""Markdown into any target: one reader, the closed list of what prose may hold, and the form of a
writer.

Paragraphs, emphasis, lists and math are what an exam needs; anything else is refused by name, for
every target alike.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from typing import ClassVar, Generic, TypeVar
from unicodedata import category, east_asian_width

from markdown_it import MarkdownIt
from markdown_it.renderer import RendererProtocol
from markdown_it.token import Token
from markdown_it.tree import SyntaxTreeNode
from markdown_it.utils import EnvType, OptionsDict
from mdit_py_plugins.dollarmath import dollarmath_plugin

from kinegrade.errors import TypesetError
from kinegrade.language.gathering import convert_each
from kinegrade.language.message import Fault, Location, Message

_REFUSED = {
    "image": Message("typesetting.image"),
    "html_inline": Message("typesetting.html"),
    "html_block": Message("typesetting.html"),
    "link": Message("typesetting.link"),
    "heading": Message("typesetting.heading"),
    "blockquote": Message("typesetting.quotation"),
    "code_inline": Message("typesetting.code"),
    "code_block": Message("typesetting.indented-code"),
    "fence": Message("typesetting.code"),
    "hr": Message("typesetting.rule"),
    "math_block_label": Message("typesetting.labelled-formula"),
}

Piece = TypeVar("Piece")


class ProseRenderer(RendererProtocol, Generic[Piece]):
    """Makes pieces of a target's text from what markdown-it has read: one method for each kind of
    node, so that a target that lacks one cannot be made.
    """

    __output__: ClassVar[str] = "prose"

    def __init__(self, parser: MarkdownIt | None = None) -> None:
        """As markdown-it makes its renderers."""

    def render(
        self, tokens: Sequence[Token], options: OptionsDict, env: EnvType
    ) -> Sequence[Piece]:
        """The pieces one after another. Raises TypesetError with every fault of the text, each
        naming `env["where"]`.
        """
        return self._write_all(SyntaxTreeNode(tokens).children, env["where"])

    @abstractmethod
    def text(self, plain: str, *, follows_formula: bool) -> Piece:
        """Words and punctuation, to be printed as they are."""

    @abstractmethod
    def formula(self, latex: str, where: Location) -> Piece:
        """A formula in its line. Raises TypesetError."""

    @abstractmethod
    def displayed_formula(self, latex: str, where: Location) -> Piece:
        """A formula on a line of its own within a paragraph. Raises TypesetError."""

    @abstractmethod
    def formula_block(self, latex: str, where: Location) -> Piece:
        """A formula between paragraphs. Raises TypesetError."""

    @abstractmethod
    def line_end(self, *, printed: bool) -> Piece:
        """The end of a line of the source; `printed` where it separates words."""

    @abstractmethod
    def line_break(self) -> Piece:
        """The end of a printed line within a paragraph."""

    @abstractmethod
    def strong(self, content: Sequence[Piece]) -> Piece:
        """Bold text."""

    @abstractmethod
    def emphasis(self, content: Sequence[Piece]) -> Piece:
        """Italic text."""

    @abstractmethod
    def paragraph(self, content: Sequence[Piece]) -> Piece:
        """A paragraph."""

    @abstractmethod
    def short_item(self, content: Sequence[Piece]) -> Piece:
        """The text of an item in a list without blank lines."""

    @abstractmethod
    def bullet_list(self, items: Sequence[Sequence[Piece]]) -> Piece:
        """A list with bullets."""

    @abstractmethod
    def numbered_list(self, items: Sequence[Sequence[Piece]], start: int) -> Piece:
        """A list numbered from `start`."""

    def _write_all(self, nodes: Sequence[SyntaxTreeNode], where: Location) -> list[Piece]:
        # The reader leaves empty texts beside emphasis
        places = (place for place, node in enumerate(nodes) if node.type != "text" or node.content)
        written = convert_each(lambda place: self._write(nodes, place, where), places)
        return [piece for pieces in written for piece in pieces]

    def _write(self, nodes: Sequence[SyntaxTreeNode], place: int, where: Location) -> list[Piece]:
        node = nodes[place]
        match node.type:
            case "inline":
                return self._write_all(node.children, where)
            case "paragraph":
                content = self._write_all(node.children, where)
                return [self.short_item(content) if node.hidden else self.paragraph(content)]
            case "bullet_list":
                return [self.bullet_list(self._write_items(node, where))]
            case "ordered_list":
                start = int(node.attrs.get("start", 1))
                return [self.numbered_list(self._write_items(node, where), start)]
            case "math_block":
                return [self.formula_block(node.content.strip(), where)]
            case _:
                return [self._write_in_line(nodes, place, where)]

    def _write_in_line(self, nodes: Sequence[SyntaxTreeNode], place: int, where: Location) -> Piece:
        node = nodes[place]
        match node.type:
            case "text":
                after = place > 0 and nodes[place - 1].type == "math_inline"
                return self.text(node.content, follows_formula=after)
            case "softbreak":
                return self.line_end(printed=not _is_beside_wide(nodes, place))
            case "hardbreak":
                return self.line_break()
            case "math_inline":
                return self.formula(node.content.strip(), where)
            case "math_inline_double":
                return self.displayed_formula(node.content.strip(), where)
            case "strong":
                return self.strong(self._write_all(node.children, where))
            case "em":
                return self.emphasis(self._write_all(node.children, where))
            case _:
                raise _refuse(node, where)

    def _write_items(self, node: SyntaxTreeNode, where: Location) -> list[list[Piece]]:
        return convert_each(lambda item: self._write_all(item.children, where), node.children)


def make_reader(renderer: type[ProseRenderer[Piece]]) -> MarkdownIt:
    """A reader whose `render` and `renderInline` give the pieces of several paragraphs, or of one
    line, in the form of a target; their `env` names the place of the text as "where".
    """
    options = {"typographer": True}
    reader = MarkdownIt("commonmark", options, renderer_cls=renderer).enable("smartquotes")
    return reader.use(dollarmath_plugin, double_inline=True)


def _refuse(node: SyntaxTreeNode, where: Location) -> TypesetError:
    kind, content = _REFUSED[node.type], node.content.strip()
    what = Message("typesetting.refused", kind=kind)
    if content:
        what = Message("typesetting.refused-text", kind=kind, text=content)
    return TypesetError(
        Fault(where, what, Message("typesetting.prose"), Message("typesetting.take-out"))
    )


def _is_beside_wide(nodes: Sequence[SyntaxTreeNode], place: int) -> bool:
    """Whether a line ends between two Chinese characters or at Chinese punctuation, where it must
    not print a blank.
    """
    before = nodes[place - 1].content[-1:] if place else ""
    after = nodes[place + 1].content[:1] if place + 1 < len(nodes) else ""
    around = [character for character in (before, after) if character]
    wide = [character for character in around if east_asian_width(character) in "WF"]
    return len(wide) == 2 or any(category(character).startswith("P") for character in wide)
