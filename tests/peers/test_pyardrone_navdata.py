"""pyardrone's strict parser reads our navdata, and it writes commands as we do.

Unknown tags, wrong sizes and bad checksums make that parser raise.
"""

from __future__ import annotations

import pytest

from housefly.wires.ardrone import at
from housefly.wires.ardrone import navdata_options as options
from housefly.wires.ardrone.navdata import RawOption, StateBits, encode_navdata

pyardrone_navdata = pytest.importorskip("pyardrone.navdata")


def test_pyardrone_reads_our_demo_packet() -> None:
    demo = options.Demo(
        ctrl_state=3 << 16, battery_percent=76, theta=-92.0, psi=14668.0, altitude=534, vx=268.5
    )
    theirs = pyardrone_navdata.NavData(
        encode_navdata(StateBits.FLYING, 42, [demo, options.VisionDetect()])
    )
    assert (theirs.metadata.sequence_number, theirs.metadata.state) == (42, StateBits.FLYING)
    assert (
        theirs.demo.ctrl_state >> 16,
        theirs.demo.vbat_flying_percentage,
        theirs.demo.altitude,
    ) == (3, 76, 534)
    assert (theirs.demo.theta, theirs.demo.psi, theirs.demo.vx) == (-92.0, 14668.0, 268.5)


def test_pyardrone_reads_all_our_options() -> None:
    theirs = pyardrone_navdata.NavData(
        encode_navdata(0, 1, [kind() for kind in options.OPTION_TYPES])
    )
    assert theirs.magneto.magneto_radius == 0.0


def test_pyardrone_reads_the_fields_where_we_write_them() -> None:
    sent = [
        options.RawMeasures(battery_millivolts=11686, altitude_raw=243),
        options.KalmanPressure(ground_effect=1, innovation_sum=2.5, gaz_altitude=7.5),
        options.References(ui_sequence=-3),
        options.Magneto(radius=9.5),
        options.Pwm(motors=(1, 2, 3, 4), altitude_derivative=0.25),
    ]
    theirs = pyardrone_navdata.NavData(encode_navdata(0, 1, sent))
    assert (theirs.raw_measures.vbat_raw, theirs.raw_measures.alt_temp_raw) == (11686, 243)
    assert (
        theirs.kalman_pressure.bool_effet_sol,
        theirs.kalman_pressure.somme_inno,
        theirs.kalman_pressure.gaz_altitude,
    ) == (
        1,
        2.5,
        7.5,
    )
    assert (theirs.references.ui_seq, theirs.magneto.magneto_radius) == (-3, 9.5)
    assert (theirs.pwm.motor4, theirs.pwm.altitude_der) == (4, 0.25)


def test_pyardrone_refuses_what_is_wrong() -> None:
    # Proves that this judge can say no; its error types are its own.
    with pytest.raises(Exception):  # noqa: B017
        pyardrone_navdata.NavData(encode_navdata(0, 1, [RawOption(0, bytes(7))]))


def test_pyardrone_writes_commands_as_we_do() -> None:
    theirs = pytest.importorskip("pyardrone.at")
    pairs = [
        (
            at.Pcmd(at.PcmdFlag.PROGRESSIVE, 0.1, -0.2, 0.05, 1.0),
            theirs.PCMD(1, 0.1, -0.2, 0.05, 1.0),
        ),
        (at.Pcmd(), theirs.PCMD(0)),
        (at.Config("general:navdata_demo", "TRUE"), theirs.CONFIG("general:navdata_demo", "TRUE")),
        (
            at.ConfigIds("01234567", "89abcdef", "00000000"),
            theirs.CONFIG_IDS("01234567", "89abcdef", "00000000"),
        ),
        (at.Control(at.ControlMode.CLEAR_ACK), theirs.CTRL(5, 0)),
        (at.ComWatchdog(), theirs.COMWDG()),
        (at.FlatTrim(), theirs.FTRIM()),
        (at.Ref(at.RefBits.TAKE_OFF), theirs.REF(290718208)),
    ]
    for ours, other in pairs:
        assert at.encode_command(9, ours) == other._pack(9)
