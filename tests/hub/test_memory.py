"""What the room was told is there after a restart, and nothing that contradicts itself is kept."""

from __future__ import annotations

import subprocess
import sys
import time
from pathlib import Path

import pytest

from housefly.hub.api.questions import WhereQuestion
from housefly.hub.store.backlog import Dropped
from housefly.hub.things.thing import Thing, ThingKind
from housefly.messages import Observation, RoomEvent


def test_after_a_restart_it_knows_what_it_knew(house) -> None:
    house.see("cup", 60.0, (1.0, 2.0, 3.0))
    house.see("parcel", 50.0, inside="kitchen", source="door")
    house.memory.close()
    house.open()
    assert house.ask(WhereQuestion("cup")).position == (1.0, 2.0, 3.0)
    assert house.ask(WhereQuestion("parcel")).inside == ("kitchen",)


def test_the_catalogue_of_today_replaces_that_of_yesterday(house) -> None:
    house.memory.close()
    house.open((Thing("cup", "the blue cup", ThingKind.OBJECT),))
    assert house.ask(WhereQuestion("cup")).name == "the blue cup"


def test_what_would_be_inside_itself_is_refused_and_told_to_nobody(house, noon: float) -> None:
    told: list[object] = []
    house.memory.add_listener(told.append)
    house.see("kitchen", 1.0, inside="cup")
    assert told == []
    assert "kitchen" in house.memory.refused[-1]
    house.memory.add(RoomEvent("door opened", "cabinet", noon, "test"))
    assert len(told) == 1


def test_two_threads_may_tell_and_ask_at_once(house) -> None:
    from threading import Thread

    def tell() -> None:
        for number in range(2000):
            house.memory.add(
                Observation(
                    "drone",
                    "vicon",
                    house.now + number * 0.01,
                    house.now,
                    (float(number), 0.0, 1.0),
                )
            )

    teller = Thread(target=tell)
    teller.start()
    answers = [house.ask(WhereQuestion("drone")).position for _ in range(300)]
    teller.join()
    assert all(position is not None for position in answers)
    assert house.ask(WhereQuestion("drone")).position == (1999.0, 0.0, 1.0)


@pytest.mark.slow
def test_taking_never_waits_for_a_store_that_is_locked(house) -> None:
    import sqlite3

    other = sqlite3.connect(house.file, isolation_level=None)
    house.memory.flush()
    other.execute("BEGIN EXCLUSIVE")
    start = time.monotonic()
    for number in range(1000):
        house.see("drone", 100.0 - 0.1 * number, (float(number), 0.0, 1.0))
    waited = time.monotonic() - start
    other.execute("ROLLBACK")
    other.close()
    assert waited < 1.0
    assert house.memory.writer.flush(10.0)
    assert house.memory.writer.dropped() == Dropped()


LEAVING = """
import sys, threading, time
from housefly.errors import StoreError
from housefly.hub.memory import RoomMemory
from housefly.messages import RoomEvent
from housefly.hub.store.open import open_store
from housefly.hub.things.thing import Thing

def ask(memory):
    try:
        while True:
            with memory.store() as store:
                store.events(0.0, 1e12)
    except StoreError:
        refused.append(memory)

refused = []
for leaving in range(100):
    memory = RoomMemory([Thing("cup", "the cup")], lambda: open_store(sys.argv[1]))
    for number in range(0 if leaving else 2000):
        memory.add(RoomEvent("object put", "cup", time.time(), "cabinet"))
    memory.flush()
    asking = [threading.Thread(target=ask, args=(memory,)) for _ in range(3)]
    for thread in asking:
        thread.start()
    time.sleep(0.0002 * leaving)
    memory.close()
    for thread in asking:
        thread.join()
print(len(refused))
"""


@pytest.mark.slow
def test_leaving_while_somebody_asks_for_the_past_refuses_the_next_question_in_words(
    tmp_path: Path,
) -> None:
    left = subprocess.run(
        [sys.executable, "-c", LEAVING, str(tmp_path / "room.db")],
        capture_output=True,
        text=True,
        check=False,
    )
    assert (left.returncode, left.stdout.strip()) == (0, "300"), left.stderr
