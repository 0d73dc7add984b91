"""Fig. 10: the finite state acceptor, drawn from the table that flies."""

from __future__ import annotations

from itertools import product
from math import atan2, cos, hypot, pi, sin
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Ellipse, FancyArrowPatch
from numpy.typing import NDArray

from housefly.lab.reproduction.drawing import write_figure
from housefly.lab.reproduction.exhibit import Exhibit
from housefly.messages import Behavior
from housefly.pilot.behavior.acceptor import EXECUTION_ORDER, STATES, TABLE, Condition
from housefly.theme import LIGHT

_PLACES: dict[Behavior, tuple[float, float]] = {
    Behavior.HOVER: (0.0, -0.6),
    Behavior.ALTITUDE_CONTROL: (0.0, 3.0),
    Behavior.YAW_CONTROL: (-5.2, -3.2),
    Behavior.PATH_TRACKING: (5.2, -3.2),
}
_WIDTH, _HEIGHT = 2.1, 0.8
_SYMBOLS = {
    Condition.Q1: "$q_1$",
    Condition.Q2: "$q_2$",
    Condition.Q3: "$q_3$",
    Condition.Q4: "$q_4$",
    Condition.REST: "rest",
}
_ELSE = "else"
_Transition = tuple[Behavior, Behavior, tuple[str, ...]]


def transitions(table: NDArray[np.uint8] = TABLE) -> tuple[_Transition, ...]:
    """Return every transition of a table: from, to, and the conditions that decide it.

    "else" stands where no condition holds.
    """
    found = []
    for state, target in product(STATES, STATES):
        bits = [b for b in range(table.shape[1]) if STATES[table[STATES.index(state), b]] is target]
        if bits:
            found.append(
                (state, target, tuple(dict.fromkeys(_deciding(b) for b in sorted(bits, key=_rank))))
            )
    return tuple(found)


def _deciding(bits: int) -> str:
    return next(
        (_SYMBOLS[condition] for condition, _ in EXECUTION_ORDER if bits & condition), _ELSE
    )


def _rank(bits: int) -> int:
    return next(
        (rank for rank, (condition, _) in enumerate(EXECUTION_ORDER) if bits & condition),
        len(EXECUTION_ORDER),
    )


def draw_fig10(folder: Path, table: NDArray[np.uint8] = TABLE) -> Exhibit:
    """Draw the acceptor."""
    found = transitions(table)
    write_figure(folder, "fig10", (8.6, 6.1), lambda figure: _paint(figure, found))
    between = sum(1 for state, target, _ in found if state is not target)
    return Exhibit(
        "10",
        "Finite state acceptor",
        "fig10",
        "Four behaviors and the transitions between them; the text gives conditions q1 to q4 and an"
        " order, but not every edge.",
        f"Drawn from the table that flies: {len(STATES)} states, {between} transitions between"
        " them. Rest, which the paper has not, means that nothing is to be tracked. Where several"
        " conditions hold, rest decides before q1, q2, q3, q4, the paper's execution order; where"
        " none does, the state stays.",
    )


def _paint(figure: Figure, found: tuple[_Transition, ...]) -> None:
    axes = figure.subplots()
    for state, (x, y) in _PLACES.items():
        axes.add_patch(
            Ellipse(
                (x, y),
                _WIDTH,
                _HEIGHT,
                facecolor=LIGHT.card,
                edgecolor=LIGHT.accent,
                linewidth=1.6,
                zorder=3,
            )
        )
        axes.text(x, y, state.value, ha="center", va="center", fontsize=9.5, zorder=4)
    for state, target, names in found:
        if state is target:
            _loop(axes, state, names)
        else:
            _arrow(axes, state, target, names)
    axes.set_xlim(-6.5, 6.5)
    axes.set_ylim(-4.7, 4.5)
    axes.set_aspect("equal")
    axes.axis("off")


_BEND = 0.085
"""Bend of an arrow as a share of its length."""
_LABEL_AT = 0.42
"""Position of an arrow's label as a share of its length."""
_ON_WHITE = {"facecolor": "white", "edgecolor": "none", "pad": 1.2}


def _arrow(axes: Any, state: Behavior, target: Behavior, names: tuple[str, ...]) -> None:
    (x0, y0), (x1, y1) = _PLACES[state], _PLACES[target]
    start, end = _rim((x0, y0), (x1, y1), 0.2), _rim((x1, y1), (x0, y0), -0.2)
    style = "Simple, tail_width=0.6, head_width=5, head_length=7"
    axes.add_patch(
        FancyArrowPatch(
            start,
            end,
            connectionstyle=f"arc3,rad={_BEND}",
            arrowstyle=style,
            color=LIGHT.ink,
            linewidth=0.5,
            zorder=2,
        )
    )
    bend = (
        0.5 * (start[0] + end[0]) + _BEND * (end[1] - start[1]),
        0.5 * (start[1] + end[1]) - _BEND * (end[0] - start[0]),
    )
    # Close to the start of the arrow, clear of the label of the opposite arrow.
    x, y = (
        (1 - _LABEL_AT) ** 2 * a + 2 * _LABEL_AT * (1 - _LABEL_AT) * c + _LABEL_AT**2 * b
        for a, b, c in zip(start, end, bend, strict=True)
    )
    axes.text(
        x,
        y,
        ", ".join(names),
        ha="center",
        va="center",
        fontsize=9,
        color=LIGHT.accent,
        bbox=_ON_WHITE,
        zorder=5,
    )


def _rim(
    centre: tuple[float, float], towards: tuple[float, float], turn: float
) -> tuple[float, float]:
    """Return the point of an ellipse in a direction, turned a little to separate two arrows."""
    angle = atan2(towards[1] - centre[1], towards[0] - centre[0]) - turn
    reach = 1.0 / hypot(cos(angle) / (0.5 * _WIDTH), sin(angle) / (0.5 * _HEIGHT))
    return centre[0] + 1.06 * reach * cos(angle), centre[1] + 1.06 * reach * sin(angle)


def _loop(axes: Any, state: Behavior, names: tuple[str, ...]) -> None:
    x, y = _PLACES[state]
    up = 1.0 if y > 0.0 else -1.0
    angles = (pi / 2 + 0.35, pi / 2 - 0.35)
    ends = [(x + 0.5 * _WIDTH * cos(a), y + up * 0.5 * _HEIGHT * sin(a) * 1.02) for a in angles]
    style = "Simple, tail_width=0.6, head_width=5, head_length=7"
    rad = -1.5 if up > 0 else 1.5
    axes.add_patch(
        FancyArrowPatch(
            *ends,
            connectionstyle=f"arc3,rad={rad}",
            arrowstyle=style,
            color=LIGHT.thing_edge,
            linewidth=0.5,
            zorder=2,
        )
    )
    axes.text(
        x,
        y + up * (0.5 * _HEIGHT + 0.72),
        ", ".join(names),
        ha="center",
        va="center",
        fontsize=9,
        color=LIGHT.quiet,
    )
