"""What is asked about a site, in which order, with which help."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from housefly.config.airframe import airframe_names
from housefly.room.draft.imports.imported import IMPORT_SUFFIXES
from housefly.room.draft.missing import DraftStep
from housefly.room.draft.model import DraftDrone, SiteDraft
from housefly.room.draft.suggestions import suggested_pad

_FILES = " ".join(IMPORT_SUFFIXES)


@dataclass(frozen=True, slots=True)
class Question:
    """One question.

    Attributes:
        step: what it is about.
        words: asked.
        default: what Enter stands for, from what is known.
        keeps: whether Enter changes nothing.
        help: told on ``help``.
        repeats: whether it is asked again until an empty answer.
        hardware: whether it is only asked where real hardware flies.
    """

    step: DraftStep
    words: str
    default: Callable[[SiteDraft], str]
    help: str
    keeps: Callable[[SiteDraft], bool] = lambda _: False
    repeats: bool = False
    hardware: bool = False


def _size(draft: SiteDraft) -> str:
    if draft.source:
        return f"as {draft.source} has it"
    if draft.bounds is None:
        return ""
    x_min, y_min, x_max, y_max = draft.bounds
    return f"{x_max - x_min:g}x{y_max - y_min:g}x{draft.height:g}"


def _pad(draft: SiteDraft) -> str:
    if draft.pad is not None:
        return f"{draft.pad[0]:g},{draft.pad[1]:g}"
    suggested = suggested_pad(draft) if draft.bounds is not None else None
    return f"{suggested[0]:g},{suggested[1]:g}" if suggested else ""


def _places(draft: SiteDraft) -> str:
    return "that is all" if draft.places else "auto"


def _tracking(draft: SiteDraft) -> str:
    if draft.tracking is None or not draft.hardware:
        return "simulated"
    port = f":{draft.tracking.port}" if draft.tracking.port else ""
    return f"{draft.tracking.kind} {draft.tracking.address}{port} {draft.tracking.body}"


def _frame(draft: SiteDraft) -> str:
    return "that is all" if draft.frame_points else "later"


def _drone(draft: SiteDraft) -> str:
    drone = draft.drone or DraftDrone()
    if not draft.hardware:
        return drone.model
    return f"{drone.model} {drone.address or drone.airframe.usual_address}".rstrip()


def _drone_is_known(draft: SiteDraft) -> bool:
    drone = draft.drone
    return drone is not None and bool(drone.address or not draft.hardware)


def _nothing_more(_: SiteDraft) -> str:
    return "that is all"


def _always(_: SiteDraft) -> bool:
    return True


QUESTIONS: tuple[Question, ...] = (
    Question(
        DraftStep.ROOM,
        "Room: length x width x height in metres, or a file",
        _size,
        f"""\
6x4 or 6x4x2.5: an empty rectangle with four walls; x runs along its length, y along its width,
  both from 0.
A file ({_FILES}): a ROS map (its yaml), a 3-D scan, a floor plan.
ros2:/map: the map that a ROS 2 node publishes now; domain=3 and discovery=subnet say where.
  After the file may stand what it does not say itself:
    unit=0.001    metres per unit of the file (found out where it can be)
    up=y          axis of a scan that points up (z, or y as in glTF)
    layers=A,B    words in the names of a plan's layers that hold the walls
    unexplored=free   floor that a map or scan never saw counts as free, not as walls""",
        keeps=lambda draft: draft.bounds is not None,
    ),
    Question(
        DraftStep.OBJECTS,
        "Furniture and walls, one a line",
        _nothing_more,
        """\
table 3,1 1.2x0.8x0.75          name, middle x,y, length x width x height [m], from the floor up
lamp 5,3 0.4x0.4x0.3 from=1.6   what hangs: the height that it begins at
sofa 2,3 2x0.9x0.8 turn=30deg   turned to the left
wall 2,0 2,2.5                  a wall from a point to a point, up to the ceiling
remove table                    takes it out
erase 1,1,2,2                   takes the imported boxes in x_min,y_min,x_max,y_max out""",
        repeats=True,
        keeps=_always,
    ),
    Question(
        DraftStep.PAD,
        "Pad, on which the drone starts and lands: x,y",
        _pad,
        """\
2,1.5           its middle on the floor [m]; half a metre around it is free
2,1.5 90deg     ... and where the drone's nose points: 0deg along x, 90deg along y""",
        keeps=lambda draft: draft.pad is not None,
    ),
    Question(
        DraftStep.PLACES,
        "Places to fly to, one a line",
        _places,
        """\
kitchen 5,1           a name and where to hover, x,y [m]
door 1,3 look=0,3,1   ... and what to look at, x,y,z
auto                  roomy places are chosen: far, north, south, east, west
remove kitchen        takes it out""",
        repeats=True,
        keeps=lambda draft: bool(draft.places),
    ),
    Question(
        DraftStep.ZONES,
        "Zones that the drone never enters, one a line",
        _nothing_more,
        """\
1,0,2.5,1.2 somebody sits here     x_min,y_min,x_max,y_max [m], and why
remove somebody sits here          takes it out""",
        repeats=True,
        keeps=_always,
    ),
    Question(
        DraftStep.TRACKING,
        "Tracking: simulated, or its kind and address",
        _tracking,
        """\
simulated               nothing real: the simulated drone in the simulated room
vicon 10.0.0.5          Vicon Tracker; natnet: OptiTrack Motive; vrpn: VRPN
natnet 10.0.0.5 Rigid Body 1  ... and the drone's name in that software (default: ardrone)
vicon 10.0.0.5:8010     ... and another port than usual
bridge:qualisys 10.0.0.5   any system that PyPI motioncapture knows (extra mocap)
up=y                    may stand behind it, where the system does not say which axis points up
It is listened to at once, as the pilot does, and what was heard is told.""",
    ),
    Question(
        DraftStep.FRAME,
        "Align the tracking frame: put the drone on a point, type where that is on the map, x,y",
        _frame,
        """\
1.5,2                  the drone stands at x,y on the map now: tracking is read for two seconds
pad                    ... on the pad
1.5,2 = 0.03,-0.12,0.06   or both typed: where it is, and where tracking sees it [m]
again                  forgets the points
later                  not now: housefly preflight --frames leads you through it, the drone in hand
Three points that are metres apart and not on one line: the third one checks the other two.""",
        repeats=True,
        hardware=True,
        keeps=_always,
    ),
    Question(
        DraftStep.DRONE,
        "Drone: its model, and where a real one answers",
        _drone,
        f"""\
crazyflie                     a model, of {", ".join(airframe_names())}
tello 192.168.10.1            ... and its address (docs/drones), where real hardware flies
192.168.1.1                   an address alone: of the model in brackets
tello 192.168.10.1 profile=my.toml   ... and its measured constants (housefly identify)
A real one is asked at once for its state; nothing is ordered.""",
        keeps=_drone_is_known,
    ),
)

ANY_TIME = """\
At any question: Enter takes what stands in brackets; back goes to the question before; map draws
the room; missing says what is missing; quit leaves (everything is kept)."""
