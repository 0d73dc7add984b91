"""Flies the visitor service from a seed and scores it on the truth: who is in the clip, and when.

The picture is cast ray by ray in the simulated room (``twin.picture_segments``), five times a
second.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import inf, pi
from random import Random
from typing import Any

from housefly.evidence.clip_values import StartClip
from housefly.geometry import distance, euler_from_quaternion, heading_to, wrap_angle
from housefly.lab.lockstep.simulation import SETTLING_TIME
from housefly.lab.lockstep.task_flight import TaskFlight, TaskScript
from housefly.lab.lockstep.task_lockstep import fly_task_lockstep
from housefly.sites.loaded_site import LoadedSite, open_site, read_site
from housefly.tasks.api.values import TaskStage
from housefly.tasks.document.library import bind, load_library
from housefly.tasks.execution.values import StopClip
from housefly.twin.contracts import FlightState
from housefly.twin.demo_site import demo_changes
from housefly.twin.people import Scene, load_scene
from housefly.twin.world import SimulatedWorld

SERVICE, PLACE, BEFORE = "visitor", "entrance", 5.0
"""The service, where it looks, and the time before its visit that its clip shows as well [s]."""
USEFUL_SHARE, USEFUL_FACING = 0.05, 0.35
"""A picture is useful in which the visitor takes this share, and that is turned to them within this
[rad]; where the drone hovers they take 0.15, nothing in between.
"""
VISIBLE_SHARE = 0.01
"""Of the picture that somebody takes who is in view."""
FEET_UP = 0.1
"""Height of the drone's middle from which its feet are off the floor [m]."""
_SAMPLE_PERIOD = 0.2
_FAR = 7.0
"""From farther away nobody takes a visible share of the picture [m]."""
_LATEST_BEGIN = 100.0
"""Among walking people the bell rings at some time before this [s]."""


@dataclass(frozen=True, slots=True)
class VisitorScore:
    """One run of the visitor service, in truth; times since the task began [s].

    Attributes:
        seed: of the run.
        fault: what is not as it should be, or "".
        planned: flight time to the door by the planner [s].
        motors_at: the motors begin to turn.
        airborne_at: the feet leave the floor.
        useful_at: of the first useful picture of the visitor.
        clip: begin and end of the visit that is filmed; the clip begins ``BEFORE`` earlier.
        in_visit, in_before: share of the pictures of the visit, and of the time before it, in which
            the visitor is in view.
        smallest: least share of the picture that the visitor takes in the visit.
        facing: largest heading away from the visitor in the visit [rad].
        ended_at: the drone stands again.
        off_pad: where it stands, from the pad [m].
        clearance: smallest distance to anything in the air [m].
    """

    seed: int
    fault: str
    planned: float
    motors_at: float
    airborne_at: float
    useful_at: float
    clip: tuple[float, float]
    in_visit: float
    in_before: float
    smallest: float
    facing: float
    ended_at: float
    off_pad: float
    clearance: float


def score_visitor(seed: int, *, among_people: bool = False) -> VisitorScore:
    """Fly one run and score it.

    Args:
        seed: of noise, delays, losses, charge, and of when somebody says "come home".
        among_people: the shipped scene's residents walk about; else nobody else is there.
    """
    dice = Random(seed)
    loaded = _site_of(seed, dice, among_people)
    begin = dice.uniform(SETTLING_TIME, _LATEST_BEGIN) if among_people else SETTLING_TIME
    witness = _Witness(begin)
    flight = fly_task_lockstep(
        loaded,
        bind(load_library()[SERVICE], {}),
        TaskScript(silent=dice.random() < 0.25, reply_time=dice.uniform(0.5, 40.0)),
        scene=_residents() if among_people else None,
        begin_at=begin,
        pictures=False,
        on_world=witness.look,
    )
    return _scored(seed, loaded, flight, witness)


def _site_of(seed: int, dice: Random, among_people: bool) -> LoadedSite:
    changes: dict[str, Any] = {
        "twin__seed": seed,
        "twin__mocap_rate_hz": dice.choice((100.0, 30.0)),
        "twin__mocap_latency": dice.uniform(0.01, 0.05),
        "twin__mocap_dropout": dice.uniform(0.0, 0.2),
        "twin__command_delay": dice.uniform(0.02, 0.08),
        "twin__battery": dice.uniform(0.5, 1.0),
    }
    if among_people:
        changes["lasers"] = demo_changes()["lasers"]
    return open_site(read_site("bsen", hub__enabled=False, **changes))


