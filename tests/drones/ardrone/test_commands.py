"""What is sent to an AR.Drone, for every action and every state: failsafe and encoder together."""

from __future__ import annotations

import itertools
from dataclasses import replace
from math import inf, nan, pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.airframe import airframe_named
from housefly.drones.brake import SINK_TIME_MAX
from housefly.drones.failsafe import HOVER_AFTER, LAND_AFTER, Failsafe, Permit
from housefly.messages import (
    LEVEL,
    Action,
    Command,
    DroneStatus,
    KnownMotion,
    Setpoint,
    Telemetry,
)
from housefly.messages.sensing import REPORT_AGE_MAX
from housefly.messages.stick import Maxima
from housefly.wires.ardrone import at
from housefly.wires.ardrone.command_encoder import PRESS_TIME_MAX, TRIM_TIME, CommandEncoder
from housefly.wires.ardrone.conversions import stick_from_pcmd

AIRBORNE = (DroneStatus.TAKING_OFF, DroneStatus.FLYING, DroneStatus.LANDING)
ARDRONE = airframe_named("ardrone")
MAXIMA = Maxima(0.2, 0.7, 1.75)
LAND = at.Ref(at.RefBits.LAND)
TAKE_OFF = at.Ref(at.RefBits.TAKE_OFF)
PRESS = at.Ref(at.RefBits.EMERGENCY)
HOVER = at.Pcmd()
STICKS = at.Pcmd(at.PcmdFlag.PROGRESSIVE, pitch=-0.5)


def report(status: DroneStatus, at_time: float) -> Telemetry:
    return Telemetry(received_at=at_time, status=status, battery=1.0)


class Commands:
    """What leaves for a drone that was seen to stand before."""

    def __init__(self, maxima: Maxima, now: float, *, watched: bool = True) -> None:
        self.failsafe = Failsafe(now, maxima.tilt, ARDRONE, watched=watched)
        self.failsafe.permit = Permit.ALL
        self.update, self.abandon = self.failsafe.update, self.failsafe.abandon
        self._encoder = CommandEncoder(maxima)

    def next_commands(self, now: float, newest: Telemetry | None) -> tuple[at.AtCommand, ...]:
        return self._encoder.encoded(self.failsafe.decide(now, newest), now, newest)


def commanded(action: Action, setpoint: Setpoint = LEVEL, now: float = 0.0) -> Commands:
    made = Commands(MAXIMA, now)
    made.update(Command(action, setpoint), now)
    return made


def test_sticks_are_fractions_of_the_maxima() -> None:
    assert commanded(Action.FLY, Setpoint(theta=0.1)).next_commands(
        0.0, report(DroneStatus.FLYING, 0.0)
    ) == (STICKS,)


@given(st.floats(-0.2, 0.2), st.floats(-0.2, 0.2), st.floats(-0.7, 0.7), st.floats(-1.7, 1.7))
def test_within_the_maxima_the_stick_is_the_share_of_the_maximum(
    theta: float, phi: float, vz: float, yaw_rate: float
) -> None:
    flying = Commands(Maxima(0.2, 0.7, pi), 0.0)
    flying.update(Command(Action.FLY, Setpoint(theta, phi, vz, yaw_rate)), 0.0)
    (pcmd,) = flying.next_commands(0.0, report(DroneStatus.FLYING, 0.0))
    assert isinstance(pcmd, at.Pcmd)
    stick = stick_from_pcmd(pcmd)
    asked = (stick.forward * 0.2, -stick.left * 0.2, stick.up * 0.7, stick.turn * pi)
    assert asked == pytest.approx((theta, phi, vz, yaw_rate))


def test_a_level_setpoint_is_level_flight_and_not_hover() -> None:
    flying = commanded(Action.FLY, LEVEL)
    assert flying.next_commands(0.0, report(DroneStatus.FLYING, 0.0)) == (
        at.Pcmd(at.PcmdFlag.PROGRESSIVE),
    )


def test_hover_is_the_cleared_flag() -> None:
    assert commanded(Action.HOVER).next_commands(0.0, report(DroneStatus.FLYING, 0.0)) == (HOVER,)


