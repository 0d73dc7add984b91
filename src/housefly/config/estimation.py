"""What the estimator works out in flight, besides where the drone is."""

from __future__ import annotations

from pydantic import Field

from housefly.config.section import Section, quantity


class EstimationConfig(Section):
    """Disturbances, delays and gains found in flight; mode paper has none of it."""

    disturbance_wander: float = quantity(
        0.7,
        0.0,
        2.0,
        "m/s^2 per sqrt(s)",
        "how fast a push in the plane (draught, gust, bent frame) may change; 0 knows of none",
    )
    lift_wander: float = quantity(
        0.5,
        0.0,
        5.0,
        "m/s^2 per sqrt(s)",
        "how fast a push up or down (load, updraught) may change; 0 knows of none",
    )
    climb_noise: float = quantity(
        0.1, 0.001, 5.0, "m/s^1.5", "unmodelled vertical acceleration; counts with lift_wander"
    )
    delay_compensated: bool = Field(
        default=True, description="false: as if commands acted at once; for comparisons"
    )
    delay_deviation: float = quantity(
        0.05,
        0.0,
        0.2,
        "s",
        "one sigma by which drone.command_delay may be wrong: it is found in flight; 0 believes it",
    )
    aims_upwind: bool = Field(
        default=True,
        description=(
            "a steered landing aims against the draught by what the drone's own last bit will drift"
        ),
    )
    mistrust: float = quantity(
        0.3,
        0.0,
        1.0,
        "1",
        "share by which delays and lag may be wrong: with slow or late tracking the gains alpha and"
        " beta are lowered to what bears that; 0 leaves them",
    )


ONLY_LEVEL_PUSHES = EstimationConfig(
    disturbance_wander=0.2,
    lift_wander=0.0,
    delay_deviation=0.0,
    aims_upwind=False,
    mistrust=0.0,
)
"""Nothing is found in flight but a slow push in the plane."""
