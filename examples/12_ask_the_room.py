"""Let somebody live in the simulated room for two minutes, then ask where things are and what
happened.

Learns: devices speak MQTT payloads; what they tell becomes observations; detectors make situations
    of them; the memory answers.
Prints: what is remembered of the cup, where it is now and where it was, and who was at the door.
"""

import tempfile
import time
from pathlib import Path

from housefly.app.loaded_site import open_site, read_site
from housefly.hub.api.questions import ContentsQuestion, EventsQuestion, WhereQuestion
from housefly.hub.memory import RoomMemory
from housefly.hub.query_handler import QueryHandler
from housefly.hub.room_status import RoomStatus
from housefly.hub.situation_service import SituationService
from housefly.hub.store.open import open_store
from housefly.hub.things.catalogue import load_catalogue
from housefly.hub.things_of_room import things_of
from housefly.sites import __file__ as sites
from housefly.twin.people import load_scene
from housefly.twin.sensors.devices import SimulatedDevices
from housefly.wires.devices import Delivered, Placement, decode_reading

loaded = open_site(read_site("bsen"))
things = (
    *things_of(loaded.site, loaded.room),
    *load_catalogue(Path(sites).with_name("bsen_things.toml")),
)
scene = load_scene("bsen")
devices, tags = (
    SimulatedDevices(scene, "bsen"),
    Placement(things={thing.tag: thing.name for thing in scene.script.things}),
)

with tempfile.TemporaryDirectory() as folder:
    memory = RoomMemory(things, lambda: open_store(Path(folder) / "room.db"))
    present = RoomStatus(memory.writer.report)
    desk = SituationService(loaded.site, loaded.room, memory, present)
    begin = time.time() - scene.length
    for tick in range(round(scene.length / 0.05)):
        now = begin + 0.05 * tick
        for message in devices.messages(0.05 * tick, now):
            reading = decode_reading(
                Delivered(message.address, message.channel, message.payload, now), tags
            )
            for item in (*reading.observations, *reading.events):
                memory.take(item)
        desk.step(now)

    answers = QueryHandler(memory, present, lambda: begin + scene.length)
    print("now: ", answers.answer(WhereQuestion("cup")).words)
    print("then:", answers.answer(WhereQuestion("cup", at=begin + 45.0)).words)
    print(
        "in the cabinet:",
        ", ".join(thing.name for thing in answers.answer(ContentsQuestion("cabinet")).things),
    )
    for event in answers.answer(EventsQuestion(thing="cup")).events:
        print(
            f"  {event.at - begin:5.1f} s  cup:"
            f" {event.kind}{' by ' + event.cause if event.cause else ''}  [{event.source}]"
        )
    for event in answers.answer(EventsQuestion(kind="someone at the entrance")).events:
        print(
            f"  {event.at - begin:5.1f} s  {event.kind}, {100 * event.confidence:.0f} % sure:"
            f" {event.facts.get('evidence', '')}"
        )
    memory.close()
