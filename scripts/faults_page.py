"""Writes ``docs/faults.md`` from the tables: every fault, and every row of the matrix.

``python scripts/faults_page.py > docs/faults.md``
"""

from __future__ import annotations

from fault_words import LEFT_OUT, fault_words

from housefly.twin.faults.catalogue import FAULT_CATALOGUE
from housefly.twin.faults.fault_row import FaultRow
from housefly.twin.faults.fault_types import FAULT_TYPES
from housefly.twin.faults.vocabulary import FaultComponent, FaultType, Injection

_HEAD = """# Faults of the simulated room

Whatever can fail in a flight can be made to fail in the simulated room: tracking that lies, links
that lose, motors that weaken, people in the way. The words are PX4's: ok, off, stuck, garbage,
wrong, slow, delayed, intermittent. What is random about a fault comes from its seed, so a flight
with faults can be flown again, bit for bit; without faults every number is as if this page did not
exist. Nothing of it can reach a real drone: a site with `twin.enabled = false` and faults is
refused, and drivers and tracking clients do not know faults.

```console
housefly fly entrance --lockstep --fault F13@20s
housefly fly entrance --lockstep --fault F13/5cm@20s --fault "mocap:off@30s+1s"
housefly fly entrance --headless --fault "commands:intermittent@15s+5s=0.3#7"
housefly demo --fault F16@60s
```

A row of the matrix is `ROW[/VARIANT][@START][+DURATION][#SEED]`; one component is
`COMPONENT[.SIDE]:KIND[@START][+DURATION][=SIZE][#SEED]`. Times are seconds since the simulated room
began; without a start a fault is there from the beginning, without a duration for good.
`mocap:ok@30s` ends what began before. In a room with several drones a fault befalls the first, or
the one that it names, `bert: F13@20s`; scanners, depth cameras and devices are the room's. In a
site file:

```toml
[[faults]]
fault = "F13@20s"

[[faults]]
fault = "mocap.yaw:wrong=0.52"   # the body is defined 30 degrees off
```

In a program, `Simulation.inject("mocap:off@20s+1s")` (`lab/lockstep/simulation.py::Simulation`).
What a fault does to a stream stands in `twin/faults/`; what it does to the drone's body in
`twin/disturbance.py::Disturbances`.

## Scored on the truth

A tracking system that lies would also lie about the score. The simulated room therefore writes
where the drone really was and what it touched, 50 times a second, to `truth.jsonl` beside the
recording (`twin/truth_log.py::TruthLog`); nobody reads it before the flight is over. From it
`summary.json` has the errors, the smallest clearances of the hull from walls and from people, and
every contact; what the tracking system said stands beside it under names of its own
(`tracked_rms_error_m` and so on). A service in which the drone touched anything but the floor,
ended more than 1 m from the pad, or ended standing on something, is never completed. Without the
truth, as with real hardware, these numbers are "not measured".

This page is made from the code (`python scripts/faults_page.py`); a test keeps it current.
"""


def faults_page() -> str:
    """Return the page as Markdown."""
    matrix = [
        "## The fault matrix",
        "",
        "Harmful: whether the same flight without its guards is expected to do harm. Extreme:"
        " stronger than",
        "the drone is made for; campaigns leave it out.",
        "",
        "| row | what happens | how it must end | variants, the first is meant | where | harmful |",
        "|---|---|---|---|---|---|",
        *map(_row, FAULT_CATALOGUE),
    ]
    words = [
        "## The eight words",
        "",
        "| component | words that it has | left out |",
        "|---|---|---|",
        *map(_words, FaultComponent),
    ]
    types = [
        "## Every fault",
        "",
        "| fault | what it does | size: default, range | where |",
        "|---|---|---|---|",
        *map(_type, FAULT_TYPES),
    ]
    return "\n".join([_HEAD, *matrix, "", *words, "", *types]) + "\n"


def _row(row: FaultRow) -> str:
    names = ", ".join(
        f"`{row.number}/{variant.name}`{' (extreme)' * variant.is_extreme}"
        for variant in row.variants
    )
    covered = f"covered by {_quoted(row.covered_by)}" if row.covered_by else ""
    how = "; ".join(filter(None, (names, covered)))
    harmful = "yes" if row.harmful else "no" if row.variants else "-"
    return (
        f"| {row.number} | {row.title} | {row.safe_outcome} | {how} | {_where(row.where)} |"
        f" {harmful} |"
    )


def _quoted(covered_by: str) -> str:
    """Return words in which the names of tests are code."""
    return " ".join(
        f"`{word.rstrip(',')}`" + word[len(word.rstrip(",")) :] if ".py" in word else word
        for word in covered_by.split(" ")
    )


def _words(component: FaultComponent) -> str:
    reasons = LEFT_OUT.get(component, {})
    left_out = "; ".join(
        f"{', '.join(kind.value for kind, why in reasons.items() if why == reason)}: {reason}"
        for reason in dict.fromkeys(reasons.values())
    )
    own = ", ".join(kind.value for kind in fault_words(component))
    return f"| `{component.value}` | {own} | {left_out or '-'} |"


def _type(known: FaultType) -> str:
    unit = "" if known.unit == "1" else f" {known.unit}"
    size = f"{known.default:.3g}, {known.low:.3g} to {known.high:.3g}{unit}" if known.unit else "-"
    return f"| `{known.name}` | {known.words} | {size} | {_where(known.where)} |"


def _where(places: frozenset[Injection]) -> str:
    return ", ".join(place.value for place in Injection if place in places)


if __name__ == "__main__":
    print(faults_page(), end="")