@pytest.mark.parametrize("status", [None, *DroneStatus])
def test_landing_is_repeated_whatever_the_drone_says(status: DroneStatus | None) -> None:
    landing = commanded(Action.LAND)
    for step in range(100):
        newest = report(status, step * 0.03) if status else None
        assert LAND in landing.next_commands(step * 0.03, newest)


def test_take_off_trims_first_and_is_repeated_until_flying_then_hovers() -> None:
    rising = commanded(Action.TAKE_OFF)
    sent = []
    for step in range(40):
        now = step * 0.03
        status = (
            DroneStatus.LANDED
            if step < 20
            else DroneStatus.TAKING_OFF
            if step < 30
            else DroneStatus.FLYING
        )
        rising.update(Command(Action.TAKE_OFF), now)
        sent.append(rising.next_commands(now, report(status, now)))
    trims = [datagram for datagram in sent if at.FlatTrim() in datagram]
    assert sent[: len(trims)] == trims and len(trims) == len(
        [n for n in range(40) if n * 0.03 < TRIM_TIME]
    )
    assert all(TAKE_OFF in datagram for datagram in sent[len(trims) : 30])
    assert all(datagram == (HOVER,) for datagram in sent[30:])


@pytest.mark.parametrize("lean", [{"phi": 0.05}, {"theta": -0.04}])
def test_a_drone_on_a_leaning_pad_is_not_trimmed(lean: dict[str, float]) -> None:
    rising, sent = commanded(Action.TAKE_OFF), []
    for step in range(20):
        now = step * 0.03
        rising.update(Command(Action.TAKE_OFF), now)
        told = replace(report(DroneStatus.LANDED, now), **lean)
        sent.append(rising.next_commands(now, told))
    assert not any(at.FlatTrim() in datagram for datagram in sent)
    assert TAKE_OFF in sent[-1]


def test_a_drone_that_landed_by_itself_does_not_rise_again_under_the_same_order() -> None:
    rising = commanded(Action.TAKE_OFF)
    for step, status in enumerate(
        [DroneStatus.LANDED] * 10 + [DroneStatus.FLYING] * 10 + [DroneStatus.LANDED] * 30
    ):
        rising.update(Command(Action.TAKE_OFF), step * 0.03)
        sent = rising.next_commands(step * 0.03, report(status, step * 0.03))
        assert step < 20 or TAKE_OFF not in sent


@given(
    st.sampled_from([Action.FLY, Action.HOVER, Action.LAND, Action.IDLE, Action.CUT, Action.RESET]),
    st.sampled_from(DroneStatus),
)
def test_the_take_off_bit_is_sent_under_no_other_order(action: Action, status: DroneStatus) -> None:
    assert TAKE_OFF not in commanded(action).next_commands(0.0, report(status, 0.0))


@pytest.mark.parametrize(
    "newest",
    [None, report(DroneStatus.LANDED, -REPORT_AGE_MAX - 0.1), report(DroneStatus.EMERGENCY, 0.2)],
)
def test_nobody_takes_off_blindly_or_out_of_an_emergency(newest: Telemetry | None) -> None:
    rising = commanded(Action.TAKE_OFF)
    assert TAKE_OFF not in rising.next_commands(0.2, newest)


def test_idle_never_lands_a_flying_drone_and_keeps_the_link_alive() -> None:
    for status, age in itertools.product((*AIRBORNE, DroneStatus.UNKNOWN), (0.0, 10.0)):
        idle = Commands(MAXIMA, 0.0)
        sent = idle.next_commands(0.0, report(status, -age))
        assert LAND not in sent and at.ComWatchdog() in sent
    assert LAND in Commands(MAXIMA, 0.0).next_commands(0.0, report(DroneStatus.LANDED, 0.0))


# --- the emergency toggle ------------------------------------------------------------------------


