"""How output comes to stand at its place, and what becomes of what stood there."""
