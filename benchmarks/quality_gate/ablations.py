"""What can be switched off, one thing at a time, to show what it is good for."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from quality_gate.scenario import Way


@dataclass(frozen=True, slots=True)
class Ablation:
    """One thing switched off by keys of the site.

    Attributes:
        name: for the table.
        changes: keys; a tree that does not know them does not offer this.
        way: of flying; None is the best that the tree offers.
    """

    name: str
    changes: dict[str, Any]
    way: Way | None = None


ABLATIONS: tuple[Ablation, ...] = (
    Ablation("nothing, as shipped", {}),
    Ablation(
        "all that is found in flight",
        {
            "estimation__disturbance_wander": 0.2,
            "estimation__lift_wander": 0.0,
            "estimation__delay_deviation": 0.0,
            "estimation__mistrust": 0.0,
        },
    ),
    Ablation("feed-forward", {"control__feed_forward": 0.0}),
    Ablation("delay compensation", {"estimation__delay_compensated": False}),
    Ablation("delay found in flight", {"estimation__delay_deviation": 0.0}),
    Ablation(
        "disturbance state",
        {"estimation__disturbance_wander": 0.0, "estimation__lift_wander": 0.0},
    ),
    Ablation("gain schedule", {"estimation__mistrust": 0.0}),
    # In space nothing waits for the heading; on corners the acceptor does.
    Ablation("nothing, on corners", {}, Way.GRID),
    Ablation("waiting for the heading, on corners", {"control__epsilon_yaw": 1.5}, Way.GRID),
)
