"""Encoding the drone's pictures."""

from __future__ import annotations

from filming import RATE_HZ, SIZE, striped

from housefly.twin.camera.encoder import Encoder


def test_a_picture_that_stays_is_encoded_as_if_it_came_anew() -> None:
    numbers = [number for number in (0, 0, 1, 1, 0) for _ in range(5)]
    kept = {number: striped(number) for number in numbers}
    once, each = Encoder(*SIZE, RATE_HZ), Encoder(*SIZE, RATE_HZ)
    assert [once.encode(kept[number]) for number in numbers] == [
        each.encode(striped(number)) for number in numbers
    ]