class Toggle:
    """A drone's emergency: a held bit counts once, when it rises."""

    def __init__(self, on: bool) -> None:
        self.on = on
        self.toggles = 0
        self._held = False

    def hear(self, datagram: tuple[at.AtCommand, ...]) -> None:
        for command in datagram:
            if isinstance(command, at.Ref):
                held = at.RefBits.EMERGENCY in command.bits
                if held and not self._held:
                    self.on = not self.on
                    self.toggles += 1
                self._held = held


@given(
    st.booleans(),
    st.booleans(),
    st.lists(st.booleans(), min_size=400, max_size=400),
    st.integers(1, 30),
)
def test_cut_and_reset_reach_their_state_with_one_toggle_however_many_datagrams_are_lost(
    starts_on: bool, wants_on: bool, arrives: list[bool], report_delay_steps: int
) -> None:
    drone, button = Toggle(starts_on), commanded(Action.CUT if wants_on else Action.RESET)
    states = [starts_on] * (report_delay_steps + 1)
    for step, passes in enumerate([*arrives, *[True] * 150]):
        now = step * 0.03
        states.append(drone.on)
        seen = states[-1 - report_delay_steps]
        status = DroneStatus.EMERGENCY if seen else DroneStatus.LANDED
        datagram = button.next_commands(now, report(status, now - 0.001))
        if passes:
            drone.hear(datagram)
    assert drone.on == wants_on
    assert drone.toggles == (starts_on != wants_on)


def test_without_reports_the_button_is_pressed_once() -> None:
    drone, cut = Toggle(False), commanded(Action.CUT)
    for step in range(200):
        drone.hear(cut.next_commands(step * 0.03, report(DroneStatus.FLYING, 0.0)))
    assert drone.on and drone.toggles == 1


def test_a_reset_does_nothing_to_a_flying_drone() -> None:
    reset = commanded(Action.RESET)
    for now in (0.03 * step for step in range(100)):
        reset.update(Command(Action.RESET), now)
        sent = reset.next_commands(now, report(DroneStatus.FLYING, now))
        assert PRESS not in sent and LAND not in sent


def test_reset_right_after_cut_lets_go_of_the_button_in_between() -> None:
    drone, button = Toggle(False), commanded(Action.CUT)
    for step in range(100):
        now = step * 0.03
        button.update(Command(Action.CUT if now < 0.2 else Action.RESET), now)
        drone.hear(
            button.next_commands(
                now, report(DroneStatus.EMERGENCY if drone.on else DroneStatus.LANDED, now)
            )
        )
    assert not drone.on and drone.toggles == 2


def test_a_press_ends_after_a_while_and_is_repeated_only_on_a_newer_report() -> None:
    cut = commanded(Action.CUT)
    pressed = [
        PRESS in cut.next_commands(n * 0.01, report(DroneStatus.FLYING, n * 0.01))
        for n in range(200)
    ]
    assert pressed[0] and not all(pressed[: round(PRESS_TIME_MAX / 0.01) + 5])
    assert any(pressed[round(PRESS_TIME_MAX / 0.01) + 5 :])


# --- the driver's watchdog over the pilot --------------------------------------------------------


def fly_in_silence(
    seconds: float, action: Action = Action.FLY, status: DroneStatus = DroneStatus.FLYING
) -> tuple[at.AtCommand, ...]:
    return commanded(action, Setpoint(theta=0.1)).next_commands(seconds, report(status, seconds))


def test_a_silent_pilot_means_hover_then_land() -> None:
    assert fly_in_silence(0.24) == (STICKS,)
    assert fly_in_silence(0.26) == (HOVER,)
    assert fly_in_silence(1.99) == (HOVER,)
    assert LAND in fly_in_silence(2.01)


@pytest.mark.parametrize("action", [Action.IDLE, Action.TAKE_OFF, Action.HOVER])
@pytest.mark.parametrize("status", AIRBORNE)
def test_whatever_moves_or_holds_it_ends_in_a_landing(action: Action, status: DroneStatus) -> None:
    assert LAND in fly_in_silence(2.01, action, status)


def test_the_control_without_its_watchdog_repeats_the_last_command_for_ever() -> None:
    unwatched = Commands(MAXIMA, 0.0, watched=False)
    unwatched.update(Command(Action.FLY, Setpoint(theta=0.1)), 0.0)
    late = 10.0 * LAND_AFTER
    assert unwatched.next_commands(late, report(DroneStatus.FLYING, late)) == (STICKS,)


