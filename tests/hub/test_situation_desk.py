"""What the detectors find is remembered, and what somebody took is with them."""

from __future__ import annotations

from housefly.app.premises import open_premises, read_site
from housefly.hub.api.questions import Events, Where
from housefly.hub.situation_desk import SituationDesk
from housefly.hub.things.thing import Kind, Thing
from housefly.messages import Happening, Observation


def test_what_somebody_took_is_with_them_until_it_is_put_somewhere(house) -> None:
    premises = open_premises(read_site("bsen"))
    desk = SituationDesk(premises.site, premises.room, house.memory, house.present)
    house.memory.know(Thing("person-1", "the resident", Kind.PERSON))
    begin = house.now - 30.0
    for quarter in range(120):
        at = begin + 0.25 * quarter
        house.memory.take(
            Observation(
                "person-1", "floor-1", at, at, (11.3, 4.0, 0.0), facts=(("kind", "person"),)
            )
        )
        if quarter % 20 == 0:
            contents = "cup" if quarter < 60 else ""
            house.memory.take(
                Observation("cabinet", "cabinet", at, at, facts=(("contents", contents),))
            )
        if quarter == 50:
            house.memory.take(
                Happening("object taken", "cup", at, "cabinet", facts=(("weight", 0.2),))
            )
        desk.step(at)
    taken = [
        event for event in house.ask(Events(thing="cup")).events if event.kind == "object taken"
    ]
    assert "person-1" in {event.cause for event in taken}
    answer = house.ask(Where("cup"))
    assert answer.inside[0] == "person-1"
    assert answer.words.startswith("the red cup: with the resident")
    assert "person present" in {held.kind for held in house.present.situations()}
