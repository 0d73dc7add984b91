"""Builds the pilot of one site and room."""

from __future__ import annotations

from math import inf

import numpy as np

from housefly.config.site import Site
from housefly.geometry import quaternion_from_euler
from housefly.messages.flight import Inputs, Order, OrderKind
from housefly.messages.obstacles import Obstacle, ObstacleKind
from housefly.messages.preflight import FRAMES_NOT_NEEDED, FramesKnown
from housefly.messages.sensing import DroneStatus, Pose, Sighting, Telemetry
from housefly.pilot.behavior.mission import longest_silence
from housefly.pilot.behavior.mission_manager import MissionManager
from housefly.pilot.contracts import Maneuver, PilotSettings
from housefly.pilot.control.forms import FormCode, FormModel
from housefly.pilot.navigator import RoomNavigator
from housefly.pilot.pilot import Pilot
from housefly.pilot.safety.gate import Gate
from housefly.pilot.safety.inputs import Geofence
from housefly.pilot.safety.motion_rules import CEILING_CLEARANCE, CEILING_SLACK
from housefly.pilot.safety.rules import ORDER_RULES, SAFETY_RULES
from housefly.pilot.site_parameters import pilot_parameters
from housefly.room.grid import OccupancyGrid, extent_of
from housefly.room.model import Room


def make_pilot(
    site: Site,
    room: Room,
    grid: OccupancyGrid,
    maneuver: Maneuver | None = None,
    *,
    guarded: bool = True,
    frames: FramesKnown = FRAMES_NOT_NEEDED,
) -> Pilot:
    """Return a pilot that knows a room by its map.

    Args:
        site: drone, tracking, limits, mode.
        room: what stands where.
        grid: its map.
        maneuver: takes the place of holding.
        guarded: False leaves the last gate nothing but orders, and believes tracking whatever the
            drone feels: the negative control of the simulated room.
        frames: what is known of the frames of tracking, drone and map; for the pre-flight checks.
    """
    is_paper = site.mode == "paper"
    params = pilot_parameters(is_paper, site.drone, site.control, site.limits, site.estimation)
    ceiling = min(site.limits.height_max + CEILING_SLACK, room.height - CEILING_CLEARANCE)
    fence = Geofence(extent_of(grid), ceiling)
    params = params._replace(form=fenced(params.form, fence))
    settings = PilotSettings(
        parameters=params,
        airframe=site.drone.airframe,
        body=site.tracking.body,
        home=room.home,
        flight_height=site.map.flight_height,
        facing_tolerance=site.control.epsilon_yaw,
        drag=site.drone.drag,
        odometry_error=site.odometry_error,
        guarded=guarded,
        sinks_to=site.limits.landing_height - site.limits.landing_lead,
        drifts_from=(
            site.limits.landing_height if site.estimation.aims_upwind and not is_paper else 0.0
        ),
        people_silence=longest_silence(
            min((camera.rate_hz for camera in site.depth_cameras), default=inf)
        ),
    )
    navigator = RoomNavigator(site, room, grid)
    missions = MissionManager(
        site.limits, navigator, site.drone.airframe, params.tolerances.position, is_paper, frames
    )
    rules = SAFETY_RULES if guarded else ORDER_RULES
    gate = Gate(site.limits, fence, site.drone.airframe, rules)
    return Pilot(settings, navigator, missions, gate, maneuver)


def fenced(form: FormModel, fence: Geofence) -> FormModel:
    """Return a form of which no place outside the fence is asked; of a tilt there is none."""
    if form.form != FormCode.POSITION:
        return form
    x_min, y_min, x_max, y_max = map(float, fence.bounds)
    return form._replace(
        x_min=x_min, y_min=y_min, x_max=x_max, y_max=y_max, z_max=float(fence.ceiling)
    )


_WARM_UP_TICKS = 200
_WARM_UP_SPEED = 0.2
"""How long, and how fast [m/s], the drone seems to fly while everything is compiled."""


def warm_up(site: Site, room: Room, grid: OccupancyGrid) -> None:
    """Compile every numeric function that a pilot of this site calls, by flying some seconds."""
    pilot = make_pilot(site, room, grid)
    heading = quaternion_from_euler(0.0, 0.0, room.home_yaw)
    goal = next((place.name for place in room.places if place.name != "home"), "home")
    x, y = room.home
    for tick in range(_WARM_UP_TICKS):
        at = 0.02 * tick
        way = _WARM_UP_SPEED * at
        pose = Pose((x + way, y, site.map.flight_height + 1e-4 * tick), heading)
        orders = (Order(OrderKind.GO, goal, issued_at=at),) if tick == 10 else ()
        sightings = (Sighting(site.tracking.body, pose, at, at),)
        chair = Obstacle("chair", (x + 1e-3 * tick, y), 0.1, seen_at=at)
        walker = Obstacle(
            "walker", (x + 3.0, y), 0.2, velocity=(0.5, 0.0), seen_at=at, kind=ObstacleKind.PERSON
        )
        obstacles = (walker, chair) if tick > 20 else (walker,)
        telemetry = Telemetry(
            at,
            DroneStatus.FLYING,
            1.0,
            theta=1e-4 * tick,
            psi=1e-4 * tick,
            height=site.map.flight_height,
            velocity=(_WARM_UP_SPEED, 0.0, 0.0),
        )
        pilot.step(at, Inputs(sightings, telemetry, orders, obstacles))
    pilot.plan(room.home)
    if site.flies_in_space:
        _compile_doors()


def _compile_doors() -> None:
    """Compile what only a way through a narrow door calls."""
    from housefly.pilot.planning.space.oriented_hull import OrientedHull, oriented_clearances

    oriented_clearances(np.zeros((1, 11)), np.zeros((1, 4)), OrientedHull(0.2, 0.2, 0.1), 1.0)
