"""Flies one service in lock step with a fault in it, and judges it on the truth."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
from math import isfinite, nan

import numpy as np

from housefly.config.site import changed
from housefly.lab.lockstep.simulation import Simulation
from housefly.lab.safety_case.fault_phase import IN_FLIGHT_FAULT_PHASES, FaultPhase, has_begun
from housefly.lab.safety_case.oracle import Oracle
from housefly.lab.safety_case.trial import PersonOrder, TrialKey, TrialResult
from housefly.messages import Inputs, Order, OrderKind, PilotStep
from housefly.sites.loaded_site import LoadedSite, load_site
from housefly.twin.demo_site import demo_changes
from housefly.twin.faults.catalogue import row_of
from housefly.twin.faults.fault import Fault
from housefly.twin.faults.fault_row import FaultVariant
from housefly.twin.faults.vocabulary import FaultComponent, FaultKind

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


_SERVICE = Order(OrderKind.SERVICE, place=SAFETY_PLACE, look_s=_LOOK_TIME, sender="safety case")


_PERSON = "a person"
_ORDER_SPAN = (0.2, 3.0)
"""A person gives an order so long after the fault began [s]."""
_ORDERS: dict[PersonOrder, tuple[tuple[float, Order], ...]] = {
    PersonOrder.NOTHING: (),
    PersonOrder.STOP: (
        (0.0, Order(OrderKind.STOP, sender=_PERSON)),
        (8.0, Order(OrderKind.LAND, sender=_PERSON)),
    ),
    PersonOrder.LAND: ((0.0, Order(OrderKind.LAND, sender=_PERSON)),),
    PersonOrder.RESUME: (
        (0.0, Order(OrderKind.STOP, sender=_PERSON)),
        (8.0, Order(OrderKind.RESUME, sender=_PERSON)),
        (9.0, Order(OrderKind.LAND, sender=_PERSON)),
    ),
    PersonOrder.DEAD_PILOT: (),
}
"""What a person orders, and how long after the first order [s]; a landing ends each flight."""


@lru_cache(maxsize=2)
def _base(scanned: bool, model: str = "") -> LoadedSite:
    """Return the room, with its scanners where people and things may get in the way."""
    lasers = demo_changes()["lasers"] if scanned else ()
    drone = {"drone__kind": model} if model else {}
    return load_site(SAFETY_SITE, hub__enabled=False, lasers=lasers, **drone)


@dataclass(frozen=True, slots=True)
class FlightCourse:
    """What flights have in common that are alike until their faults begin.

    Attributes:
        seed: of everything random.
        rate_hz: of the tracking system.
        has_intruders: whether people and things may get in the way.
        scanned: whether the room has its scanners.
        guarded: with its guards, else the negative control.
        model: of the drone; "" is the room's own.
    """

    seed: int
    rate_hz: float
    has_intruders: bool
    scanned: bool
    guarded: bool
    model: str = ""


@dataclass(frozen=True, slots=True)
class FaultOnset:
    """When the fault of a flight begins: so long after a phase was reached [s]."""

    phase: FaultPhase
    delay: float


def course_of(key: TrialKey) -> FlightCourse:
    """Return the course of a flight."""
    phases = _phases_of(key.row)
    rate = _RATES_HZ[(key.seed // len(phases)) % len(_RATES_HZ)]
    return FlightCourse(
        key.seed,
        rate,
        _needs_intruders(key.row),
        needs_scanners(key.row),
        key.guarded,
        key.model,
    )


def onset_of(key: TrialKey) -> FaultOnset:
    """Return when the fault of a flight begins."""
    rng = np.random.default_rng([key.seed, sum(map(ord, key.row))])
    phases = _phases_of(key.row)
    phase = phases[key.seed % len(phases)]
    delay = float(rng.uniform(0.0, _DELAY_MAX)) if phase in IN_FLIGHT_FAULT_PHASES else 0.0
    return FaultOnset(phase, delay)


def fly_trial(key: TrialKey) -> TrialResult:
    """Fly one flight of the safety case and return how it ended."""
    flight, onset = FaultyFlight(course_of(key)), onset_of(key)
    while not (flight.is_over or flight.is_due(onset)):
        flight.advance()
    return flight.result(key) if flight.is_over else flight.finish(key)


def variant_of(name: str) -> FaultVariant:
    """Return the variant named ``F13/2cm``, or the first of ``F13``; raises ConfigError."""
    number, _, wanted = name.partition("/")
    row = row_of(number)
    row.faults_of(wanted)  # refuses a row or a variant that there is not
    return next(v for v in row.variants if wanted in ("", v.name))


def _faults_of_key(key: TrialKey) -> tuple[Fault, ...]:
    """Return the faults of a flight, from 0 s on, each with the seed of the flight."""
    return tuple(
        replace(fault, seed=1 + key.seed)
        for name in key.row.split("+")
        if name
        for fault in variant_of(name).faults
    )


def _with_dead_pilot(faults: tuple[Fault, ...], key: TrialKey) -> tuple[Fault, ...]:
    if key.order is not PersonOrder.DEAD_PILOT:
        return faults
    return (*faults, Fault(FaultComponent.PILOT, FaultKind.OFF, start=_ordered_after(key)))


def _phases_of(row: str) -> tuple[FaultPhase, ...]:
    """Return the phases in which a row may begin; a row without faults begins before take-off."""
    names = [name for name in row.split("+") if name]
    if not names:
        return (FaultPhase.BEFORE_TAKE_OFF,)
    if any(variant_of(name).from_start for name in names):
        return (FaultPhase.FROM_START,)
    return (FaultPhase.BEFORE_TAKE_OFF, *IN_FLIGHT_FAULT_PHASES)


def _needs_intruders(row: str) -> bool:
    """Return whether a row puts people or things in the way."""
    intruders = (FaultComponent.PEOPLE, FaultComponent.OBSTACLES)
    return any(fault.component in intruders for fault in _faults_of_key(TrialKey(row, 0)))


def needs_scanners(row: str) -> bool:
    """Return whether a row is flown in a room with scanners, which see what gets in the way."""
    unscanned = any(variant_of(name).unscanned for name in row.split("+") if name)
    faults = _faults_of_key(TrialKey(row, 0))
    fails = any(fault.component is FaultComponent.LASER for fault in faults)
    return fails or (_needs_intruders(row) and not unscanned)


def orders_of(key: TrialKey) -> tuple[tuple[float, Order], ...]:
    """Return what a person orders, and how long after the fault began [s]."""
    begun = _ordered_after(key)
    return tuple((begun + after, order) for after, order in _ORDERS[key.order])


def _ordered_after(key: TrialKey) -> float:
    rng = np.random.default_rng([key.seed, sum(map(ord, key.row)), len(PersonOrder)])
    return float(rng.uniform(*_ORDER_SPAN))


def _cannot_hover(row: str) -> bool:
    return any(variant_of(name).cannot_hover for name in row.split("+") if name)


class FaultyFlight:
    """One service, into which faults come."""

    def __init__(self, course: FlightCourse) -> None:
        base = _base(course.scanned, course.model)
        site = changed(base.site, twin__seed=1 + course.seed, twin__mocap_rate_hz=course.rate_hz)
        self._guarded = course.guarded
        self._simulation = Simulation(
            replace(base, site=site), intruders=course.has_intruders, guarded=course.guarded
        )
        self._oracle = Oracle(self._simulation.world, site, base.room)
        self._reached: dict[FaultPhase, float] = {}
        self._ordered_at: float | None = None
        self._waiting: list[tuple[float, Order]] = []
        self._last: PilotStep | None = None

    @property
    def is_over(self) -> bool:
        """Whether it has ended, or is given up; a negative control ends once it did harm."""
        if self._last is None or self._ordered_at is None:
            return False
        if self._oracle.violations and not self._guarded:
            return True
        begun = self._simulation.now > _ORDER_AT + 1.0
        return self._is_late or (begun and self._oracle.ended(self._last))

    def advance(self) -> None:
        """Fly on for one period of the pilot."""
        simulation = self._simulation
        simulation.advance()
        orders: tuple[Order, ...] = ()
        if self._ordered_at is None and simulation.now >= _ORDER_AT:
            orders, self._ordered_at = (_SERVICE,), simulation.now
        while self._waiting and simulation.now >= self._waiting[0][0]:
            orders = (*orders, self._waiting.pop(0)[1])
        inputs = simulation.inputs(*orders)
        self._last = simulation.step(inputs if self._guarded else _blind(inputs))
        self._oracle.watch(self._last)

    def is_due(self, onset: FaultOnset) -> bool:
        """Return whether a fault with this onset begins now; to be asked after every period."""
        step, phase = self._last, onset.phase
        if step is None:
            return phase is FaultPhase.FROM_START
        if phase not in self._reached and (step.now > _REACH_TIMEOUT or has_begun(phase, step)):
            self._reached[phase] = step.now
        return phase in self._reached and step.now >= self._reached[phase] + onset.delay

    def finish(self, key: TrialKey, faults: tuple[Fault, ...] | None = None) -> TrialResult:
        """Let faults begin, those of the row unless given; fly on, and return how it ended."""
        now = 0.0 if self._last is None else self._last.now
        self._oracle.faulty_since, self._oracle.cannot_hover = now, _cannot_hover(key.row)
        faults = _faults_of_key(key) if faults is None else faults
        faults = _with_dead_pilot(faults, key)
        self._waiting = [(now + after, order) for after, order in orders_of(key)]
        self._simulation.inject(*(fault.shifted(now) for fault in faults))
        while not self.is_over:
            self.advance()
        return self.result(key)

    def result(self, key: TrialKey) -> TrialResult:
        """Return how a flight has ended."""
        assert self._last is not None
        oracle, began = self._oracle, self._oracle.faulty_since
        ending = oracle.conclude(self._last, self._is_late)
        return TrialResult(
            key=key,
            phase=onset_of(key).phase,
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

    @property
    def _is_late(self) -> bool:
        since = self._simulation.now - self._oracle.faulty_since
        return isfinite(since) and since > PATIENCE


def _blind(inputs: Inputs) -> Inputs:
    """Return the inputs of a pilot that sees nothing but the drone, hears no sonar, and asks for
    no pad.
    """
    body, told = _base(False).site.tracking.body, inputs.telemetry
    return replace(
        inputs,
        sightings=tuple(s for s in inputs.sightings if s.body == body),
        obstacles=(),
        telemetry=None if told is None else replace(told, height=nan),
        origin_known=True,
    )


def _finite(number: float) -> float | None:
    return number if isfinite(number) else None
