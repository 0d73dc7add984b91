"""The acceptor's table in words, as ``docs/paper.md`` shows it."""

from __future__ import annotations

from itertools import product

from housefly.pilot.behavior.acceptor import EXECUTION_ORDER, STATES, TABLE


def described() -> str:
    """Return one line a state and next state, with the conditions that lead there."""
    lines = []
    for state, target in product(STATES, STATES):
        leading = [bits for bits in range(32) if STATES[TABLE[STATES.index(state), bits]] is target]
        names = sorted({_deciding(bits) for bits in leading})
        lines.append(f"{state.value} -> {target.value}: {', '.join(names)}")
    return "\n".join(lines)


def _deciding(bits: int) -> str:
    return next(
        (condition.name or "" for condition, _ in EXECUTION_ORDER if bits & condition),
        "no condition",
    )
