"""AT commands: what we write, what we tolerate, what we refuse."""

from __future__ import annotations

import struct
from typing import get_args

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import WireError
from housefly.wires.ardrone import at

FLOAT_BITS = {
    0.05: 1028443341,
    0.1: 1036831949,
    0.2: 1045220557,
    0.5: 1056964608,
    0.8: 1061997773,
    1.0: 1065353216,
    -0.05: -1119040307,
    -0.1: -1110651699,
    -0.2: -1102263091,
    -0.5: -1090519040,
    -0.8: -1085485875,
    -1.0: -1082130432,
}

singles = st.floats(width=32, allow_nan=False, allow_infinity=False)
small_ints = st.integers(-(2**31), 2**31 - 1)
words = st.text(
    st.characters(min_codepoint=32, max_codepoint=126, exclude_characters='"'), max_size=60
)
moves = (st.builds(at.PcmdFlag, st.integers(0, 7)), singles, singles, singles, singles)
commands = st.one_of(
    st.builds(at.Ref, st.builds(at.RefBits, st.sampled_from([0, 256, 512, 768]))),
    st.builds(at.Pcmd, *moves),
    st.builds(at.PcmdMag, *moves, singles, singles),
    st.just(at.FlatTrim()),
    st.builds(at.Calibrate, small_ints),
    st.builds(at.Config, words, words),
    st.builds(at.ConfigIds, words, words, words),
    st.builds(at.Control, small_ints, small_ints),
    st.just(at.ComWatchdog()),
    st.builds(at.Led, small_ints, singles, small_ints),
    st.builds(at.Animation, small_ints, small_ints),
    st.builds(at.Pmode, small_ints),
    st.builds(at.Misc, small_ints, small_ints, small_ints, small_ints),
    st.builds(
        at.Other, st.sampled_from(sorted(at.KNOWN_BY_NAME)), st.tuples(st.just("7"), st.just("-1"))
    ),
)


@pytest.mark.parametrize(("value", "bits"), FLOAT_BITS.items())
def test_a_float_travels_as_the_integer_with_its_bits(value: float, bits: int) -> None:
    assert at.float_to_bits(value) == bits
    assert at.bits_to_float(bits) == struct.unpack("<f", struct.pack("<f", value))[0]


@pytest.mark.parametrize(
    ("command", "number"),
    [
        (at.Ref(at.RefBits.LAND), 290717696),
        (at.Ref(at.RefBits.TAKE_OFF), 290718208),
        (at.Ref(at.RefBits.EMERGENCY), 290717952),
    ],
)
def test_ref_carries_the_constant_bits(command: at.Ref, number: int) -> None:
    assert at.encode_command(7, command) == f"AT*REF=7,{number}\r".encode()


def test_the_form_of_each_command_on_the_wire() -> None:
    assert (
        at.encode_command(1, at.Pcmd(at.PcmdFlag.PROGRESSIVE, -0.8, 0, 0, 0))
        == b"AT*PCMD=1,1,-1085485875,0,0,0\r"
    )
    assert (
        at.encode_command(2, at.Config("general:navdata_demo", "TRUE"))
        == b'AT*CONFIG=2,"general:navdata_demo","TRUE"\r'
    )
    assert (
        at.encode_command(3, at.ConfigIds("aabbccdd", "00000001", "00000002"))
        == b'AT*CONFIG_IDS=3,"aabbccdd","00000001","00000002"\r'
    )
    assert at.encode_command(4, at.Control(at.ControlMode.CLEAR_ACK)) == b"AT*CTRL=4,5,0\r"
    assert at.encode_command(5, at.ComWatchdog()) == b"AT*COMWDG=5\r"
    assert at.encode_command(6, at.Misc()) == b"AT*MISC=6,2,20,2000,3000\r"


@given(st.lists(commands, max_size=6), st.integers(0, 2**30))
def test_what_we_write_we_read_back(sent: list[at.AtCommand], first: int) -> None:
    parsed = at.parse_datagram(at.encode_datagram(first, sent))
    assert parsed.rejects == ()
    assert [numbered.command for numbered in parsed.commands] == sent
    assert [numbered.sequence for numbered in parsed.commands] == list(
        range(first, first + len(sent))
    )


def test_every_command_value_can_be_written() -> None:
    tried = {type(strategy_example) for strategy_example in _one_of_each()}
    assert tried == set(get_args(at.AtCommand))


