"""Flies the rows of the gate that a folder does not hold yet, and judges all of them."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from housefly.errors import ConfigError
from quality_gate.ablations import ABLATIONS, Ablation
from quality_gate.flown_row import FlownLeg, FlownRow
from quality_gate.fly import fly_row
from quality_gate.kept_rows import keep_row, kept_rows, tree_digest
from quality_gate.rooms import GateRoom, gate_site, is_there
from quality_gate.rows import ABLATED, GATE_ROWS
from quality_gate.scenario import WAY_CHANGES, Scenario, Way
from quality_gate.verdict import Finding, limit_findings

_QUICK_ERRANDS = 6


@dataclass(frozen=True, slots=True)
class GateRun:
    """What is wanted of the gate.

    Attributes:
        out: folder of what is kept; None keeps nothing.
        rows: names; none for all.
        ways: who flies; none for all that this tree offers.
        changes: of the site's keys, for every row.
        quick: a few errands of a few rows.
        errands_max: of ``quick``.
        ablated: whether things are switched off, too.
    """

    out: Path | None = None
    rows: tuple[str, ...] = ()
    ways: tuple[Way, ...] = ()
    changes: dict[str, Any] | None = None
    quick: bool = False
    errands_max: int = _QUICK_ERRANDS
    ablated: bool = True


@dataclass(frozen=True, slots=True)
class GateResult:
    """What the gate found.

    Attributes:
        flown: row by row, the ways side by side.
        ablated: name of what was off, and what was flown; None where the tree does not offer it.
        findings: every limit.
        left_out: rows that cannot be flown on this machine.
    """

    flown: tuple[FlownRow, ...]
    ablated: tuple[tuple[str, FlownRow | None], ...]
    findings: tuple[Finding, ...]
    left_out: tuple[str, ...]

    @property
    def red(self) -> tuple[Finding, ...]:
        """The limits that are not kept."""
        return tuple(finding for finding in self.findings if not finding.holds)


Tell = Callable[[str], None]


def offered(changes: dict[str, Any], others: dict[str, Any] | None = None) -> bool:
    """Return whether this tree knows some keys of a site, beside others that it knows."""
    try:
        gate_site(GateRoom.HALL, **((others or {}) | changes))
    except ConfigError:
        return False
    return True


def wanted_rows(run: GateRun) -> tuple[Scenario, ...]:
    """Return the rows to fly; raises ConfigError for a name that is none."""
    known = {row.name: row for row in GATE_ROWS}
    for name in run.rows:
        if name not in known:
            raise ConfigError("--rows", f"{name!r} is none; there are {', '.join(known)}")
    if run.rows:
        return tuple(known[name] for name in run.rows)
    return tuple(row for row in GATE_ROWS if row.quick or not run.quick)


def run_gate(run: GateRun, tell: Tell) -> GateResult:
    """Fly what is not kept yet and judge everything.

    Args:
        run: what is wanted.
        tell: called with a line before and after every flight, and after every leg.

    Raises:
        ConfigError: a row or a key that is none.
    """
    changes = run.changes or {}
    wanted = wanted_rows(run)
    if not offered(changes):
        gate_site(wanted[0].room, **changes)  # says which key is wrong
    ways = tuple(way for way in run.ways or tuple(Way) if offered(WAY_CHANGES[way]))
    pilots = _Pilots(run, changes, tell)
    rows = [row for row in wanted if is_there(row.room)]
    todo = [(row, way) for row in rows for way in row.ways if way in ways]
    tell(f"{len(todo)} flights wanted, {sum(pilots.has(*one) for one in todo)} of them kept")
    flown: list[FlownRow] = []
    found: list[Finding] = []
    for row in rows:
        mine = [pilots.flown(row, way) for way in row.ways if way in ways]
        flown += mine
        found += limit_findings(row, mine, whole=not run.quick)
    best = Way.SPACE if Way.SPACE in ways else Way.GRID
    ablated = tuple(
        (one.name, pilots.flown(_ablated(one), one.way or best) if offered(one.changes) else None)
        for one in (ABLATIONS if run.ablated else ())
    )
    left_out = tuple(row.name for row in wanted if not is_there(row.room))
    return GateResult(tuple(flown), ablated, tuple(found), left_out)


def _ablated(ablation: Ablation) -> Scenario:
    """Return the row of an ablation, in a tree that offers it."""
    name = f"{ABLATED.name}: {ablation.name}"
    return replace(ABLATED, name=name, changes=ABLATED.changes | ablation.changes)


class _Pilots:
    """Flies rows, or finds them among what is kept."""

    def __init__(self, run: GateRun, changes: dict[str, Any], tell: Tell) -> None:
        self._out, self._changes, self._tell = run.out, changes, tell
        self._few = run.errands_max if run.quick else None
        self._code = tree_digest()
        self._there = kept_rows(run.out) if run.out else {}

    def has(self, row: Scenario, way: Way) -> bool:
        """Return whether a row is kept as this code flies it."""
        return (row.name, way.value, self._key(row)) in self._there

    def flown(self, row: Scenario, way: Way) -> FlownRow:
        """Return a row, flown now if it is not kept."""
        if self.has(row, way):
            return self._there[row.name, way.value, self._key(row)]
        self._tell(f"{row.name} / {way.value}: {row.title} ...")
        flown = fly_row(row, way, self._key(row), self._changes, self._told, self._few)
        self._tell(f"  {len(flown.legs)} flown, {flown.processor_s:.0f} s of processor time")
        if self._out:
            keep_row(self._out, flown)
        return flown

    def _told(self, leg: FlownLeg) -> None:
        x, y = leg.goal
        went_wrong = f": {leg.outcome}" if leg.outcome else ""
        self._tell(f"  to ({x:.1f}, {y:.1f}): {leg.measures.told_after:.1f} s{went_wrong}")

    def _key(self, row: Scenario) -> str:
        """Return what a result depends on, besides row and way; limits are judged anew."""
        course = hashlib.sha256(repr(replace(row, limits=())).encode()).hexdigest()[:12]
        return json.dumps([self._code, course, self._changes, self._few])