def test_a_pilot_that_comes_back_after_the_watchdog_landed_does_not_fly_on() -> None:
    returning = commanded(Action.FLY, Setpoint(theta=0.1))
    assert LAND in returning.next_commands(2.1, report(DroneStatus.FLYING, 2.1))
    for step in range(100):
        now = 2.2 + step * 0.03
        returning.update(Command(Action.FLY, Setpoint(theta=0.1)), now)
        assert LAND in returning.next_commands(now, report(DroneStatus.LANDING, now))
    returning.update(Command(Action.FLY), 6.0)
    assert LAND not in returning.next_commands(6.0, report(DroneStatus.LANDED, 6.0))


def test_a_take_off_order_from_before_the_silence_does_not_count_after_it() -> None:
    rising = commanded(Action.TAKE_OFF)
    rising.next_commands(0.05, report(DroneStatus.LANDED, 0.05))
    assert TAKE_OFF not in rising.next_commands(0.6, report(DroneStatus.LANDED, 0.6))
    rising.next_commands(2.5, report(DroneStatus.TAKING_OFF, 2.5))
    rising.update(Command(Action.TAKE_OFF), 5.0)
    assert TAKE_OFF not in rising.next_commands(5.0, report(DroneStatus.LANDED, 5.0))


def test_cutting_the_motors_passes_the_watchdog() -> None:
    cutting = commanded(Action.FLY)
    cutting.next_commands(3.0, report(DroneStatus.FLYING, 3.0))
    cutting.update(Command(Action.CUT), 3.1)
    assert cutting.next_commands(3.1, report(DroneStatus.LANDING, 3.1)) == (PRESS,)


@given(
    st.lists(
        st.tuples(st.sampled_from(Action), st.sampled_from([None, *DroneStatus]), st.floats(0, 3)),
        max_size=30,
    )
)
def test_every_order_in_every_state_is_answered_with_something_that_can_be_sent(
    story: list[tuple[Action, DroneStatus | None, float]],
) -> None:
    sequencer, now = Commands(MAXIMA, 0.0), 0.0
    for action, status, pause in story:
        now += pause
        sequencer.update(Command(action, Setpoint(1, -1, 9, -9)), now)
        sent = sequencer.next_commands(now + 0.01, report(status, now) if status else None)
        assert sent and at.parse_datagram(at.encode_datagram(1, sent)).rejects == ()


def test_a_pilot_that_is_gone_is_not_waited_for() -> None:
    flying = commanded(Action.FLY, Setpoint(theta=0.1))
    assert flying.next_commands(0.05, report(DroneStatus.FLYING, 0.05)) == (STICKS,)
    flying.abandon()
    assert flying.next_commands(0.06, report(DroneStatus.FLYING, 0.06)) == (HOVER,)
    assert LAND in flying.next_commands(2.1, report(DroneStatus.FLYING, 2.1))
    flying = commanded(Action.FLY, Setpoint(theta=0.1))
    flying.abandon()
    flying.update(Command(Action.FLY, Setpoint(theta=0.1)), 0.5)
    assert flying.next_commands(0.5, report(DroneStatus.FLYING, 0.5)) == (STICKS,)


def moving(at_time: float, speed: float) -> Telemetry:
    return Telemetry(at_time, DroneStatus.FLYING, 1.0, velocity=(speed, 0.0, 0.0))


def test_in_silence_it_leans_against_its_speed_and_then_hovers_for_the_rest_of_it() -> None:
    flying = commanded(Action.FLY, Setpoint(theta=0.1))
    (against,) = flying.next_commands(0.3, moving(0.3, 0.5))
    assert isinstance(against, at.Pcmd) and against.pitch > 0.5
    assert flying.next_commands(0.5, moving(0.5, 0.05)) == (HOVER,)
    assert flying.next_commands(0.6, moving(0.6, 0.5)) == (HOVER,)
    flying = commanded(Action.FLY, Setpoint(theta=0.1))
    flying.next_commands(0.3, moving(0.3, 0.5))
    assert flying.next_commands(1.2, moving(1.2, 0.5)) == (HOVER,)


