"""What every press prints although `Press` does not ask for it, so that the next press need not."""

from kinegrade.press.latex.press import LatexPress
from kinegrade.press.protocol import Press
from kinegrade.press.typst.press import TypstPress


def find_unshared() -> list[str]:
    """A line for each method that all presses have and `Press` lacks."""
    common = set(dir(TypstPress)) & set(dir(LatexPress)) - set(dir(Press))
    return [f"Press.{name}: missing" for name in sorted(common) if not name.startswith("_")]


if __name__ == "__main__":
    print("\n".join(find_unshared()))