def _one_of_each() -> list[at.AtCommand]:
    blanks = (
        at.Ref(),
        at.Pcmd(),
        at.PcmdMag(),
        at.FlatTrim(),
        at.Calibrate(),
        at.Config("a", "b"),
        at.ConfigIds("", "", ""),
    )
    more = (
        at.Control(4),
        at.ComWatchdog(),
        at.Led(1, 2.0, 3),
        at.Animation(1, 2),
        at.Pmode(),
        at.Misc(),
        at.Other("ZAP"),
    )
    written = [
        at.parse_datagram(at.encode_command(1, command)).commands[0].command
        for command in (*blanks, *more)
    ]
    assert written == [*blanks, *more]
    return written


@pytest.mark.parametrize(
    ("datagram", "expected"),
    [
        (b"AT*COMWDG=3,\r", [at.ComWatchdog()]),
        (b"AT*FTRIM=2,\r", [at.FlatTrim()]),
        (b"AT*REF=1,512\r", [at.Ref(at.RefBits.TAKE_OFF)]),
        (b"AT*REF=1,0\r", [at.Ref(at.RefBits.LAND)]),
        (b"AT*REF=1,256\r", [at.Ref(at.RefBits.EMERGENCY)]),
        (b"\r", []),
        (b"", []),
        (b"AT*CTRL=0,5\r", [at.Control(5)]),
        (b"AT*CTRL=0,5,0\n", [at.Control(5)]),
        (b"AT*COMWDG=1\r\nAT*COMWDG=2\r\n", [at.ComWatchdog(), at.ComWatchdog()]),
        (b"AT*COMWDG=1\r\0\0", [at.ComWatchdog()]),
        (b"AT*COMWDG=1", [at.ComWatchdog()]),
        (
            b'AT*CONFIG=1,"leds:leds_anim","3,1073741824,2"\r',
            [at.Config("leds:leds_anim", "3,1073741824,2")],
        ),
    ],
)
def test_the_parser_tolerates_what_clients_send(
    datagram: bytes, expected: list[at.AtCommand]
) -> None:
    parsed = at.parse_datagram(datagram)
    assert [numbered.command for numbered in parsed.commands] == expected
    assert parsed.rejects == ()


@pytest.mark.parametrize(
    ("line", "why"),
    [
        (b"AT*FOO=1,2", "unknown command"),
        (b"AT*REF=1", "takes 1 arguments, got 0"),
        (b"AT*PCMD=1,1,0,0,0", "takes 5 arguments"),
        (b"AT*COMWDG=1,2", "takes 0 arguments"),
        (b"AT*PCMD=1,1,2139095040,0,0,0", "not finite"),
        (b"AT*PCMD=1,1,99999999999,0,0,0", "not an integer"),
        (b"AT*PCMD=1,1,9999999999,0,0,0", "32 bits"),
        (b"AT*REF=9999999999,512", "sequence number"),
        (b"AT*REF=-1,512", "form"),
        (b'AT*CONFIG=1,"a', "quotes"),
        (b"AT*REF=1,\xff", "ASCII"),
        (b"AT*COMWDG=1," + b" " * 1024, "at most 1024"),
    ],
)
def test_a_bad_line_is_refused_with_its_reason_and_spoils_no_other(line: bytes, why: str) -> None:
    parsed = at.parse_datagram(line + b"\rAT*COMWDG=9\r")
    assert [numbered.command for numbered in parsed.commands] == [at.ComWatchdog()]
    assert len(parsed.rejects) == 1
    assert why in parsed.rejects[0]


@given(st.binary(max_size=3000))
def test_no_bytes_make_the_parser_raise(datagram: bytes) -> None:
    at.parse_datagram(datagram)


pieces = st.sampled_from(
    [
        b"AT*",
        b"REF",
        b"PCMD",
        b"CONFIG",
        b"=",
        b",",
        b"1",
        b"-7",
        b'"',
        b"\r",
        b"\n",
        b"99999999999999",
        b"\xff",
        b" ",
    ]
)


@given(st.lists(pieces, max_size=60).map(b"".join))
def test_no_mixture_of_command_pieces_makes_the_parser_raise(datagram: bytes) -> None:
    at.parse_datagram(datagram)


@pytest.mark.parametrize(
    "command",
    [
        at.Config("a", 'x"y'),
        at.Config("a", "x\ry"),
        at.Config("ä", "x"),
        at.Config("a", "x" * 1024),
        at.Led(1, 1e39, 1),
    ],
)
def test_what_cannot_stand_on_the_wire_is_not_written(command: at.AtCommand) -> None:
    with pytest.raises(WireError):
        at.encode_command(1, command)
