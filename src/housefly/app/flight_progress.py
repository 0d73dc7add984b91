"""The progress display of a headless flight: one line with the drone's position and phase."""

from __future__ import annotations

from rich.progress import BarColumn, TextColumn, TimeElapsedColumn

from housefly.app.terminal import ProgressDisplay, console
from housefly.lab.lockstep.service_monitor import STAGES
from housefly.messages import Phase, PilotStep

_REFRESH_PERIOD = 0.1
"""Flight time between two updates of the line [s]."""


class FlightProgress(ProgressDisplay):
    """Shows phase, height, distance flown along the path, battery; prints events as they happen."""

    def __init__(self) -> None:
        super().__init__(
            TextColumn("{task.description:<16}"),
            BarColumn(24),
            TextColumn("{task.fields[note]}"),
            TimeElapsedColumn(),
        )
        self._task = self._progress.add_task("starting", total=len(STAGES), note="")
        self._shown_at = float("-inf")
        self._phase = Phase.IDLE

    def say(self, text: str) -> None:
        """Show a note while nothing flies yet."""
        self._progress.update(self._task, note=text)

    def show(self, step: PilotStep) -> None:
        """Show one step of the pilot."""
        for event in step.outputs.events:
            console.print(f"  {event.severity.value:<8}{event.text}", markup=False)
        phase = step.outputs.phase
        if phase is self._phase and step.now - self._shown_at < _REFRESH_PERIOD:
            return
        self._phase, self._shown_at = phase, step.now
        done = STAGES.index(phase) if phase in STAGES else None
        self._progress.update(self._task, description=phase.value, completed=done, note=_note(step))


def _note(step: PilotStep) -> str:
    estimate, telemetry = step.outputs.estimate, step.inputs.telemetry
    where = (
        "({:5.2f}, {:5.2f}, {:4.2f}) m".format(*estimate.position) if estimate else "not seen yet"
    )
    battery = f"  battery {telemetry.battery:4.0%}" if telemetry else ""
    safety = step.outputs.safety.value
    return f"{where}{battery}" + (f"  {safety}" if safety != "nominal" else "")
