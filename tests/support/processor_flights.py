"""Flies and replays what must have the same bits on every processor; run, it prints the digests."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

from housefly.app.loaded_site import load_site, open_site
from housefly.app.lockstep import fly_lockstep
from housefly.app.replaying import recorded_site
from housefly.config.site import Site
from housefly.lab.campaigns.plan import plan_campaign
from housefly.lab.campaigns.spec import spec_from_tree
from housefly.lab.experiments.engine import fly_many
from housefly.messages import Order, OrderKind
from housefly.pilot.assembly import make_pilot
from housefly.record.replay import read_steps
from housefly.tasks.vantage.search_places import belief_of
from housefly.tasks.vantage.thing_search import ThingSearch
from housefly.tasks.vantage.viewing_room import ViewingRoom

RECORDINGS = Path(__file__).parents[1] / "record" / "data"
QUICK = {"control__rate_hz": 50, "twin__mocap_rate_hz": 25}
SEEING = {
    "lasers": [{"name": "laser-1", "x": 13.9, "y": 3.3, "yaw": -2.6}],
    "depth_cameras": [{"name": "depth-1", "x": 10.5, "y": 1.25, "z": 1.6, "yaw": 2.75}],
}
MODES = {"default": SEEING, "paper": {"mode": "paper"}, "grid": {"map__planner": "grid"}}
CAMPAIGN = {
    "name": "small",
    "seeds": 10,
    "mission": {"waypoints": [[0.0, 0.0], [1.0, 0.0], [1.0, 0.7]], "task": "path", "duration_s": 8},
    "grid": {"mode": ["default", "paper"], "mocap_rate_hz": [10, 100]},
    "draw": {"lag": {"normal": [7.0, 1.0]}, "gust": {"loguniform": [0.01, 0.2]}},
}


def replayed(name: str) -> str:
    """Return the digest of what the pilot answers to an old recording."""
    site = open_site(recorded_site(RECORDINGS / name / "flight.mcap"))
    pilot, digest = make_pilot(site.site, site.room, site.grid), hashlib.sha256()
    for step in read_steps(RECORDINGS / name):
        digest.update(repr(pilot.step(step.now, step.inputs)).encode())
    return digest.hexdigest()


def flown(changes: dict[str, object]) -> str:
    """Return the digest of each step of a short service, and how it ended."""
    digest = hashlib.sha256()
    end = fly_lockstep(
        load_site("bsen", **(QUICK | changes)),
        Order(OrderKind.SERVICE, goal=(10.6, 3.4), look_s=0.5),
        lambda step: digest.update(repr(step).encode()),
    )
    return f"{end} {digest.hexdigest()}"


def drawn_and_flown() -> str:
    """Return the digest of the drones of a campaign and of their flights."""
    plan, digest = plan_campaign(spec_from_tree(CAMPAIGN), Site(), 20), hashlib.sha256()
    for chunk in plan.chunks:
        drones = plan.cases_of(chunk)[0]
        digest.update(drones.tobytes())
        digest.update(fly_many(drones, plan.groups[chunk.group].mission).tobytes())
    return digest.hexdigest()


def searched() -> str:
    """Return where a thing of which nothing is known would be looked for."""
    loaded = load_site("bsen")
    viewing = ViewingRoom(loaded.site, loaded.room)
    return repr(ThingSearch(viewing, belief_of(None, viewing)).looks())


def digests(names: tuple[str, ...] = ()) -> dict[str, str]:
    """Return all digests by name, or those that begin with one of these words."""
    every = {
        **{f"recording {name}": (lambda n=name: replayed(n)) for name in ("default", "paper", "troubles")},
        **{f"service {name}": (lambda c=changes: flown(c)) for name, changes in MODES.items()},
        "campaign": drawn_and_flown,
        "search": searched,
    }
    return {name: make() for name, make in every.items() if not names or name.startswith(names)}


if __name__ == "__main__":
    print(json.dumps(digests()))
