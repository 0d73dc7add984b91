"""What the lines of the bridge's child become."""

from __future__ import annotations

import json
from contextlib import suppress

from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import LinkError, WireError
from housefly.tracking.bridge_lines import BridgeLines
from housefly.tracking.counts import FrameCounts


def lines() -> tuple[BridgeLines, FrameCounts]:
    counts = FrameCounts()
    return BridgeLines(0.02, False, counts), counts


def line(**bodies: object) -> bytes:
    return json.dumps({"bodies": bodies}).encode()


@given(
    st.binary(max_size=100)
    | st.recursive(st.none() | st.floats() | st.text(), st.lists).map(
        lambda v: json.dumps(v).encode()
    )
)
def test_any_line_is_a_frame_or_a_named_error(text: bytes) -> None:
    with suppress(WireError, LinkError):
        lines()[0].read(text, 1.0)


def test_a_pose_that_is_the_last_one_to_the_bit_is_not_told_again() -> None:
    reader, counts = lines()
    here, there = [1.0, 2.0, 1.0, 1.0, 0.0, 0.0, 0.0], [1.5, 2.0, 1.0, 1.0, 0.0, 0.0, 0.0]
    assert len(reader.read(line(a=here, b=here), 1.0) or ()) == 2
    assert reader.read(line(a=here, b=here), 1.1) is None
    assert [seen.body for seen in reader.read(line(a=here, b=there), 1.2) or ()] == ["b"]
    assert (counts.frames, counts.repeated) == (2, 1)


def test_poses_that_cannot_be_are_refused() -> None:
    reader, counts = lines()
    assert reader.read(line(a=[float("nan"), 0, 0, 1, 0, 0, 0], b=[0, 0, 0, 0, 0, 0, 0]), 1.0) == ()
    assert counts.refused == 2
