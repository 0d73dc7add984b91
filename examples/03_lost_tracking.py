"""Take the motion capture away for three seconds in mid-flight.

Learns: the last gate watches the age of the pose. Older than 0.25 s: the drone holds itself. Older
    than 2 s: it lands, and a
landing once begun is kept although the tracking comes back.
Prints: each change of the gate's verdict with its reason, and every event that people are told.
"""

from housefly.app.loaded_site import open_site, read_site
from housefly.messages import Inputs, Order, OrderKind, Phase, SafetyMode
from housefly.pilot.assembly import make_pilot
from housefly.twin.lockstep import LockstepRoom
from housefly.twin.world import SimulatedWorld

LOST_FROM, LOST_TO = 15.0, 18.0

loaded = open_site(read_site("bsen"))
pilot = make_pilot(loaded.site, loaded.room, loaded.grid)
room = LockstepRoom(SimulatedWorld(loaded.site, loaded.room), loaded.site)
mode, ordered = SafetyMode.NOMINAL, False

while room.now < 40.0:
    room.advance(0.01)
    sightings = room.sightings()
    if LOST_FROM <= room.now < LOST_TO:
        sightings = ()
    orders: tuple[Order, ...] = ()
    if not ordered and room.now > 0.5:
        orders, ordered = (Order(OrderKind.GO, place="entrance", issued_at=room.now),), True
    outputs = pilot.step(room.now, Inputs(sightings, room.telemetry(), orders))
    room.send(outputs.command)
    for event in outputs.events:
        print(f"{room.now:6.2f} s  event     {event.text}")
    if outputs.safety is not mode:
        mode = outputs.safety
        print(
            f"{room.now:6.2f} s  verdict   {mode.value}: {outputs.command.action.value};"
            f" {outputs.reason or 'all is well'}"
        )
    if ordered and outputs.phase is Phase.IDLE and room.now > LOST_TO:
        break
