"""Payloads of devices: whatever comes is understood or refused by name."""

from __future__ import annotations

import json
from math import isfinite

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import WireError
from housefly.messages import Observation
from housefly.wires.devices import (
    KINDS,
    MAX_DEVICE_PAYLOAD,
    Channel,
    ClockBounds,
    Delivered,
    DeviceAddress,
    Placement,
    Reading,
    decode_reading,
    encode_payload,
)
from housefly.wires.devices.fields import FlagField, IdField, NumberField, RowsField

NOW = 1_800_000_000.0
GOOD: dict[str, dict[str, object]] = {
    "floor": {
        "people": [{"id": "person-1", "x": 3, "y": 4, "sigma": 0.1, "weight": 61.5, "extent": 0.3}],
        "objects": [{"x": 1, "y": 2}],
    },
    "cabinet": {
        "items": [{"tag": "E2-01", "weight": 0.21, "shelf": 2, "x": 0.1, "y": 0.0, "z": 0.6}],
        "load": 0.21,
    },
    "refrigerator": {"open": False, "items": [{"tag": "E2-02"}], "temperature_c": 4.5},
    "bed": {"load": 62.0},
    "door": {"open": True},
    "doorbell": {},
    "motion": {"motion": True},
    "switch": {"state": "ON"},
    "power": {"power": 1420.0},
    "temperature": {"temperature": 21.5},
    "contact": {"contact": True},
    "level": {"level": 35.0},
}
kinds = st.sampled_from(sorted(KINDS))
json_values = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats(allow_nan=False, allow_infinity=False)
    | st.text(),
    lambda inner: (
        st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=8), inner, max_size=4)
    ),
    max_leaves=12,
)


def message(
    kind: str,
    payload: bytes | dict[str, object],
    channel: Channel = Channel.STATE,
    retained: bool = False,
) -> Delivered:
    data = payload if isinstance(payload, bytes) else json.dumps(payload).encode()
    return Delivered(DeviceAddress("bsen", kind, f"{kind}-1"), channel, data, NOW, retained)


def assert_sane(reading: Reading) -> None:
    for seen in reading.observations:
        assert isfinite(seen.captured_at) and seen.captured_at <= seen.received_at == NOW
        assert seen.position is None or all(map(isfinite, seen.position))


@given(kinds, st.sampled_from(Channel), st.binary(max_size=200), st.booleans())
def test_any_bytes_become_observations_or_a_wire_error(
    kind: str, channel: Channel, payload: bytes, retained: bool
) -> None:
    try:
        assert_sane(decode_reading(message(kind, payload, channel, retained)))
    except WireError as error:
        assert f"housefly/bsen/{kind}/{kind}-1/{channel.value}" in str(error)


@given(kinds, st.sampled_from(Channel), json_values, st.booleans())
def test_any_json_becomes_observations_or_a_wire_error(
    kind: str, channel: Channel, tree: object, retained: bool
) -> None:
    try:
        assert_sane(decode_reading(message(kind, json.dumps(tree).encode(), channel, retained)))
    except WireError as error:
        assert len(str(error)) < 400


@given(kinds, st.data())
def test_any_value_under_a_known_key_is_understood_or_refused_by_the_name_of_its_key(
    kind: str, data: st.DataObject
) -> None:
    spec = KINDS[kind].state_spec()
    key = data.draw(st.sampled_from(sorted(spec)))
    tree = {**GOOD[kind], key: data.draw(json_values)}
    try:
        assert_sane(decode_reading(message(kind, json.dumps(tree).encode())))
    except WireError as error:
        assert f"/state.{key}" in str(error)


@given(
    kinds, st.dictionaries(st.from_regex(r"x-[a-z]{1,5}", fullmatch=True), json_values, max_size=5)
)
def test_unknown_keys_are_counted_and_change_nothing(kind: str, extra: dict[str, object]) -> None:
    plain, more = (
        decode_reading(message(kind, GOOD[kind])),
        decode_reading(message(kind, json.dumps({**GOOD[kind], **extra}).encode())),
    )
    assert more.observations == plain.observations
    assert sorted(more.unknown) == sorted(extra)


@given(st.floats(min_value=-1e5, max_value=1e5), st.booleans())
def test_a_time_outside_the_bounds_is_refused_and_one_inside_is_kept(
    offset: float, retained: bool
) -> None:
    bounds = ClockBounds(ahead=2.0, behind=60.0)
    reading = decode_reading(
        message("door", {"open": True, "time": NOW + offset}, retained=retained), bounds=bounds
    )
    (door,) = reading.observations
    offset = NOW + offset - NOW
    if offset > 2.0 or (offset < -60.0 and not retained):
        assert (door.captured_at, reading.clock_error) == (NOW, offset)
        assert dict(door.facts)["clock_error"] == offset
    else:
        assert (door.captured_at, reading.clock_error) == (min(NOW, NOW + offset), None)


