"""SCIP: the manual's examples, round trips, and any bytes."""

from __future__ import annotations

import contextlib
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import WireError
from housefly.wires.scip import (
    URG_04LX,
    UST_10LX,
    MeasureRequest,
    PlainRequest,
    ScannerParameters,
    ScipReply,
    ScipRequest,
    decode_measurement,
    decode_reply,
    decode_request,
    encode_reply,
    encode_request,
    measurement_reply,
)
from housefly.wires.scip.characters import (
    checksum,
    decode_lines,
    decode_number,
    encode_lines,
    encode_number,
    strip_checksum,
)
from housefly.wires.scip.parameters import named_values
from housefly.wires.scip.requests import PLAIN_REQUESTS

notes = st.text("abcXYZ019 ._+@", max_size=16)
asks = st.builds(PlainRequest, st.sampled_from(sorted(PLAIN_REQUESTS)), notes)
steps = st.integers(0, 9999)
measures = st.builds(
    MeasureRequest,
    st.just("MD"),
    steps,
    steps,
    st.integers(0, 99),
    st.integers(0, 9),
    st.integers(0, 99),
    notes,
)
newest = st.builds(MeasureRequest, st.just("GD"), steps, steps, st.integers(0, 99), note=notes)


@pytest.mark.parametrize(
    ("value", "width", "text"), [(1234, 2, "CB"), (5432, 3, "1Dh"), (16000000, 4, "m2@0")]
)
def test_the_manuals_numbers_are_encoded_as_printed(value: int, width: int, text: str) -> None:
    assert encode_number(value, width) == text
    assert decode_number(text) == value


@pytest.mark.parametrize(
    "line",
    [
        "PROT:SCIP 2.0;N",
        "MODL:URG-04LX(Hokuyo Automatic Co.,Ltd.);N",
        "VEND:Hokuyo Automatic Co.,Ltd.;[",
        "PROD:SOKUIKI Sensor URG-04LX;[",
        "FIRM:3.2.00(28/Aug./2007);f",
        "SERI:H0508486;T",
        "DMIN:20;4",
        "DMAX:5600;_",
        "ARES:1024;\\",
        "AMIN:44;7",
        "AMAX:725;o",
        "AFRT:384;6",
        "SCAN:600;e",
        "LASR:OFF;7",
        "STAT:Sensor works well.;8",
        "MODL:UTM-30LX-EW;I",
        "ARES:1440;^",
        "AMIN:0;?",
        "AMAX:1080;Z",
        "AFRT:540;0",
        "SCAN:2400;U",
        "DMAX:60000;J",
    ],
)
def test_printed_lines_of_real_sensors_have_our_checksum(line: str) -> None:
    text, _, check = line.rpartition(";")
    assert checksum(text) == check
    assert named_values(ScipReply("PP", "00", (line,)))


@given(
    st.integers(1, 4).flatmap(
        lambda width: st.tuples(st.just(width), st.integers(0, (1 << 6 * width) - 1))
    )
)
def test_every_number_comes_back_and_one_too_large_is_refused(pair: tuple[int, int]) -> None:
    width, value = pair
    assert decode_number(encode_number(value, width)) == value
    with pytest.raises(WireError):
        encode_number(1 << 6 * width, width)


@given(st.lists(st.integers(0, (1 << 18) - 1), max_size=200))
def test_data_comes_back_from_lines_of_at_most_64_characters(values: list[int]) -> None:
    lines = encode_lines(values, 3)
    assert all(len(line) <= 65 for line in lines)
    assert decode_lines(lines, 3) == tuple(values)


@given(asks | measures | newest)
def test_every_request_comes_back(request: ScipRequest) -> None:
    assert decode_request(encode_request(request)[:-1]) == request


@given(
    st.integers(0, (1 << 24) - 1),
    st.lists(st.integers(0, (1 << 18) - 1), min_size=1, max_size=1081),
    st.integers(0, 99),
)
def test_every_scan_comes_back(stamp: int, ranges: list[int], count: int) -> None:
    request = MeasureRequest("MD", 100, 99 + len(ranges), 1, 0, count)
    found = decode_measurement(
        decode_reply(encode_reply(measurement_reply(request, stamp, tuple(ranges))))
    )
    assert found is not None
    assert (found.request, found.stamp, found.ranges) == (request, stamp, tuple(ranges))


@given(st.integers(0, 400), st.integers(1, 255))
def test_one_changed_character_of_a_scan_is_noticed(at: int, change: int) -> None:
    ranges = tuple(range(1000, 1100))
    data = bytearray(encode_reply(measurement_reply(MeasureRequest("MD", 0, 99), 4711, ranges)))
    at %= len(data)
    data[at] = (data[at] + change) % 256
    with contextlib.suppress(WireError):
        found = decode_measurement(decode_reply(bytes(data)))
        assert found is None or found.ranges == ranges


garbage = st.binary(max_size=300) | st.binary(max_size=200).map(
    lambda tail: b"MD0000000501000\n99b\n" + tail + b"\n\n"
)


@given(garbage)
def test_any_bytes_are_decoded_or_refused_with_a_wire_error(data: bytes) -> None:
    for decode in (
        decode_request,
        lambda d: decode_measurement(decode_reply(d)),
        lambda d: ScannerParameters.of(decode_reply(d)),
    ):
        with contextlib.suppress(WireError):
            decode(data)


@pytest.mark.parametrize("model", [URG_04LX, UST_10LX])
def test_parameters_come_back_and_senseless_ones_are_refused(model: ScannerParameters) -> None:
    assert ScannerParameters.of(decode_reply(encode_reply(model.reply()))) == model
    for change in ({"rpm": 0}, {"resolution": 0}, {"last": 0, "first": 5}, {"longest": 1}):
        with pytest.raises(WireError):
            ScannerParameters.of(replace(model, **change).reply())
    with pytest.raises(WireError):
        ScannerParameters.of(ScipReply("PP", "00", model.reply().lines[:-1]))


def test_the_angles_of_the_models_are_those_of_their_data_sheets() -> None:
    assert UST_10LX.first_angle == pytest.approx(-2.35619, abs=1e-4)
    assert UST_10LX.first_angle + (UST_10LX.beams - 1) * UST_10LX.step == pytest.approx(
        2.35619, abs=1e-4
    )
    assert UST_10LX.period == 0.025
    assert URG_04LX.beams == 682 and URG_04LX.period == 0.1


def test_a_wrong_checksum_is_named() -> None:
    with pytest.raises(WireError, match="checksum"):
        strip_checksum("00Q")
