"""The flight-quality gate: fast, clear of everything, exact, steady? Scored on the truth."""

from __future__ import annotations

import argparse
import sys
import time
import tomllib
from pathlib import Path
from typing import Any

from _run import table
from housefly.errors import HouseflyError
from quality_gate.gate import GateResult, GateRun, run_gate
from quality_gate.page import write_quality_page
from quality_gate.rows import GATE_ROWS
from quality_gate.scenario import Way
from quality_gate.tables import ablation_table, finding_words, measure_table

DESCRIPTION = """\
Fly the rows of the flight-quality gate in lock step in the simulated room, and score them on the
truth: time against the shortest possible, smallest clearance, distance from the reference,
overshooting, touchdown, contacts. Each row is flown by every way of flying that the tree offers:
the grid planner (default), trajectories in space (space), the paper's chain (paper). Exit status 1
says that a limit of a row is not kept; the limits stand in benchmarks/quality_gate/rows.py.
What was flown is kept in --out: Ctrl-C and the same command go on."""
EPILOG = """\
examples:
  python benchmarks/flight_quality.py                       all of it, as make bench does
  python benchmarks/flight_quality.py --quick               a few errands of a few rows
  python benchmarks/flight_quality.py --list                the rows and their limits
  python benchmarks/flight_quality.py --rows eight-100 door --out /tmp/quality
  python benchmarks/flight_quality.py --quick --set control.beta=0.5     a wrong gain turns it red
  PYTHONPATH=../other/src python benchmarks/flight_quality.py --quick    another tree"""


def options(arguments: list[str]) -> argparse.Namespace:
    """Return what the command line asks for."""
    parser = argparse.ArgumentParser(
        description=DESCRIPTION, epilog=EPILOG, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("--quick", action="store_true", help="a few errands of a few rows")
    parser.add_argument("--rows", nargs="+", default=[], metavar="ROW", help="only these")
    parser.add_argument(
        "--ways", nargs="+", default=[], choices=[way.value for way in Way], help="only these"
    )
    parser.add_argument(
        "--set", nargs="+", default=[], metavar="KEY=VALUE",
        help="change keys of the site (docs/site.md) for all rows, as in limits.speed=0.8",
    )  # fmt: skip
    parser.add_argument("--no-ablations", action="store_true", help="switch nothing off")
    parser.add_argument("--list", action="store_true", help="show the rows and their limits")
    parser.add_argument(
        "--out", default="flight-quality", metavar="DIR",
        help="folder of what was flown and of flight-quality.html (default: flight-quality)",
    )  # fmt: skip
    return parser.parse_args(arguments)


def site_changes(pairs: list[str]) -> dict[str, Any]:
    """Return ``a.b=value`` as keys with two underscores; values are read as TOML, else as words."""
    changes: dict[str, Any] = {}
    for pair in pairs:
        key, equals, text = pair.partition("=")
        if not equals or not key:
            sys.exit(f"--set: {pair!r} has no value; write KEY=VALUE, as in limits.speed=0.8")
        try:
            value = tomllib.loads(f"value = {text}")["value"]
        except tomllib.TOMLDecodeError:
            value = text
        changes[key.replace(".", "__")] = value
    return changes


def rows_listed() -> str:
    """Return the rows with their limits, for people."""
    lines = []
    for row in GATE_ROWS:
        lines.append(f"{row.name:<14}{row.title}{'  [quick]' * row.quick}")
        for limit in row.limits:
            ways = ", ".join(way.value for way in limit.ways)
            bound = f"<= {limit.most:g}" if limit.most is not None else f">= {limit.least:g}"
            lines.append(f"{'':<14}  {limit.measure} {bound}   ({ways}; {limit.source})")
    return "\n".join(lines)


def printed(result: GateResult) -> str:
    """Return the result as Markdown."""
    parts = ["### Flight quality, on the truth of the simulated room\n"]
    parts.append(table(*measure_table(result.flown)))
    if result.ablated:
        parts.append("\nOne thing switched off at a time, 5 errands in a draught, 5 % heavier:\n")
        parts.append(table(*ablation_table(result.ablated)))
    for name in result.left_out:
        parts.append(f"\nNot flown: {name}, whose map is not here.")
    kept, all_of = len(result.findings) - len(result.red), len(result.findings)
    parts.append(f"\n{kept} of {all_of} limits kept.\n")
    parts += [f"- RED: {finding_words(finding)}" for finding in result.red]
    return "\n".join(parts)


def main() -> int:
    """Fly, write the page, print; 1 when a limit is not kept."""
    wanted = options(sys.argv[1:])
    if wanted.list:
        print(rows_listed())
        return 0
    began = time.monotonic()

    def tell(words: str) -> None:
        print(f"[{time.monotonic() - began:6.0f} s] {words}", file=sys.stderr, flush=True)

    run = GateRun(
        out=Path(wanted.out),
        rows=tuple(wanted.rows),
        ways=tuple(Way(way) for way in wanted.ways),
        changes=site_changes(wanted.set),
        quick=wanted.quick,
        ablated=not (wanted.no_ablations or wanted.quick or wanted.rows),
    )
    tell("loading; the first start after a change of the code compiles for about half a minute")
    try:
        result = run_gate(run, tell)
    except HouseflyError as error:
        print(error, file=sys.stderr)
        return 2
    command = f"python benchmarks/flight_quality.py {' '.join(sys.argv[1:])}".strip()
    page = write_quality_page(run.out or Path(), result, command)
    tell(f"the page: {page}")
    print(printed(result))
    return 1 if result.red else 0


if __name__ == "__main__":
    sys.exit(main())
