"""Pictures of the console in each state and fault, with its headline and what was true, as HTML."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from html import escape
from pathlib import Path

FIVE_SIZES = ((390, 844), (844, 390), (768, 1024), (1280, 800), (1920, 1080))
"""A phone both ways, a tablet, a laptop, a large screen [px]."""
REPORT_VARIABLE = "HOUSEFLY_CONSOLE_REPORT"
"""Names the folder where the report is kept; without it nobody keeps it."""


@dataclass
class ConsoleReport:
    """A table that grows with the test.

    Attributes:
        folder: where pictures and ``index.html`` go.
        rows: state, fault, headline, truth, and the names of the pictures.
    """

    folder: Path
    rows: list[tuple[str, str, str, str, list[str]]] = field(default_factory=list)

    def add(self, state: str, fault: str, headline: str, truth: str, pictures: list[str]) -> None:
        """Add a row and write the page, so that a test that fails leaves what it saw."""
        self.rows.append((state, fault, headline, truth, pictures))
        (self.folder / "index.html").write_text(self._page(), encoding="utf-8")

    def _page(self) -> str:
        rows = "".join(
            f"<h2>{escape(state)}, {escape(fault)}</h2>"
            f"<p><b>said</b> {escape(headline)}<br><b>true</b> {escape(truth)}</p>"
            + "".join(f'<img src="{name}" height="300" alt="{name}"> ' for name in pictures)
            for state, fault, headline, truth, pictures in self.rows
        )
        return f"<!doctype html><meta charset=utf-8><title>States and faults</title>{rows}"


def console_report(name: str, otherwise: Path) -> ConsoleReport:
    """Return an empty report in the folder that the environment names, or in another."""
    kept = os.environ.get(REPORT_VARIABLE)
    folder = Path(kept) / name if kept else otherwise
    folder.mkdir(parents=True, exist_ok=True)
    return ConsoleReport(folder)
