import pytest

from housefly.lab.lockstep.service_monitor import COMPLETED, STAGES, ServiceMonitor
from housefly.messages import (
    Action,
    Command,
    DroneStatus,
    Estimate,
    Event,
    EventCode,
    Inputs,
    Outputs,
    Phase,
    PilotStep,
    SafetyMode,
    Severity,
    Telemetry,
)

HOME = (1.0, 2.0)


def step(
    now: float,
    phase: Phase,
    status: DroneStatus,
    *events: Event,
    safety: SafetyMode = SafetyMode.NOMINAL,
    at: tuple[float, float] = HOME,
    z: float = 0.0,
    pose_age: float = 0.01,
) -> PilotStep:
    telemetry = Telemetry(received_at=now, status=status, battery=0.8)
    estimate = Estimate(now, (*at, z), (0.0, 0.0, 0.0), 0.0, pose_age, 0.01)
    outputs = Outputs(Command(Action.IDLE), estimate, phase=phase, safety=safety, events=events)
    return PilotStep(0, now, Inputs(telemetry=telemetry), outputs)


def watched(*steps: PilotStep) -> ServiceMonitor:
    watch = ServiceMonitor(0.0, HOME)
    for one in steps:
        watch = watch.updated(one)
    return watch


def whole_service() -> list[PilotStep]:
    return [step(n, phase, DroneStatus.FLYING) for n, phase in enumerate(STAGES)]


def test_a_service_that_passed_every_phase_and_landed_is_completed() -> None:
    assert watched(*whole_service(), step(9, Phase.IDLE, DroneStatus.LANDED)).outcome == COMPLETED


@pytest.mark.parametrize("missing", range(len(STAGES)))
def test_a_service_without_one_of_its_phases_is_not_completed(missing: int) -> None:
    steps = [one for n, one in enumerate(whole_service()) if n != missing]
    outcome = watched(*steps, step(9, Phase.IDLE, DroneStatus.LANDED)).outcome
    assert outcome and outcome != COMPLETED


def test_it_is_not_over_while_the_drone_is_in_the_air() -> None:
    assert watched(*whole_service(), step(9, Phase.IDLE, DroneStatus.FLYING)).outcome == ""


def test_an_early_landing_gives_the_last_trouble_as_its_reason() -> None:
    trouble = Event(2.0, Severity.FAULT, EventCode.TRACKING_LOST, "no pose for 2 s: landing")
    steps = [
        step(0, Phase.TAKING_OFF, DroneStatus.TAKING_OFF),
        step(2, Phase.LANDING, DroneStatus.LANDING, trouble),
    ]
    assert (
        watched(*steps, step(5, Phase.IDLE, DroneStatus.LANDED)).outcome
        == "no pose for 2 s: landing"
    )


def test_a_refused_order_ends_with_the_refusal() -> None:
    refusal = Event(0.1, Severity.WARNING, EventCode.ORDER_REFUSED, "battery too low")
    steps = [
        step(0.1, Phase.IDLE, DroneStatus.LANDED, refusal),
        step(4.0, Phase.IDLE, DroneStatus.LANDED),
    ]
    assert watched(*steps).outcome == "battery too low"


def test_it_gives_up_in_time_and_remembers_the_worst() -> None:
    watch = watched(
        step(1, Phase.OUTBOUND, DroneStatus.FLYING, safety=SafetyMode.HOLD),
        step(400, Phase.OUTBOUND, DroneStatus.FLYING),
    )
    assert "not done after" in watch.outcome
    assert watch.worst is SafetyMode.HOLD


def test_a_motor_cut_ends_the_watch_at_once() -> None:
    assert (
        watched(step(1, Phase.OUTBOUND, DroneStatus.FLYING, safety=SafetyMode.CUT)).outcome
        == "motors were cut"
    )


def test_a_landing_far_from_the_pad_is_not_a_completed_service() -> None:
    outcome = watched(
        *whole_service(), step(9, Phase.IDLE, DroneStatus.LANDED, at=(4.0, 2.0))
    ).outcome
    assert outcome == "landed 3.0 m from the pad"


@pytest.mark.parametrize("floor", [0.0, 0.45])
def test_a_service_that_ends_on_a_stool_beside_the_pad_is_not_completed(floor: float) -> None:
    stood = step(0, Phase.TAKING_OFF, DroneStatus.LANDED, z=floor)
    beside = (HOME[0] + 0.4, HOME[1])
    ended = step(9, Phase.IDLE, DroneStatus.LANDED, at=beside, z=floor + 0.6)
    outcome = watched(stood, *whole_service(), ended).outcome
    assert outcome == "stands 0.60 m above where it took off: on something"
    back = step(9, Phase.IDLE, DroneStatus.LANDED, at=beside, z=floor + 0.14)
    assert watched(stood, *whole_service(), back).outcome == COMPLETED


def test_a_height_from_before_the_touchdown_is_not_where_it_stands() -> None:
    stood = step(0, Phase.TAKING_OFF, DroneStatus.LANDED)
    blind = step(9, Phase.IDLE, DroneStatus.LANDED, z=0.6, pose_age=0.6)
    assert watched(stood, *whole_service(), blind).outcome == COMPLETED
    late = step(0, Phase.TAKING_OFF, DroneStatus.LANDED, z=0.9, pose_age=0.6)
    on_it = step(9, Phase.IDLE, DroneStatus.LANDED, z=0.6)
    assert watched(late, stood, *whole_service(), on_it).outcome != COMPLETED
