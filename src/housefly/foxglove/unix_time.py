"""A pilot's step in Unix time: Foxglove joins what has one clock, and shows when it was."""

from __future__ import annotations

from dataclasses import replace

from housefly.messages import PilotStep


def in_unix_time(step: PilotStep, offset: float) -> PilotStep:
    """Return a step with every stamp that is shown moved on.

    Args:
        step: on the monotonic clock.
        offset: Unix time at which that clock was zero [s].
    """
    telemetry, outputs = step.inputs.telemetry, step.outputs
    estimate = outputs.estimate
    return replace(
        step,
        now=step.now + offset,
        inputs=replace(
            step.inputs,
            sightings=(),  # each has a topic of its own, from the frames of the tracking system
            telemetry=telemetry and replace(telemetry, received_at=telemetry.received_at + offset),
        ),
        outputs=replace(
            outputs,
            estimate=estimate and replace(estimate, at=estimate.at + offset),
            events=tuple(replace(event, at=event.at + offset) for event in outputs.events),
        ),
    )