@pytest.mark.parametrize("told", [0.0, 12.5, 946_684_800.0])
def test_a_clock_that_was_never_set_is_not_believed_even_of_a_kept_state(told: float) -> None:
    reading = decode_reading(message("door", {"open": True, "time": told}, retained=True))
    assert reading.observations[0].captured_at == NOW
    assert reading.clock_error == told - NOW


@given(st.floats(-100, 100), st.floats(-100, 100), st.floats(-3.1, 3.1))
def test_a_floor_sensor_that_stands_askew_reports_in_the_world(
    x: float, y: float, yaw: float
) -> None:
    tree = {"people": [{"x": x, "y": y}]}
    back = (
        decode_reading(message("floor", tree), Placement((1.0, 2.0, 0.0), yaw))
        .observations[1]
        .position
    )
    assert back is not None
    assert (back[0] - 1.0) ** 2 + (back[1] - 2.0) ** 2 == pytest.approx(x * x + y * y, abs=1e-6)


@pytest.mark.parametrize("kind", sorted(KINDS))
def test_every_kind_has_a_state_that_reads_and_says_something_of_the_device_itself(
    kind: str,
) -> None:
    reading = decode_reading(
        Delivered(DeviceAddress("bsen", kind, "it"), Channel.STATE, encode_payload(GOOD[kind]), NOW)
    )
    assert reading.observations[0].thing == reading.observations[0].source == "it"


@pytest.mark.parametrize(
    ("kind", "word"), [(kind.name, word) for kind in KINDS.values() for word in kind.events]
)
def test_every_event_becomes_a_room_event_and_a_kept_one_nothing(kind: str, word: str) -> None:
    tag = {"tag": "E2-01", "weight": 0.2} if word in ("taken", "put") else {}
    event = {"event": word, **tag}
    (told,) = decode_reading(
        message(kind, event, Channel.EVENT), Placement(things={"E2-01": "cup"})
    ).events
    assert told.kind == KINDS[kind].events[word]
    assert told.thing == ("cup" if tag else f"{kind}-1")
    assert told.source == f"{kind}-1"
    assert decode_reading(message(kind, event, Channel.EVENT, retained=True)).events == ()


def test_a_thing_in_the_cabinet_is_known_by_its_tag_with_weight_and_place() -> None:
    placement = Placement((10.0, 5.0, 0.0), 0.0, {"E2-01": "cup"})
    cabinet, cup = decode_reading(message("cabinet", GOOD["cabinet"]), placement).observations
    assert dict(cabinet.facts) == {"load": 0.21, "contents": "cup"}
    assert (cup.thing, cup.inside, cup.position) == ("cup", "cabinet-1", (10.1, 5.0, 0.6))
    assert dict(cup.facts) == {"weight": 0.21, "shelf": 2.0}


def test_people_on_the_floor_have_a_covariance_and_the_nameless_a_number() -> None:
    floor, person, thing = decode_reading(message("floor", GOOD["floor"])).observations
    assert dict(floor.facts) == {"people": 1.0, "objects": 1.0}
    assert person == Observation(
        "person-1",
        "floor-1",
        NOW,
        NOW,
        (3.0, 4.0, 0.0),
        covariance=(
            0.010000000000000002,
            0.0,
            0.0,
            0.010000000000000002,
            0.0,
            0.010000000000000002,
        ),
        facts=(("kind", "person"), ("weight", 61.5), ("extent", 0.3)),
    )
    assert thing.thing == "floor-1-object-1"


@pytest.mark.parametrize(
    ("load", "said", "occupied"), [(62.0, None, True), (3.0, None, False), (62.0, False, False)]
)
def test_a_bed_knows_whether_somebody_lies_in_it(
    load: float, said: bool | None, occupied: bool
) -> None:
    (bed,) = decode_reading(message("bed", {"load": load, "occupied": said})).observations
    assert dict(bed.facts)["occupied"] is occupied


@pytest.mark.parametrize(
    ("kind", "tree", "words"),
    [
        ("bed", {"load": 900}, "/state.load is 900; allowed: a number from -5 to 500 kg"),
        ("bed", {"load": True}, "load is True; allowed: a number"),
        ("bed", {}, "load is missing"),
        ("floor", {"people": [{"x": 1, "y": 1}] * 65}, "a list of up to 64 objects"),
        ("motion", [], "is []; allowed: a JSON object"),
    ],
)
def test_a_bad_field_is_named_with_what_is_allowed(kind: str, tree: object, words: str) -> None:
    with pytest.raises(WireError) as raised:
        decode_reading(message(kind, json.dumps(tree).encode()))
    assert words in str(raised.value)
    assert f"housefly/bsen/{kind}/{kind}-1/state" in str(raised.value)