def lowered(at_time: float, height: float) -> Telemetry:
    wrong = (0.8, 0.0, 0.0)
    return replace(report(DroneStatus.FLYING, at_time), height=height, velocity=wrong)


@pytest.mark.parametrize("last", [Action.FLY, Action.HOVER, Action.LAND])
def test_a_drone_whose_own_speed_is_wrong_sinks_level_in_silence_and_lands_on_the_floor(
    last: Action,
) -> None:
    made = Commands(MAXIMA, 0.0)
    made.update(Command(last), 0.0, motion=KnownMotion(0.0, 0.0, hovers=False))
    for at_time in (0.3, 1.0, 2.5):
        (sinking,) = made.next_commands(at_time, lowered(at_time, 1.3 - 0.3 * at_time))
        assert isinstance(sinking, at.Pcmd) and sinking.gaz < 0.0
        assert sinking.flags is at.PcmdFlag.PROGRESSIVE
        assert sinking.pitch == sinking.roll == 0.0, "it stands by what tracking said last"
    assert made.next_commands(4.0, lowered(4.0, 0.05)) == (LAND, HOVER)


def test_a_sonar_that_shows_no_floor_does_not_keep_it_in_the_air() -> None:
    made = Commands(MAXIMA, 0.0)
    made.update(Command(Action.FLY), 0.0, motion=KnownMotion(0.0, 0.0, hovers=False))
    made.next_commands(0.3, lowered(0.3, 1.0))
    assert made.next_commands(0.4 + SINK_TIME_MAX, lowered(9.4, 1.0)) == (LAND, HOVER)


def test_a_pilot_that_says_nothing_new_of_the_motion_takes_nothing_back() -> None:
    made = Commands(MAXIMA, 0.0)
    made.update(Command(Action.FLY), 0.0, motion=KnownMotion(0.0, 0.0, hovers=False))
    made.update(Command(Action.HOVER), 0.01)
    (sinking,) = made.next_commands(0.4, lowered(0.4, 1.0))
    assert isinstance(sinking, at.Pcmd) and sinking.gaz < 0.0


def test_a_hover_of_the_pilot_is_the_drones_own_whatever_its_speed() -> None:
    assert commanded(Action.HOVER).next_commands(0.1, moving(0.1, 0.5)) == (HOVER,)


@pytest.mark.parametrize("action", [Action.FLY, Action.TAKE_OFF, Action.RESET])
def test_what_moves_the_drone_and_comes_late_counts_for_nothing(action: Action) -> None:
    late = Commands(MAXIMA, 0.0)
    assert not late.update(Command(action, Setpoint(theta=0.1)), 10.0, issued_at=9.7)
    sent = late.next_commands(10.0, report(DroneStatus.FLYING, 10.0))
    assert STICKS not in sent and TAKE_OFF not in sent and PRESS not in sent
    assert late.update(Command(action, Setpoint(theta=0.1)), 10.0, issued_at=9.9)


@given(st.lists(st.tuples(st.sampled_from(Action), st.floats(0.0, 1.0)), min_size=1, max_size=20))
def test_in_whatever_order_commands_arrive_the_newest_decides(
    story: list[tuple[Action, float]],
) -> None:
    mixed = Commands(MAXIMA, 0.0)
    for action, issued_at in [*story, (Action.HOVER, 1.01), (Action.FLY, 1.0)]:
        mixed.update(Command(action, Setpoint(theta=0.1)), 1.02, issued_at)
    assert mixed.next_commands(1.02, report(DroneStatus.FLYING, 1.02)) == (HOVER,)


def test_a_command_from_the_future_counts_as_of_now() -> None:
    ahead = Commands(MAXIMA, 0.0)
    ahead.update(Command(Action.FLY, Setpoint(theta=0.1)), 1.0, issued_at=1e9)
    ahead.update(Command(Action.HOVER), 1.1, issued_at=1.1)
    assert ahead.next_commands(1.1, report(DroneStatus.FLYING, 1.1)) == (HOVER,)


