"""A store of 0.2.0 kept in sentences what are facts now; it is read all the same."""

from __future__ import annotations

from pathlib import Path

import pytest

from housefly.hub.situations.hysteresis import UNKNOWN
from housefly.hub.store.open import open_store
from housefly.messages import Facts, RoomEvent


@pytest.mark.parametrize(
    ("kind", "kept", "added"),
    [
        (
            "person lying",
            (("evidence", "bed: load 58.0 kg; last seen beside bed; floor-1: in bed"),),
            (("sources", "bed,floor-1"),),
        ),
        ("person fallen", (("evidence", "nobody saw how"),), (("sources", ""),)),
        ("bed occupied ended", (("because", "not known any more"), ("lasted", 5.0)), (UNKNOWN,)),
        ("bed occupied ended", (("because", "bed: load 0.0 kg"), ("lasted", 5.0)), ()),
        ("person lying", (("evidence", "bed: load 58.0 kg"), ("sources", "bed-2")), ()),
        ("a", (("refused", "open is 'ajar'; allowed: true"),), (("refused_key", "open"),)),
    ],
)
def test_what_stood_in_a_sentence_is_a_fact(
    tmp_path: Path, kind: str, kept: Facts, added: Facts
) -> None:
    event = RoomEvent(kind, "ann", 1.0, "situations/people", facts=kept)
    store = open_store(tmp_path / "room.db")
    store.write((), [event])
    (read,) = store.events(0.0, 2.0)
    assert read.facts == (*kept, *added)
    store.close()
