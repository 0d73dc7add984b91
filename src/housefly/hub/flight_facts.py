"""Turns the pilot's steps into observations and events of the room."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from housefly.messages import Estimate, Observation, Phase, PilotStep, RoomEvent, Sighting

PILOT = "pilot"
"""Source of what the pilot reports."""
_PHASE_EVENTS = {
    Phase.TAKING_OFF: "flight started",
    Phase.LOOKING: "looking",
    Phase.IDLE: "flight ended",
}
"""Phases whose beginning is an event."""


class FlightFacts:
    """Turns steps into observations and events.

    Args:
        drone: id of the drone, the name of its tracked body.
        tracking: id of the tracking system.
        things: ids of things by tracked body; other bodies keep their names as ids.
    """

    def __init__(self, drone: str, tracking: str, things: Mapping[str, str]) -> None:
        self._drone, self._tracking, self._things = drone, tracking, things
        self._phase: Phase | None = None

    def items_of(self, step: PilotStep, unix: float) -> Iterator[Observation | RoomEvent]:
        """Yield the observations and events of a step.

        Args:
            step: of the pilot.
            unix: Unix time at which the pilot's clock was zero [s].
        """
        estimate = step.outputs.estimate
        if estimate is not None and step.sequence % 10 == 0:
            yield self._estimated(estimate, unix)
        yield from self._phases(step, unix)
        for event in step.outputs.events:
            facts = (("severity", event.severity.value), ("words", event.text))
            kind = event.code.replace("_", " ")
            yield RoomEvent(kind, self._drone, unix + event.at, PILOT, facts=facts)

    def seen(self, sighting: Sighting, unix: float) -> Observation:
        """Return a sighting as an observation; ``unix`` as above."""
        return Observation(
            self._things.get(sighting.body, sighting.body),
            self._tracking,
            unix + sighting.captured_at,
            unix + sighting.received_at,
            sighting.pose.position,
            sighting.pose.orientation,
        )

    def _estimated(self, estimate: Estimate, unix: float) -> Observation:
        variance = estimate.position_std**2
        at = unix + estimate.at
        covariance = (variance, 0.0, 0.0, variance, 0.0, variance)
        return Observation(self._drone, PILOT, at, at, estimate.position, covariance=covariance)

    def _phases(self, step: PilotStep, unix: float) -> Iterator[RoomEvent]:
        phase, before = step.outputs.phase, self._phase
        self._phase = phase
        if before is None or phase is before or phase not in _PHASE_EVENTS:
            return
        facts = (("goal", step.outputs.goal_name),) if step.outputs.goal_name else ()
        sender = next((order.sender for order in step.inputs.orders), "")
        yield RoomEvent(
            _PHASE_EVENTS[phase], self._drone, unix + step.now, PILOT, sender, facts=facts
        )