def _residents() -> Scene:
    """Return the shipped scene without its visitor, who here stands at the door all the time."""
    script = load_scene("bsen").script
    people = tuple(one for one in script.people if not one.visitor)
    return Scene(script.model_copy(update={"people": people}))


@dataclass(frozen=True, slots=True)
class VisitorPicture:
    """How much of the camera's picture the visitor takes at a time [s], 0 to 1, and how far it is
    turned away from them [rad].
    """

    at: float
    share: float
    facing: float


class _Witness:
    """Looks at the world while the task flies.

    Args:
        begin: world time at which the task begins [s].
    """

    def __init__(self, begin: float) -> None:
        self.pictures: list[VisitorPicture] = []
        self.motors_at = self.airborne_at = inf
        self._begin, self._began, self._next = begin, inf, 0.0

    def look(self, world: SimulatedWorld) -> None:
        """Look once; to be called at every step of the pilot."""
        if world.now < self._begin:
            return
        self._began = min(self._began, world.now)
        at = world.now - self._began
        if world.onboard().flight is not FlightState.LANDED:
            self.motors_at = min(self.motors_at, at)
        if world.truth().pose.position[2] > FEET_UP:
            self.airborne_at = min(self.airborne_at, at)
        if at >= self._next:
            self._next += _SAMPLE_PERIOD
            self.pictures.append(picture_of(world, at))


def _scored(seed: int, loaded: LoadedSite, flight: TaskFlight, witness: _Witness) -> VisitorScore:
    starts, ends = flight.actions_of(StartClip), flight.actions_of(StopClip)
    clip = (starts[0].at, ends[-1].at) if starts and ends else (inf, inf)
    visit = [one for one in witness.pictures if clip[0] <= one.at <= clip[1]]
    before = [one for one in witness.pictures if clip[0] - BEFORE <= one.at < clip[0]]
    useful = (one.at for one in witness.pictures if is_useful(one))
    score = VisitorScore(
        seed=seed,
        fault="",
        planned=loaded.plan(PLACE).duration or inf,
        motors_at=witness.motors_at,
        airborne_at=witness.airborne_at,
        useful_at=next(useful, inf),
        clip=clip,
        in_visit=_share_in_view(visit),
        in_before=_share_in_view(before),
        smallest=min((one.share for one in visit), default=0.0),
        facing=max((one.facing for one in visit), default=pi),
        ended_at=flight.landed_at or flight.ended_at,
        off_pad=flight.off_pad,
        clearance=flight.clearance,
    )
    return replace(score, fault=_fault_of(score, flight, len(starts), len(ends)))


def _fault_of(score: VisitorScore, flight: TaskFlight, starts: int, ends: int) -> str:
    """Return what is not as it should be, or ""."""
    touched = [contact for contact in flight.contacts if contact.motors_turned]
    if touched:
        return f"touched {touched[0].name} at {touched[0].speed:.1f} m/s"
    if flight.stage is not TaskStage.DONE:
        return f"{flight.stage.value}: {flight.words}"
    if not flight.is_on_pad:
        return f"{flight.off_pad:.2f} m off the pad"
    if (starts, ends) != (1, 1):
        return f"{starts} clips begun, {ends} ended"
    if score.in_visit < 1.0 or score.in_before < 1.0:
        return f"in view {score.in_before:.0%} before and {score.in_visit:.0%} of the visit"
    if score.smallest < USEFUL_SHARE or score.facing > USEFUL_FACING:
        return f"takes {score.smallest:.1%} of the picture, {score.facing:.2f} rad aside"
    return ""


def picture_of(world: SimulatedWorld, at: float) -> VisitorPicture:
    """Return what the camera shows now; ``at`` is put in it [s]."""
    pose, door = world.truth().pose, world.room.visitor
    assert door is not None
    yaw = euler_from_quaternion(pose.orientation)[2]
    facing = abs(wrap_angle(heading_to(pose.position[:2], door) - yaw))
    is_far = distance(pose.position[:2], door) > _FAR or facing > pi / 2
    share = 0.0 if is_far else world.in_picture().get(SERVICE, 0.0)
    return VisitorPicture(at, share, facing)


def is_useful(picture: VisitorPicture) -> bool:
    """Return whether the visitor can be made out."""
    return picture.share >= USEFUL_SHARE and picture.facing <= USEFUL_FACING


def _share_in_view(pictures: Sequence[VisitorPicture]) -> float:
    seen = sum(one.share >= VISIBLE_SHARE for one in pictures)
    return seen / len(pictures) if pictures else 0.0
