"""The tables of columns and measures in ``docs/campaigns.md``.

Print them with ``python scripts/campaign_tables.py``.
"""

from __future__ import annotations

from math import inf

from housefly.config.site import Site
from housefly.lab.experiments.cases import PARAMETERS, Parameter
from housefly.lab.experiments.outcomes import SUMMARY_MEASURES


def columns_table() -> str:
    """Return every column as a Markdown table: unit, range, value of the shipped site, meaning."""
    rows = [
        f"| `{p.name}` | {p.unit} | {p.low:g} to {'any' if p.high == inf else f'{p.high:g}'} |"
        f" {_default(p)} | {p.meaning} |"
        for p in PARAMETERS
    ]
    return "\n".join(
        ["| column | unit | allowed | shipped site | meaning |", "|---|---|---|---|---|", *rows]
    )


def measures_table() -> str:
    """Return every measure with unit and meaning, as Markdown."""
    rows = [
        f"| `{measure.name}` | {measure.unit} | {measure.meaning} |" for measure in SUMMARY_MEASURES
    ]
    return "\n".join(["| measure | unit | meaning |", "|---|---|---|", *rows])


def _default(parameter: Parameter) -> str:
    ours, paper = (parameter.of(Site(mode=mode)) for mode in ("default", "paper"))
    return f"{ours:.4g}" if ours == paper else f"{ours:.4g}; mode paper {paper:.4g}"


if __name__ == "__main__":
    print(columns_table(), measures_table(), sep="\n\n")
