"""All pages of the reference, and where they are written."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

from docs.generator.banks import write_bank_page, write_plan_page, write_policy_page
from docs.generator.commands import write_commands
from docs.generator.folders import write_folder_page
from docs.generator.gallery import write_gallery_page
from docs.generator.lists import (
    write_format_page,
    write_language_page,
    write_mistake_page,
    write_refusal_page,
    write_status_page,
)
from docs.generator.python import write_python_page
from docs.generator.templates import (
    write_expression_page,
    write_shipped_page,
    write_template_page,
)

PAGES: Mapping[str, Callable[[], str]] = {
    "commands": write_commands,
    "banks": write_bank_page,
    "policies": write_policy_page,
    "term-plans": write_plan_page,
    "templates": write_template_page,
    "expressions": write_expression_page,
    "shipped-templates": write_shipped_page,
    "gallery": write_gallery_page,
    "folders": write_folder_page,
    "mistakes": write_mistake_page,
    "refused-draws": write_refusal_page,
    "formats": write_format_page,
    "languages": write_language_page,
    "statuses": write_status_page,
    "python": write_python_page,
}


def write_reference(folder: Path) -> None:
    """Write every page into a folder, as Markdown."""
    for name, write in PAGES.items():
        (folder / f"{name}.md").write_text(write(), encoding="utf-8")
