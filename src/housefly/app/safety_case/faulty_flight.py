"""Flies one service in lock step with a fault in it, and judges it on the truth."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from math import isfinite, nan

import numpy as np

from housefly.app.lively import lively_changes
from housefly.app.loaded_site import LoadedSite, load_site
from housefly.app.public.simulation import Simulation
from housefly.app.safety_case.fault_phase import IN_FLIGHT_FAULT_PHASES, FaultPhase, has_begun
from housefly.app.safety_case.oracle import Oracle
from housefly.app.safety_case.trial import TrialKey, TrialResult
from housefly.config.site import changed
from housefly.messages import Inputs, Order, OrderKind, PilotStep
from housefly.twin.faults.catalogue import FaultVariant, row_of
from housefly.twin.faults.fault import Fault
from housefly.twin.faults.vocabulary import FaultComponent

SAFETY_SITE = "bsen"
SAFETY_PLACE = "table"
_LOOK_TIME = 3.0
_ORDER_AT = 0.5
_RATES_HZ = (100.0, 30.0, 10.0)
_DELAY_MAX = 1.5
"""A fault begins up to this long after its phase was reached [s]."""
PATIENCE = 90.0
"""A flight has to end this long after its fault began [s]: a service of 35 s, and a wait of 20 s
for a blocked way on each of its legs.
"""
_REACH_TIMEOUT = 60.0
"""A phase that is not reached within this is left out: the fault begins where the drone is [s]."""


@lru_cache(maxsize=2)
def _base(scanned: bool) -> LoadedSite:
    """Return the room, with its scanners where people and things may get in the way."""
    lasers = lively_changes()["lasers"] if scanned else ()
    return load_site(SAFETY_SITE, hub__enabled=False, lasers=lasers)


def fly_trial(key: TrialKey) -> TrialResult:
    """Fly one flight of the safety case and return how it ended."""
    rng = np.random.default_rng([key.seed, sum(map(ord, key.row))])
    phases = phases_of(key.row)
    phase = phases[key.seed % len(phases)]
    rate = _RATES_HZ[(key.seed // len(phases)) % len(_RATES_HZ)]
    delay = float(rng.uniform(0.0, _DELAY_MAX)) if phase in IN_FLIGHT_FAULT_PHASES else 0.0
    base = _base(needs_intruders(key.row))
    site = changed(base.site, twin__seed=1 + key.seed, twin__mocap_rate_hz=rate)
    simulation = Simulation(
        replace(base, site=site), intruders=needs_intruders(key.row), guarded=key.guarded
    )
    oracle = Oracle(simulation.world, site, base.room, cannot_hover=_cannot_hover(key.row))
    flight = _Flight(simulation, oracle, key, phase, delay)
    step, expired = flight.fly()
    began, ending = oracle.faulty_since, oracle.conclude(step, expired)
    return TrialResult(
        key=key,
        phase=phase,
        violations=tuple(oracle.violations.values()),
        ending=ending,
        told_after=None if oracle.told_at is None else oracle.told_at - began,
        safe_after=None if oracle.grounded_at is None else oracle.grounded_at - began,
        deviation=oracle.deviation,
        room_clearance=_finite(oracle.room_clearance),
        person_clearance=_finite(oracle.person_clearance),
        top_speed=oracle.top_speed,
        told=oracle.told,
        walked_into=oracle.walked_into,
    )


def variant_of(name: str) -> FaultVariant:
    """Return the variant named ``F13/2cm``, or the first of ``F13``."""
    number, _, wanted = name.partition("/")
    variants = row_of(number).variants
    return next((v for v in variants if v.name == wanted), variants[0])


def faults_of_key(key: TrialKey) -> tuple[Fault, ...]:
    """Return the faults of a flight, from 0 s on, each with the seed of the flight."""
    return tuple(
        replace(fault, seed=1 + key.seed)
        for name in key.row.split("+")
        if name
        for fault in variant_of(name).faults
    )


def phases_of(row: str) -> tuple[FaultPhase, ...]:
    """Return the phases in which a row may begin; a row without faults begins before take-off."""
    names = [name for name in row.split("+") if name]
    if not names or any(variant_of(name).from_start for name in names):
        return (FaultPhase.BEFORE_TAKE_OFF,)
    return tuple(FaultPhase)


def needs_intruders(row: str) -> bool:
    """Return whether a row puts people or things in the way."""
    intruders = (FaultComponent.PEOPLE, FaultComponent.OBSTACLES)
    return any(fault.component in intruders for fault in faults_of_key(TrialKey(row, 0)))


def _cannot_hover(row: str) -> bool:
    return any(variant_of(name).cannot_hover for name in row.split("+") if name)


class _Flight:
    """One service with faults that begin in a phase."""

    def __init__(
        self,
        simulation: Simulation,
        oracle: Oracle,
        key: TrialKey,
        phase: FaultPhase,
        delay: float,
    ) -> None:
        self._simulation, self._oracle = simulation, oracle
        self._faults, self._phase, self._delay = faults_of_key(key), phase, delay
        self._guarded = key.guarded
        self._reached_at: float | None = None

    def fly(self) -> tuple[PilotStep, bool]:
        """Fly until it has ended, and return the last step and whether it had not."""
        simulation, oracle, ordered = self._simulation, self._oracle, False
        order = Order(
            OrderKind.SERVICE, place=SAFETY_PLACE, look_s=_LOOK_TIME, sender="safety case"
        )
        while True:
            simulation.advance()
            orders: tuple[Order, ...] = ()
            if not ordered and simulation.now >= _ORDER_AT:
                orders, ordered = (order,), True
            inputs = simulation.inputs(*orders)
            step = simulation.step(inputs if self._guarded else _blind(inputs))
            oracle.watch(step)
            self._begin_when_due(step)
            since = simulation.now - oracle.faulty_since
            if ordered and simulation.now > _ORDER_AT + 1.0 and oracle.ended(step):
                return step, False
            if isfinite(since) and since > PATIENCE:
                return step, True

    def _begin_when_due(self, step: PilotStep) -> None:
        if isfinite(self._oracle.faulty_since):
            return
        late = step.now > _REACH_TIMEOUT
        if self._reached_at is None and (late or has_begun(self._phase, step)):
            self._reached_at = step.now
        if self._reached_at is None or step.now < self._reached_at + self._delay:
            return
        self._oracle.faulty_since = step.now
        self._simulation.inject(*(fault.shifted(step.now) for fault in self._faults))


def _blind(inputs: Inputs) -> Inputs:
    """Return the inputs of a pilot that sees nothing but the drone, and hears no sonar."""
    body, told = _base(False).site.tracking.body, inputs.telemetry
    return replace(
        inputs,
        sightings=tuple(s for s in inputs.sightings if s.body == body),
        obstacles=(),
        telemetry=None if told is None else replace(told, height=nan),
    )


def _finite(number: float) -> float | None:
    return number if isfinite(number) else None
