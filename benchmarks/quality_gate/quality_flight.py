"""One flight of the gate: the simulated room, the pilot, and what it truly did."""

from __future__ import annotations

from math import floor

from housefly.geometry import yaw_of
from housefly.lab.lockstep.simulation import Simulation
from housefly.messages import EventCode, Order, OrderKind, Phase, PilotStep, Severity
from housefly.pilot.assembly import make_pilot
from housefly.sites.loaded_site import LoadedSite
from housefly.twin.disturbance import NEUTRAL, Disturbances
from quality_gate.flown_track import FlownTrack

SENDER = "flight quality"
_SETTLING = 0.5
"""World time before the first order, so that tracking and telemetry are there [s]."""
_RISE_TIMEOUT, _RISE_SETTLING = 20.0, 2.0
"""A take-off is given up after this; what follows waits until the height has settled [s]."""


class QualityFlight:
    """A drone that takes off and is watched.

    Args:
        loaded: the site of the world, and of the pilot if it has no other.
        believed: the site of the pilot; None for the same.
        weather: what disturbs the drone once it hovers.
        gap_every, gap: tracking is lost so often, for so long [s]; 0 for never.

    Attributes:
        simulation: the room and its pilot.
        track: what it did so far.
        no_hover: why it does not hover, or "".
        refusal: why the last order was refused, or "".
    """

    def __init__(
        self,
        loaded: LoadedSite,
        believed: LoadedSite | None = None,
        weather: Disturbances = NEUTRAL,
        gap_every: float = 0.0,
        gap: float = 0.0,
    ) -> None:
        self.simulation = Simulation(loaded)
        if believed is not None:
            self.simulation.pilot = make_pilot(believed.site, loaded.room, believed.grid)
        self.track = FlownTrack()
        self.no_hover = self.refusal = ""
        self._weather, self._gap_every, self._gap, self._gaps = weather, gap_every, gap, 0
        self._trouble = ""

    @property
    def now(self) -> float:
        """World time [s]."""
        return self.simulation.now

    @property
    def contacts(self) -> tuple[str, ...]:
        """What the drone touched with its motors turning."""
        log = self.simulation.world.contact_log
        return tuple(dict.fromkeys(c.name for c in log if c.motors_turned))

    def rise(self) -> bool:
        """Take off, hover, and let the weather begin; return whether it hovers."""
        self.wait(_SETTLING)
        self.tick(Order(OrderKind.TAKE_OFF, sender=SENDER))
        self.no_hover = self.until(Phase.HOLDING, _RISE_TIMEOUT, Phase.LANDING)
        self.begin_weather()
        self.wait(_RISE_SETTLING)
        return not self.no_hover

    def begin_weather(self) -> None:
        """Disturb the drone from now on."""
        self.simulation.world.disturb(self._weather)

    def wait(self, seconds: float) -> None:
        """Let time pass."""
        end = self.now + seconds
        while self.now < end:
            self.tick()

    def until(self, phase: Phase, patience: float, *failed: Phase) -> str:
        """Fly until the mission is in a phase; return "" or why it is not.

        Args:
            phase: wanted.
            patience: longest time [s].
            failed: phases in which it will not come any more; none for on the ground.
        """
        end, lost = self.now + patience, failed or (Phase.IDLE, Phase.LANDING)
        while self.now < end:
            reached = self.tick().outputs.phase
            if reached is phase:
                return ""
            if reached in lost:
                return self._trouble or reached.value
        return f"not {phase.value} after {patience:.0f} s" + f": {self._trouble}".rstrip(": ")

    def tick(self, *orders: Order) -> PilotStep:
        """Fly one period; orders are given now."""
        simulation = self.simulation
        if orders:
            self._trouble = self.refusal = ""
        simulation.advance()
        self._lose_tracking()
        step = simulation.step(simulation.inputs(*orders))
        for event in step.outputs.events:
            # "landing for safety" follows the reason for it.
            if event.severity is not Severity.INFO and event.code is not EventCode.FORCED_DOWN:
                self._trouble = event.text
            if event.code is EventCode.ORDER_REFUSED:
                self.refusal = event.text
        self.track.add(simulation.world, step, yaw_of(simulation.world.truth().pose.orientation))
        return step

    def _lose_tracking(self) -> None:
        if self._gap_every and floor(self.now / self._gap_every) > self._gaps:
            self._gaps = floor(self.now / self._gap_every)
            self.simulation.inject(f"mocap:off@{self.now + 0.01:.3f}s+{self._gap:.3f}s")
