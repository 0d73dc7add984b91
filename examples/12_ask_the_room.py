"""Let somebody live in the simulated room for two minutes, then ask what happened.

Needs: nothing beside Housefly itself.
Learns: devices speak MQTT payloads; what they tell becomes observations; detectors make situations
    of them; the memory answers. A running room, `housefly.connect()`, is asked in the same way.
Prints: what is remembered of the cup, where it is now and where it was, and who was at the door.
"""

import housefly

with housefly.play_scene(housefly.load_site("bsen")) as room:
    print("now: ", room.where("cup").words)
    print("then:", room.where("cup", at=room.begin + 45.0).words)
    print("in the cabinet:", ", ".join(thing.name for thing in room.contents("cabinet")))

    names = {one.thing: one.name for one in room.things()}
    for event in room.events(thing="cup"):
        words = f"{event.kind}{' by ' + names[event.cause] if event.cause else ''}"
        print(f"  {event.at - room.begin:5.1f} s  {names['cup']}: {words}  [{event.source}]")
    for event in room.events(kind="someone at the entrance"):
        words = f"{event.kind}, {100 * event.confidence:.0f} % sure"
        evidence = event.facts.get("evidence", "")
        print(f"  {event.at - room.begin:5.1f} s  {words}: {evidence}")
