"""Whether an order may be obeyed: one table of checks, each with the words for a refusal."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import isfinite

from housefly.config.limits import LimitsConfig
from housefly.messages.flight import Order, OrderKind, OrderOutcome
from housefly.messages.order_fault import order_fault
from housefly.messages.sensing import DroneStatus
from housefly.messages.words import Words, figure, percentage, said
from housefly.pilot.behavior.mission import UNHEARD, Refused, VehicleStatus
from housefly.pilot.behavior.mission_tables import REFUSALS, Response

ORDER_LIFETIME = 0.5
"""Orders that move the drone or release a latch expire after this [s]: nothing old is done late."""
HEIGHT_ERROR_MAX = 0.3
"""Tracking may see a drone that stands this far from the floor [m]."""
MOVED_ON_GROUND_MAX = 0.15
"""Tracking may move a drone that stands by this [m]."""
TAKE_OFF_RESERVE = 0.05
"""No take-off below the battery floor plus this share."""
EXPIRING_ORDERS = frozenset(
    {
        OrderKind.TAKE_OFF,
        OrderKind.GO,
        OrderKind.SERVICE,
        OrderKind.HOME,
        OrderKind.RESUME,
        OrderKind.RESET,
        OrderKind.NUDGE,
    }
)
"""Orders that expire; HOVER, LAND, STOP and CUT make things safer and never do."""
MOVING_RESPONSES = frozenset({Response.START, Response.LATER, Response.DEPART, Response.NUDGE})
"""Responses that set the drone in motion."""


@dataclass(frozen=True, slots=True)
class OrderContext:
    """What a permission depends on.

    Attributes:
        age: time since the order was given [s].
        response: what the table of orders says.
        stopped: STOP is latched.
        landing_forced: the safety gate is landing the drone.
        status: the drone's own word.
        battery: charge, 0 to 1.
        telemetry_age, pose_age: [s].
        vehicle: the rest of what is known of the drone.
    """

    age: float
    response: Response
    stopped: bool
    landing_forced: bool
    status: DroneStatus
    battery: float
    telemetry_age: float
    pose_age: float
    vehicle: VehicleStatus = UNHEARD


OrderCheck = tuple[
    OrderOutcome,
    Callable[[Order, OrderContext, LimitsConfig], bool],
    Callable[[OrderContext, LimitsConfig], Words],
]

ORDER_CHECKS: tuple[OrderCheck, ...] = (
    (
        OrderOutcome.EXPIRED,
        lambda o, c, _: o.kind in EXPIRING_ORDERS and not abs(c.age) <= ORDER_LIFETIME,
        lambda c, _: Words(
            "the order is {n} s old; orders expire after {m} s",
            n=figure(c.age, ".1f"),
            m=figure(ORDER_LIFETIME),
        ),
    ),
    (
        OrderOutcome.WRONG_PHASE,
        lambda _, c, __: c.response in REFUSALS,
        lambda c, _: said(c.response),
    ),
    (
        OrderOutcome.NO_EMERGENCY,
        lambda o, c, _: c.response is Response.RESET and c.status is not DroneStatus.EMERGENCY,
        lambda c, _: Words(
            "there is no emergency to leave: the drone is {what}", what=said(c.status)
        ),
    ),
    (
        OrderOutcome.STOPPED,
        lambda _, c, __: c.response in MOVING_RESPONSES and c.stopped,
        lambda _, __: Words("STOP is latched: resume first"),
    ),
    (
        OrderOutcome.SAFETY,
        lambda _, c, __: c.response in MOVING_RESPONSES and c.landing_forced,
        lambda _, __: Words("the drone is being landed for safety"),
    ),
    (
        OrderOutcome.SAFETY,
        lambda o, c, _: (
            c.response in MOVING_RESPONSES
            and c.vehicle.return_wanted
            and o.kind is not OrderKind.HOME
        ),
        lambda _, __: Words("the drone is coming home for safety"),
    ),
    (
        OrderOutcome.DRONE_SILENT,
        lambda _, c, limits: (
            c.response in MOVING_RESPONSES and c.telemetry_age > limits.telemetry_age
        ),
        lambda _, __: Words("the drone does not answer"),
    ),
    (
        OrderOutcome.DRONE_NOT_READY,
        lambda _, c, __: c.response is Response.START and c.status is not DroneStatus.LANDED,
        lambda c, _: Words("the drone is not ready: {what}", what=said(c.status)),
    ),
    (
        OrderOutcome.DRONE_NOT_READY,
        lambda _, c, __: c.response is Response.START and c.vehicle.configured is False,
        lambda _, __: Words(
            "the drone has not confirmed its limits yet: wait, or switch it off and on"
        ),
    ),
    (
        OrderOutcome.DRONE_FAULT,
        lambda _, c, __: c.response is Response.START and c.vehicle.grounding_faults != "",
        lambda c, _: Words("the drone says: {what}", what=c.vehicle.grounding_faults),
    ),
    (
        OrderOutcome.UNTRACKED,
        lambda _, c, __: (
            c.response is Response.START and abs(c.vehicle.height_error) > HEIGHT_ERROR_MAX
        ),
        lambda c, _: Words(
            "tracking sees the drone {d} m from where it stands (limit {m} m): check the tracking"
            " system's origin and the drone's body",
            d=figure(c.vehicle.height_error, "+.2f"),
            m=figure(HEIGHT_ERROR_MAX),
        ),
    ),
    (
        OrderOutcome.BATTERY,
        lambda _, c, limits: (
            c.response is Response.START
            and not c.battery >= limits.battery_floor + TAKE_OFF_RESERVE
        ),
        lambda c, limits: Words(
            "the battery is too low: {p}%, take-off needs {q}%",
            p=percentage(c.battery),
            q=percentage(limits.battery_floor + TAKE_OFF_RESERVE),
        ),
    ),
    (
        OrderOutcome.UNTRACKED,
        lambda _, c, limits: c.response in MOVING_RESPONSES and c.pose_age > limits.pose_age_level,
        lambda c, limits: _unseen(c.pose_age, limits.pose_age_level),
    ),
)
"""Rules in order of what to say first: (what is told, is it forbidden, why)."""


def _unseen(pose_age: float, limit: float) -> Words:
    """Return why nothing moves: the drone was never seen, or how old the newest pose is [s]."""
    if not isfinite(pose_age):
        return Words("tracking does not see the drone")
    return Words(
        "tracking shows the drone as it was {n} s ago (limits.pose_age_level: {m} s);"
        " housefly gains says which limit slow tracking needs",
        n=figure(pose_age, ".2f"),
        m=figure(limit, "g"),
    )


def refusal(order: Order, context: OrderContext, limits: LimitsConfig) -> Refused | None:
    """Return why an order may not be obeyed, or None when it may."""
    if fault := order_fault(order):
        return Refused(OrderOutcome.WRONG_VALUE, fault)
    for outcome, forbidden, reason in ORDER_CHECKS:
        if forbidden(order, context, limits):
            return Refused(outcome, reason(context, limits))
    return None
