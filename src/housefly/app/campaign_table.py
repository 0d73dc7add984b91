"""The summary of a campaign as a table in the terminal."""

from __future__ import annotations

from rich.console import Console

from housefly.app.terminal import console, new_table
from housefly.lab.campaigns.spec import CampaignSpec
from housefly.lab.campaigns.summary import SHARES, GridPoint, estimate_text, value_text
from housefly.lab.experiments.cases import BY_NAME
from housefly.lab.experiments.outcomes import SUMMARY_MEASURES

_MAX_ROWS = 40
"""Rows that are printed; the others are in the file."""
_FILE_WIDTH = 140
"""Columns of a line where the output is no terminal."""


def print_summary(spec: CampaignSpec, cells: tuple[GridPoint, ...]) -> None:
    """Print the summary of a campaign, one row for each point of its grid."""
    units = {measure.name: measure.unit for measure in SUMMARY_MEASURES} | {
        name: BY_NAME[name].unit for name in spec.grid
    }
    table = new_table(())
    rows = []
    for cell in cells[:_MAX_ROWS]:
        values = (
            value_text(name, value) for name, value in zip(spec.grid, cell.values, strict=True)
        )
        rows.append(
            (
                *values,
                str(cell.drones),
                *(estimate_text(measure, cell.estimates[measure]) for measure in spec.plot),
            )
        )
    for name, texts in zip(
        (*spec.grid, "drones", *spec.plot), zip(*rows, strict=True), strict=True
    ):
        unit = "1" if name in SHARES else units.get(name, "1")
        heading = name.replace("_", " ") + ("" if unit == "1" else f" \\[{unit}]")
        table.add_column(heading, justify="right", min_width=max(map(len, texts)))
    for row in rows:
        table.add_row(*row)
    (console if console.is_terminal else Console(highlight=False, width=_FILE_WIDTH)).print(table)
    if len(cells) > _MAX_ROWS:
        console.print(f"... {len(cells) - _MAX_ROWS} more in summary.csv")
    console.print("means over stable flights and shares, with 95 % intervals over seeds")
