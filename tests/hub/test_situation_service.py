"""What the detectors find is remembered, and what somebody took is with them."""

from __future__ import annotations

from housefly.hub.api.questions import EventsQuestion, WhereQuestion
from housefly.hub.situation_service import SituationService
from housefly.hub.things.thing import Thing, ThingKind
from housefly.messages import Observation, RoomEvent
from housefly.sites.loaded_site import open_site, read_site


def test_what_somebody_took_is_with_them_until_it_is_put_somewhere(house) -> None:
    loaded = open_site(read_site("bsen"))
    service = SituationService(loaded.site, loaded.room, house.memory, house.status)
    house.memory.world.add_thing(Thing("person-1", "the resident", ThingKind.PERSON))
    begin = house.now - 30.0
    for quarter in range(120):
        at = begin + 0.25 * quarter
        house.memory.add(
            Observation(
                "person-1", "floor-1", at, at, (11.3, 4.0, 0.0), facts=(("kind", "person"),)
            )
        )
        if quarter % 20 == 0:
            contents = "cup" if quarter < 60 else ""
            house.memory.add(
                Observation("cabinet", "cabinet", at, at, facts=(("contents", contents),))
            )
        if quarter == 50:
            house.memory.add(
                RoomEvent("object taken", "cup", at, "cabinet", facts=(("weight", 0.2),))
            )
        service.update(at)
    taken = [
        event
        for event in house.ask(EventsQuestion(thing="cup")).events
        if event.kind == "object taken"
    ]
    assert "person-1" in {event.cause for event in taken}
    answer = house.ask(WhereQuestion("cup"))
    assert answer.inside[0] == "person-1"
    assert answer.words.startswith("the red cup: with the resident")
    assert "person present" in {held.kind for held in house.status.situations()}
