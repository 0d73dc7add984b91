"""What a vehicle tells becomes values, and what no vehicle tells is refused."""

from __future__ import annotations

import struct

import pytest

from housefly.config.drone import DroneConfig
from housefly.errors import ConfigError, WireError
from housefly.wires.mavlink.autopilots import AUTOPILOTS
from housefly.wires.mavlink.dialect import dialect
from housefly.wires.mavlink.endpoint import Endpoint, endpoint_of
from housefly.wires.mavlink.reports import (
    Answer,
    AttitudeReport,
    ChargeReport,
    ClockQuestion,
    Heartbeat,
    Landed,
    LandedReport,
    ParameterReport,
    Result,
    Said,
    SystemState,
    report_in,
)


def test_each_message_becomes_its_value() -> None:
    d = dialect()
    assert report_in(d.MAVLink_heartbeat_message(2, 3, 129, 4, 4, 3)) == Heartbeat(
        3, 4, True, SystemState.ACTIVE
    )
    assert report_in(d.MAVLink_heartbeat_message(18, 8, 0, 0, 4, 3)) is None, "no autopilot"
    told = report_in(d.MAVLink_attitude_message(2500, 0.1, -0.2, 1.5707963, 0, 0, 0))
    assert isinstance(told, AttitudeReport) and told.time == 2.5
    assert told.attitude == pytest.approx((0.1, 0.2, 0.0), abs=1e-6)
    assert report_in(d.MAVLink_extended_sys_state_message(0, 4)) == LandedReport(Landed.LANDING)
    health = (0, 0, 0, 0, 0, 0)
    assert report_in(d.MAVLink_sys_status_message(*health[:3], 0, 11000, -1, 40, *health)) == (
        ChargeReport(0.4)
    )
    assert report_in(d.MAVLink_sys_status_message(*health[:3], 0, 11000, -1, -1, *health)) == (
        ChargeReport(None)
    )
    assert report_in(d.MAVLink_command_ack_message(400, 4)) == Answer(400, Result.FAILED)
    assert report_in(d.MAVLink_statustext_message(2, b"PreArm: \x07Compass\x00junk")) == Said(
        2, "PreArm: Compass"
    )
    assert report_in(d.MAVLink_timesync_message(0, 55)) == ClockQuestion(55)
    assert report_in(d.MAVLink_timesync_message(7, 55)) is None, "an answer"


def test_a_count_is_read_from_the_bits_or_plainly() -> None:
    bits = struct.unpack("<f", struct.pack("<i", 4))[0]
    told = report_in(dialect().MAVLink_param_value_message(b"COM_OBL_RC_ACT", bits, 6, 1, 0))
    assert isinstance(told, ParameterReport)
    assert (told.name, told.by_bits) == ("COM_OBL_RC_ACT", 4.0)
    told = report_in(dialect().MAVLink_param_value_message(b"FS_GCS_ENABLE", 5.0, 2, 1, 0))
    assert isinstance(told, ParameterReport) and told.value == 5.0


def test_numbers_that_cannot_be_are_refused_by_field_and_value() -> None:
    d = dialect()
    with pytest.raises(WireError, match=r"ATTITUDE\.pitch is nan; allowed"):
        report_in(d.MAVLink_attitude_message(0, 0.0, float("nan"), 0.0, 0, 0, 0))
    with pytest.raises(WireError, match=r"EXTENDED_SYS_STATE\.landed_state is 9; allowed: 0 to 4"):
        report_in(d.MAVLink_extended_sys_state_message(0, 9))
    with pytest.raises(WireError, match=r"PARAM_VALUE\.param_value is inf"):
        report_in(d.MAVLink_param_value_message(b"X", float("inf"), 9, 1, 0))


@pytest.mark.parametrize(
    ("address", "wanted"),
    [
        ("10.0.0.5", "udp:10.0.0.5:14550"),
        ("udp:10.0.0.5:14555", "udp:10.0.0.5:14555"),
        ("tcp:10.0.0.5", "tcp:10.0.0.5:5760"),
        ("tcp:copter.local:5762", "tcp:copter.local:5762"),
    ],
)
def test_an_address_says_where_it_answers(address: str, wanted: str) -> None:
    assert str(endpoint_of(address, AUTOPILOTS["arducopter"])) == wanted


def test_px4_sends_to_a_port_of_its_own_choice_and_other_forms_are_refused() -> None:
    assert endpoint_of("127.0.0.1", AUTOPILOTS["px4"]) == Endpoint(False, "127.0.0.1", 14580, 14540)
    for wrong in ("", "serial:/dev/ttyUSB0", "udp:1.2.3.4:99999", "a b"):
        with pytest.raises(ConfigError, match="allowed: an IP address, or udp:"):
            endpoint_of(wrong, AUTOPILOTS["px4"])


def test_every_row_of_the_table_has_an_airframe_and_names_for_its_own_modes() -> None:
    for model, row in AUTOPILOTS.items():
        able = DroneConfig(kind=model).airframe.capabilities
        assert able.arms and able.external_pose_rate
        for mode in (row.steered, row.ready, row.landing):
            assert not row.mode_name(mode.number).isdigit()
        assert row.passing <= row.modes.keys()
        assert all(need.least <= need.most for need in row.needs)
