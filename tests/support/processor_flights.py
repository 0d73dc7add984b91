"""Flies and replays what must have the same bits on every processor; prints what came out."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

import numpy._core._multiarray_umath as umath

from housefly.app.replaying import recorded_site
from housefly.config.site import Site
from housefly.lab.campaigns.plan import plan_campaign
from housefly.lab.campaigns.spec import spec_from_tree
from housefly.lab.experiments.engine import fly_many
from housefly.lab.lockstep.service import fly_lockstep
from housefly.messages import Order, OrderKind
from housefly.pilot.assembly import make_pilot
from housefly.record.replay import read_steps
from housefly.sites.loaded_site import load_site, open_site
from housefly.tasks.vantage.search_places import belief_of
from housefly.tasks.vantage.thing_search import ThingSearch
from housefly.tasks.vantage.viewing_room import ViewingRoom

RECORDINGS = Path(__file__).parents[1] / "record" / "data"
QUICK = {"control__rate_hz": 25, "twin__mocap_rate_hz": 25}
SEEING = {
    "lasers": [{"name": "laser-1", "x": 13.9, "y": 3.3, "yaw": -2.6}],
    "depth_cameras": [
        {"name": "depth-1", "x": 10.5, "y": 1.25, "z": 1.6, "yaw": 2.75, "rate_hz": 1.0}
    ],
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
    """Return which step of an old recording is answered otherwise today; "" for none."""
    loaded = open_site(recorded_site(RECORDINGS / name / "flight.mcap"))
    pilot = make_pilot(loaded.site, loaded.room, loaded.grid)
    for step in read_steps(RECORDINGS / name):
        if repr(pilot.step(step.now, step.inputs)) != repr(step.outputs):
            return f"step {step.sequence} differs"
    return ""


def flown(changes: dict[str, object]) -> str:
    """Return the digest of each step of a short service, and how it ended."""
    digest = hashlib.sha256()
    end = fly_lockstep(
        load_site("bsen", **(QUICK | changes)),
        Order(OrderKind.SERVICE, goal=(8.0, 2.6), look_s=0.5),
        lambda step: digest.update(repr(step).encode()),
    )
    return f"{end} {digest.hexdigest()}"


def enabled() -> list[str]:
    """Return the groups of instructions that numpy uses here beyond its least."""
    return [name for name in umath.__cpu_dispatch__ if umath.__cpu_features__[name]]


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
    viewing = ViewingRoom(loaded.site, loaded.room, loaded.grid)
    return repr(ThingSearch(viewing, belief_of(None, viewing)).looks())


def replays() -> dict[str, str]:
    """Return what became of the old recordings."""
    return {name: replayed(name) for name in ("default", "paper", "troubles")}


def flights() -> dict[str, str]:
    """Return what was flown today, as digests."""
    services = {name: flown(changes) for name, changes in MODES.items()}
    return services | {"campaign": drawn_and_flown(), "search": searched()}


if __name__ == "__main__":
    print(json.dumps({"features": enabled(), "replays": replays(), "flights": flights()}))
