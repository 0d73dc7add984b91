"""What a flight tells the room: where the tracked bodies are, and what the pilot did, from the
steps that it publishes.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from housefly.messages import Estimate, Happening, Observation, Phase, PilotStep, Sighting

PILOT = "pilot"
"""Source of what the pilot says."""
BEGINNINGS = {
    Phase.TAKING_OFF: "flight started",
    Phase.LOOKING: "looking",
    Phase.IDLE: "flight ended",
}
"""Phases that are worth remembering when they begin."""


class FlightFacts:
    """Turns steps into observations and happenings.

    Args:
        drone: id of the drone, the name of its tracked body.
        tracking: id of the tracking system.
        things: ids of things by the names of their tracked bodies; other bodies are called by their
            names.
    """

    def __init__(self, drone: str, tracking: str, things: Mapping[str, str]) -> None:
        self._drone, self._tracking, self._things = drone, tracking, things
        self._phase: Phase | None = None

    def after(self, step: PilotStep, unix: float) -> Iterator[Observation | Happening]:
        """Return what a step tells.

        Args:
            step: of the pilot.
            unix: Unix time at which the pilot's clock stood at zero [s].
        """
        for sighting in step.inputs.sightings:
            yield self._seen(sighting, unix)
        estimate = step.outputs.estimate
        if estimate is not None and step.sequence % 10 == 0:
            yield self._believed(estimate, unix)
        yield from self._phases(step, unix)
        for event in step.outputs.events:
            facts = (("code", event.code), ("severity", event.severity.value))
            yield Happening(event.text[:200], self._drone, unix + event.at, PILOT, facts=facts)

    def _seen(self, sighting: Sighting, unix: float) -> Observation:
        return Observation(
            self._things.get(sighting.body, sighting.body),
            self._tracking,
            unix + sighting.captured_at,
            unix + sighting.received_at,
            sighting.pose.position,
            sighting.pose.orientation,
        )

    def _believed(self, estimate: Estimate, unix: float) -> Observation:
        variance = estimate.position_std**2
        at = unix + estimate.at
        covariance = (variance, 0.0, 0.0, variance, 0.0, variance)
        return Observation(self._drone, PILOT, at, at, estimate.position, covariance=covariance)

    def _phases(self, step: PilotStep, unix: float) -> Iterator[Happening]:
        phase, before = step.outputs.phase, self._phase
        self._phase = phase
        if before is None or phase is before or phase not in BEGINNINGS:
            return
        facts = (("goal", step.outputs.goal_name),) if step.outputs.goal_name else ()
        sender = next((order.sender for order in step.inputs.orders), "")
        yield Happening(BEGINNINGS[phase], self._drone, unix + step.now, PILOT, sender, facts=facts)
