"""Faults and schedules of them: pure, seeded, checked."""

from __future__ import annotations

from math import hypot, inf, nan

import pytest
from fault_words import LEFT_OUT, fault_words
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import ConfigError
from housefly.twin.disturbance import Motor
from housefly.twin.faults.fault import Fault, FaultSchedule, seeded_uniform
from housefly.twin.faults.fault_types import FAULT_TYPES, fault_type
from housefly.twin.faults.parse import parse_fault
from housefly.twin.faults.vocabulary import FaultComponent, FaultKind, FaultType

MOCAP, OFF, WRONG = FaultComponent.MOCAP, FaultKind.OFF, FaultKind.WRONG
TIMES = st.floats(0.0, 1000.0)
TYPES = st.sampled_from(FAULT_TYPES)


@st.composite
def faults(draw: st.DrawFn) -> Fault:
    known = draw(TYPES)
    size = draw(st.none() | st.floats(known.low, known.high)) if known.unit else None
    lasting = draw(st.just(inf) | st.floats(0.01, 1000.0))
    seed = draw(st.integers(0, 2**31 - 1))
    return Fault(known.component, known.kind, known.aspect, draw(TIMES), lasting, size, seed)


@given(faults())
def test_a_fault_is_read_again_as_it_is_written(fault: Fault) -> None:
    (again,) = parse_fault(str(fault))
    assert again.type == fault.type
    assert again.seed == fault.seed
    assert again.start == pytest.approx(fault.start)
    assert again.size == pytest.approx(fault.size)
    assert again.end == pytest.approx(fault.end)


@given(faults(), TIMES)
def test_a_fault_is_there_from_its_start_to_before_its_end(fault: Fault, now: float) -> None:
    assert fault.is_active(now) == (fault.start <= now < fault.start + fault.duration)


@given(st.lists(faults(), max_size=6), TIMES)
def test_a_schedule_says_at_any_time_what_is_there_and_nothing_else(
    some: list[Fault], now: float
) -> None:
    schedule = FaultSchedule(tuple(some))
    assert schedule.active(now) == tuple(fault for fault in some if fault.is_active(now))
    assert all(
        fault.component is MOCAP and fault.is_active(now) for fault in schedule.active(now, MOCAP)
    )


def test_ok_ends_what_began_before_and_nothing_else() -> None:
    first, other = Fault(MOCAP, OFF, start=1.0), Fault(FaultComponent.COMMANDS, OFF, start=1.0)
    later = Fault(MOCAP, OFF, start=9.0)
    ok = Fault(MOCAP, FaultKind.OK, start=5.0)
    schedule = FaultSchedule().with_faults((first, other, later, ok))
    assert schedule.active(4.9) == (schedule.faults[0], other)
    assert schedule.active(5.0) == (other,)
    assert schedule.active(9.0) == (other, later)


@given(st.integers(0, 2**31 - 1), st.integers(0, 10**6))
def test_what_is_random_depends_on_seed_and_number_only(seed: int, number: int) -> None:
    assert 0.0 <= seeded_uniform(seed, number) < 1.0
    assert seeded_uniform(seed, number) == seeded_uniform(seed, number)
    assert hypot(*Fault(MOCAP, WRONG, seed=seed).direction()) == pytest.approx(1.0)


@pytest.mark.parametrize("seed", [1, 2, 77])
def test_a_share_is_struck_as_often_as_it_says(seed: int) -> None:
    fault = Fault(MOCAP, FaultKind.INTERMITTENT, magnitude=0.3, seed=seed)
    assert sum(map(fault.strikes, range(10_000))) == pytest.approx(3000, abs=200)


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"start": -1.0}, "start is -1"),
        ({"start": nan}, "start is nan"),
        ({"duration": 0.0}, "duration is 0"),
        ({"duration": nan}, "duration is nan"),
        ({"magnitude": nan}, "allowed: 0 to 100 m"),
        ({"magnitude": -1.0}, "allowed: 0 to 100 m"),
        ({"seed": -1}, "seed is -1"),
        ({"aspect": "colour"}, "mocap can have: mocap:off"),
    ],
)
def test_a_value_out_of_its_range_is_refused_with_the_range(
    values: dict[str, float], words: str
) -> None:
    with pytest.raises(ConfigError, match=words):
        Fault(MOCAP, WRONG, **values)  # type: ignore[arg-type]


def test_a_fault_without_a_size_takes_none() -> None:
    with pytest.raises(ConfigError, match="no magnitude"):
        Fault(MOCAP, OFF, magnitude=1.0)


@given(TYPES)
def test_every_type_is_found_by_its_words_and_its_default_is_allowed(known: FaultType) -> None:
    assert fault_type(known.component, known.kind, known.aspect) is known
    assert known.low <= known.default <= known.high
    assert Fault(known.component, known.kind, known.aspect).size == known.default


@pytest.mark.parametrize("component", FaultComponent)
def test_each_component_has_each_word_of_px4_or_a_reason(component: FaultComponent) -> None:
    own, reasons = fault_words(component), LEFT_OUT.get(component, {})
    assert set(own) | set(reasons) == set(FaultKind), "every word, or why it is left out"
    assert not set(own) & set(reasons), "a word that there is needs no reason"
    assert all(len(reason.split()) > 5 for reason in reasons.values())


@pytest.mark.parametrize(
    "component",
    [
        FaultComponent.MOCAP,
        FaultComponent.TELEMETRY,
        FaultComponent.COMMANDS,
        FaultComponent.VIDEO,
        FaultComponent.LASER,
        FaultComponent.DEPTH,
        FaultComponent.DEVICES,
    ],
)
def test_each_wire_has_all_eight_words(component: FaultComponent) -> None:
    assert fault_words(component) == tuple(FaultKind)


@pytest.mark.parametrize("motor", Motor)
def test_each_motor_can_be_weak_and_can_stand_still(motor: Motor) -> None:
    for kind in (FaultKind.WRONG, FaultKind.OFF):
        assert fault_type(FaultComponent.MOTOR, kind, motor.name.lower())