def test_nobody_takes_off_before_the_limits_are_confirmed() -> None:
    rising = commanded(Action.TAKE_OFF)
    for step in range(100):
        now = step * 0.03
        rising.update(Command(Action.TAKE_OFF), now)
        newest = replace(report(DroneStatus.LANDED, now), configured=False)
        assert TAKE_OFF not in rising.next_commands(now, newest)


def test_a_drone_found_in_the_air_hovers_and_lands_when_its_pilot_insists_on_flying() -> None:
    found = commanded(Action.FLY, Setpoint(theta=0.1))
    found.failsafe.permit = None
    for step in range(100):
        now = step * 0.03
        found.update(Command(Action.FLY, Setpoint(theta=0.1)), now)
        sent = found.next_commands(now, report(DroneStatus.FLYING, now))
        assert sent == (HOVER,) if now < LAND_AFTER else LAND in sent
    for action, answer in ((Action.HOVER, HOVER), (Action.LAND, LAND), (Action.CUT, PRESS)):
        found = commanded(action)
        found.failsafe.permit = None
        assert answer in found.next_commands(0.0, report(DroneStatus.FLYING, 0.0))


@given(st.sampled_from(Action), st.sampled_from(DroneStatus))
def test_a_driver_that_leaves_lands_and_only_cutting_the_motors_passes(
    action: Action, status: DroneStatus
) -> None:
    leaving = commanded(action, Setpoint(theta=0.1))
    leaving.failsafe.land_for_good()
    sent = leaving.next_commands(0.2, report(status, 0.2))
    assert TAKE_OFF not in sent and STICKS not in sent
    if status in AIRBORNE and action not in (Action.CUT, Action.RESET):
        assert LAND in sent


@pytest.mark.parametrize("action", [Action.IDLE, Action.TAKE_OFF, Action.FLY, Action.HOVER])
@pytest.mark.parametrize(
    "newest", [None, report(DroneStatus.LANDED, 0.0), report(DroneStatus.UNKNOWN, 60.0)]
)
def test_a_drone_that_is_not_known_to_stand_is_landed_once_its_pilot_is_gone(
    action: Action, newest: Telemetry | None
) -> None:
    leaving = commanded(action)
    leaving.abandon()
    assert LAND not in leaving.next_commands(LAND_AFTER - 0.1, newest)
    for now in (LAND_AFTER + 0.1, 60.0):
        sent = leaving.next_commands(now, newest)
        assert LAND in sent and at.ComWatchdog() in sent


def test_a_stick_that_a_driver_before_left_ends_with_the_first_datagram() -> None:
    assert HOVER in Commands(MAXIMA, 0.0).next_commands(0.0, None)


@pytest.mark.parametrize("part", ["theta", "phi", "vz", "yaw_rate"])
@pytest.mark.parametrize("number", [nan, inf, -inf])
def test_a_setpoint_that_is_not_numbers_counts_as_silence(part: str, number: float) -> None:
    sequencer = commanded(Action.FLY, Setpoint(theta=0.1))
    for n in range(1, 300):
        now = 0.01 * n
        assert not sequencer.update(Command(Action.FLY, Setpoint(**{part: number})), now)
        commands = sequencer.next_commands(now, report(DroneStatus.FLYING, now))
        if now < HOVER_AFTER - 0.01:
            assert commands == (STICKS,), "the last good one stays in force"
        elif HOVER_AFTER + 0.01 < now < LAND_AFTER - 0.01:
            assert commands == (HOVER,)
        elif now > LAND_AFTER + 0.01:
            assert commands == (LAND, HOVER)


@pytest.mark.parametrize("action", [Action.LAND, Action.HOVER, Action.CUT])
def test_what_needs_no_setpoint_is_obeyed_whatever_its_numbers(action: Action) -> None:
    sequencer = commanded(Action.FLY, Setpoint(theta=0.1))
    assert sequencer.update(Command(action, Setpoint(theta=nan)), 0.1)