@pytest.mark.parametrize(
    ("kind", "tree", "refused", "told"),
    [
        ("cabinet", {"items": [{"tag": "a"}, {"tag": "b c"}], "open": True},
         "items[1].tag is 'b c'; allowed: an id", {"cabinet-1": {"open": True}, "a": {}}),
        ("cabinet", {"items": [{"tag": "a", "weight": -1, "shelf": 2}]},
         "items[0].weight is -1; allowed: a number from 0 to 200 kg",
         {"cabinet-1": {"contents": "a"}, "a": {"shelf": 2.0}}),
        ("floor", {"people": [{"x": 1}, {"id": "ann", "x": 1, "y": 2}]}, "people[0].y is missing",
         {"floor-1": {"objects": 0.0}, "ann": {"kind": "person"}}),
        ("refrigerator", {"open": "ajar", "items": [], "temperature_c": "4,5"},
         "open is 'ajar'; allowed: true or false",
         {"refrigerator-1": {"temperature_c": 4.5, "contents": ""}}),
        ("bed", {"load": None, "occupied": True}, "load is null: the device does not know it",
         {"bed-1": {"occupied": True}}),
        ("door", {"open": True, "battery": 93}, "battery is 93; allowed: a number from 0 to 1",
         {"door-1": {"open": True}}),
    ],
)  # fmt: skip
def test_a_bad_value_is_named_and_its_neighbours_are_heard(
    kind: str, tree: dict[str, object], refused: str, told: dict[str, dict[str, object]]
) -> None:
    reading = decode_reading(message(kind, tree))
    (complaint,) = reading.refused
    assert complaint.startswith(f"housefly/bsen/{kind}/{kind}-1/state.{refused}")
    assert all(seen.valid for seen in reading.observations)
    facts = {seen.thing: dict(seen.facts) for seen in reading.observations}
    notes = [refused in str(own.pop("refused", "")) for own in facts.values()]
    keys = {own.pop("refused_key") for own in facts.values() if "refused_key" in own}
    assert all(refused.startswith(str(key)) for key in keys)
    assert facts == told
    assert all(notes) is ("battery" not in refused)


@pytest.mark.parametrize("said", ["ajar", "opne", 2, None, "unknown", [True]])
def test_a_state_that_a_kind_does_not_know_is_no_state_and_ends_the_one_before(
    said: object,
) -> None:
    reading = decode_reading(message("door", {"open": said}))
    (seen,) = reading.observations
    assert not seen.valid and not reading.is_understood
    assert [name for name, _ in seen.facts] == ["refused", "refused_key"]


@pytest.mark.parametrize(
    ("text", "load"),
    [("62.5", 62.5), ("62,5", 62.5), (" 62 ", 62.0), ("62.5 kg", 62.5), ("0,125", 0.125),
     ("+6.25e1", 62.5), ("1,420", None), ("1 420", None), ("62.5 g", None), ("6.2.5", None),
     ("1.420,5", None), ("0x3e", None), ("--1", None)],
)  # fmt: skip
def test_a_plain_number_in_quotes_is_read_and_one_of_two_meanings_is_not(
    text: str, load: float | None
) -> None:
    if load is not None:
        (bed,) = decode_reading(message("bed", {"load": text})).observations
        assert dict(bed.facts)["load"] == load
        return
    with pytest.raises(WireError, match=r"load is '.*'; allowed: a number from -5 to 500 kg"):
        decode_reading(message("bed", {"load": text}))


@pytest.mark.parametrize(
    "payload",
    [
        b"",
        b"\xff",
        b'{"open": NaN}',
        b"[" * 10_000,
        b'{"load": 1e999}',
        b'{"load": ' + b"9" * 5000 + b"}",
        b" " * (MAX_DEVICE_PAYLOAD + 1),
    ],
)
def test_what_is_not_json_is_refused(payload: bytes) -> None:
    with pytest.raises(WireError, match="housefly/bsen/bed/bed-1/state"):
        decode_reading(message("bed", payload))


def test_an_unknown_kind_is_told_the_known_ones() -> None:
    with pytest.raises(WireError, match="unknown kind of device; known: floor, cabinet"):
        decode_reading(message("toaster", b"{}"))


@pytest.mark.parametrize(("payload", "online"), [(b"online", True), (b"offline", False)])
def test_presence_is_one_word(payload: bytes, online: bool) -> None:
    for written in (payload, payload.title(), b'"' + payload + b'"'):
        assert decode_reading(message("door", written, Channel.AVAILABILITY)).online is online
    with pytest.raises(WireError, match="allowed: online or offline"):
        decode_reading(message("door", payload + b"?", Channel.AVAILABILITY))


def test_every_number_of_every_table_has_a_unit_or_is_a_share_and_every_kind_a_heartbeat() -> None:
    for kind in KINDS.values():
        for key, row in [*kind.state_spec().items(), *kind.event_spec().items()]:
            assert isinstance(row, FlagField | IdField | RowsField) or row.check is not None
            assert (
                not isinstance(row, NumberField) or row.unit or (row.low, row.high) == (0.0, 1.0)
            ), key
        assert 0.5 <= kind.heartbeat <= 300.0
