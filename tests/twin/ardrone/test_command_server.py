"""Commands reach the world by the drone's own rules."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from kinematic_world import KinematicWorld

from housefly.messages.stick import Stick
from housefly.twin.ardrone.command_server import CommandServer
from housefly.twin.ardrone.config_store import ConfigStore
from housefly.twin.ardrone.link import Link
from housefly.twin.contracts import FlightState
from housefly.wires.ardrone import at


class Desk:
    """A command port with everything behind it in the open."""

    def __init__(self) -> None:
        self.world = KinematicWorld()
        self.link = Link()
        self.config = ConfigStore()
        self.asked: list[bool] = []
        self.port = CommandServer(self.world, self.link, self.config, self.asked.append)

    def hear(self, sequence: int, *commands: at.AtCommand) -> None:
        self.port.receive(at.encode_datagram(sequence, commands))


def test_the_sticks_arrive_in_body_signs():
    desk = Desk()
    desk.hear(1, at.Pcmd(at.PcmdFlag.PROGRESSIVE, roll=-0.25, pitch=-0.5, gaz=0.75, yaw=1.0))
    assert desk.world.asked == Stick(forward=0.5, left=0.25, up=0.75, turn=-1.0, hover=False)


def test_sticks_beyond_one_are_cut():
    desk = Desk()
    desk.hear(1, at.Pcmd(at.PcmdFlag.PROGRESSIVE, roll=9.0, pitch=-9.0, gaz=9.0, yaw=-9.0))
    assert desk.world.asked == Stick(forward=1.0, left=-1.0, up=1.0, turn=1.0, hover=False)


def test_a_cleared_progressive_bit_means_hover():
    desk = Desk()
    desk.hear(1, at.Pcmd(at.PcmdFlag.HOVER, pitch=-0.5))
    assert desk.world.asked.hover


def test_old_numbers_are_ignored_and_number_one_starts_anew():
    desk = Desk()
    desk.hear(100, at.Ref(at.RefBits.TAKE_OFF))
    desk.hear(99, at.Ref(at.RefBits.LAND))
    assert desk.world.flight is FlightState.TAKING_OFF
    assert desk.link.counters.stale_commands == 1
    desk.hear(1, at.Ref(at.RefBits.LAND))
    assert desk.world.flight is FlightState.LANDING
    desk.hear(50, at.ComWatchdog())
    assert desk.link.counters.commands == 3


def test_a_first_number_zero_counts():
    desk = Desk()
    desk.hear(0, at.Ref(at.RefBits.TAKE_OFF))
    assert desk.world.flight is FlightState.TAKING_OFF


def test_two_seconds_of_silence_forget_the_number():
    desk = Desk()
    desk.hear(1000, at.ComWatchdog())
    desk.world.advance(2.1)
    desk.hear(7, at.Ref(at.RefBits.TAKE_OFF))
    assert desk.world.flight is FlightState.TAKING_OFF


def test_the_emergency_bit_acts_when_it_rises():
    desk = Desk()
    for sequence in range(1, 5):
        desk.hear(sequence, at.Ref(at.RefBits.EMERGENCY))
    assert desk.world.flight is FlightState.EMERGENCY
    desk.hear(5, at.Ref())
    assert desk.world.flight is FlightState.EMERGENCY
    desk.hear(6, at.Ref(at.RefBits.EMERGENCY))
    assert desk.world.flight is FlightState.LANDED


def test_a_setting_raises_the_acknowledge_bit_until_it_is_cleared():
    desk = Desk()
    desk.hear(1, at.Config("control:altitude_max", "1500"))
    assert desk.link.acknowledged
    assert desk.config.limits.altitude == 1.5
    desk.hear(2, at.Control(at.ControlMode.CLEAR_ACK))
    assert not desk.link.acknowledged


def test_ids_count_for_the_next_setting_only():
    desk = Desk()
    wrong = at.ConfigIds("11111111", "11111111", "11111111")
    desk.hear(1, wrong, at.Config("control:altitude_max", "1500"))
    assert desk.link.acknowledged
    assert desk.link.counters.refused_settings == 1
    desk.hear(3, at.Config("control:altitude_max", "1500"))
    assert desk.config.limits.altitude == 1.5


def test_the_configuration_is_sent_on_demand():
    desk = Desk()
    desk.hear(
        1,
        at.Control(at.ControlMode.SEND_CONFIG),
        at.Control(at.ControlMode.SEND_CUSTOM_CONFIGS),
        at.Control(0),
    )
    assert desk.asked == [False, True]
    assert desk.link.acknowledged


def test_a_flat_trim_and_unmodelled_commands_are_taken():
    desk = Desk()
    desk.hear(
        1,
        at.FlatTrim(),
        at.Calibrate(0),
        at.Led(1, 2.0, 3),
        at.Animation(1, 1000),
        at.Other("PWM", ("1", "2")),
    )
    assert desk.world.trims == 1
    assert desk.link.counters.commands == 5


def test_any_command_feeds_the_watchdog_and_a_stale_one_does_not():
    desk = Desk()
    desk.hear(10, at.ComWatchdog())
    desk.world.advance(0.1)
    assert desk.world.onboard().com_watchdog
    desk.hear(9, at.ComWatchdog())
    assert desk.world.onboard().com_watchdog
    desk.hear(11, at.ComWatchdog())
    assert not desk.world.onboard().com_watchdog


@pytest.mark.parametrize(
    "datagram",
    [b"AT*COMWDG=3,\r", b"\r", b"AT*FTRIM=2,\r", b"AT*REF=4,512\r", b"AT*CTRL=0,5,0\rAT*REF=1,0\r"],
)
def test_habits_of_clients_in_the_field_are_no_errors(datagram):
    desk = Desk()
    desk.port.receive(datagram)
    assert desk.link.counters.malformed == 0


LINES = st.text(alphabet='AT*REFPCMDONIGLWS_=,-0123456789"\r\n\0:. ', max_size=120).map(str.encode)


@given(
    st.lists(
        st.binary(max_size=120)
        | LINES
        | st.sampled_from([b"AT*REF=", b"AT*PCMD=1,1,2143289344,0,0,0\r"]),
        max_size=8,
    )
)
def test_no_datagram_raises_and_the_sticks_stay_sane(datagrams):
    desk = Desk()
    for datagram in datagrams:
        desk.port.receive(datagram)
    asked = desk.world.asked
    assert all(-1.0 <= part <= 1.0 for part in (asked.forward, asked.left, asked.up, asked.turn))
