"""A pad under a wall shelf, 0.95 m above the floor, in the simulated room."""

from __future__ import annotations

from dataclasses import replace

from housefly.lab.lockstep.simulation import Simulation
from housefly.messages import OrderKind
from housefly.messages.flight import Order
from housefly.pilot.assembly import make_pilot
from housefly.sites.loaded_site import load_site

UNDER_THE_SHELF = (7.5, 0.8)
"""Half of the drone is below the board [m]."""


def struck_in_take_off(*, is_modelled: bool) -> tuple[list[str], list[str]]:
    """Return what a drone under the shelf strikes when told to take off, and what its pilot says.

    Its room model may lack the shelf.
    """
    loaded = load_site("bsen", hub__enabled=False)
    room = replace(loaded.room, home=UNDER_THE_SHELF)
    simulation = Simulation(replace(loaded, room=room))
    solids = tuple(s for s in room.solids if is_modelled or not s.name.startswith("wall shelf"))
    simulation.pilot = make_pilot(loaded.site, replace(room, solids=solids), loaded.grid)
    told, is_ordered = list[str](), False
    while simulation.now < 5.0:
        simulation.advance()
        orders = (Order(OrderKind.TAKE_OFF),) if simulation.now > 0.5 and not is_ordered else ()
        is_ordered = is_ordered or bool(orders)
        told += [event.text for event in simulation.step(simulation.inputs(*orders)).outputs.events]
    return [contact.name for contact in simulation.world.contact_log], told


def test_a_drone_under_a_shelf_does_not_take_off() -> None:
    struck, told = struck_in_take_off(is_modelled=True)
    assert struck == [] and any("something hangs over the drone" in words for words in told)


def test_a_shelf_that_the_room_model_lacks_is_struck_from_below() -> None:
    struck, _ = struck_in_take_off(is_modelled=False)
    assert any(name.startswith("wall shelf") for name in struck)
