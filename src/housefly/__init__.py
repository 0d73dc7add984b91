"""A room that knows where everything is flies a small drone on errands.

    import housefly

    site = housefly.load_site("bsen", twin__seed=7)
    print(f"{site.plan('entrance').path.length:.2f} m to the entrance")
    flight = housefly.fly("entrance", site)
    print(f"{flight.outcome}, {1000 * flight.summary.rms_error_m:.0f} mm off the path")

Sites and rooms   load_site, LoadedSite, Site, Room, OccupancyGrid, import_ros_map, text_map,
                  draw_room
Flights           fly, open_flight, Flight, Summary, ReplayResult, Simulation
Wires             launch, Bus, ZenohBus, DroneTopics, ROOM_TOPICS and each of these, TASKS_QUERY,
                  ArDrone, run_twin
Lab               run_campaign, CampaignResult, identify, Identified, choose_gains, Advice,
                  judge_gains, Judgement
The room          connect, HouseClient, RoomClient, AsyncHouse, play_scene, PlayedScene
Sensors           Sensor, SensorHealth, SensorSink, MessageRate
Drones            Airframe, airframe_in, Capabilities, DroneDriver, Failsafe, DriverServer,
                  RemoteDrone, Clock, RealClock, DroneConfig, LimitsConfig, TwinDrone, PlainDrone
Messages          everything in ``housefly.messages``
Errors            HouseflyError and those below it

``docs/python.md`` says a line about each. Importing this package is quick: a name brings its module
when it is first used.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from housefly.app.public.campaign import CampaignResult, run_campaign
    from housefly.app.public.flight import Flight, fly, open_flight
    from housefly.app.public.gains import choose_gains, judge_gains
    from housefly.app.public.identification import identify
    from housefly.app.public.launch import launch
    from housefly.app.public.scene import PlayedScene, play_scene
    from housefly.bus.bus import Bus
    from housefly.bus.topics import (
        DEPTH_TOPIC,
        FRAME_TOPIC,
        OBSTACLE_TOPIC,
        ROOM_EVENT_TOPIC,
        ROOM_TOPICS,
        SENSOR_TOPIC,
        SIGHT_TOPIC,
        TASKS_QUERY,
        DroneTopics,
    )
    from housefly.bus.zenoh_bus import ZenohBus
    from housefly.clock import Clock, RealClock
    from housefly.config.airframe import Airframe, airframe_in
    from housefly.config.capabilities import Capabilities
    from housefly.config.drone import DroneConfig
    from housefly.config.limits import LimitsConfig
    from housefly.config.site import Site
    from housefly.drones.ardrone.driver import ArDrone
    from housefly.drones.contract import DroneDriver
    from housefly.drones.driver_server import DriverServer
    from housefly.drones.failsafe import Failsafe
    from housefly.drones.remote_drone import RemoteDrone
    from housefly.errors import (
        ConfigError,
        EditsError,
        HouseflyError,
        LinkError,
        MissingPartError,
        RecordingError,
        RoomError,
        SharedStoreError,
        StaleEdits,
        StoreError,
        TaskError,
        ThingError,
        UnknownState,
        WireError,
    )
    from housefly.hub.api.topics import ROOM_NEWS_TOPIC
    from housefly.hub.client.room_client import RoomClient
    from housefly.lab.identification.result import Identified
    from housefly.lab.lockstep.simulation import Simulation
    from housefly.lab.tuning.advice import Advice, Judgement
    from housefly.messages import (
        LEVEL,
        Action,
        AnySetpoint,
        Behavior,
        Clearing,
        Command,
        Covariance,
        DepthImage,
        DroneFault,
        DroneStatus,
        Estimate,
        Event,
        EventCode,
        Fact,
        Facts,
        Inputs,
        KnownMotion,
        LinkStatus,
        Observation,
        Obstacle,
        ObstacleKind,
        Order,
        OrderAnswer,
        OrderKind,
        OrderOutcome,
        OrderSource,
        Outputs,
        Path,
        Phase,
        PilotStep,
        PlanAnswer,
        PlannedTrajectory,
        Pose,
        PositionSetpoint,
        PreflightCheck,
        RecordingNews,
        Reference,
        RoomEvent,
        SafetyMode,
        Scan,
        SensorReport,
        Setpoint,
        SetpointForm,
        Severity,
        Sighting,
        SightNews,
        Telemetry,
        TrackedFrame,
        TrajectoryPoint,
        VelocitySetpoint,
        VideoFrame,
    )
    from housefly.record.replay import ReplayResult
    from housefly.record.summary import Summary
    from housefly.room.draw import draw_room, text_map
    from housefly.room.grid import OccupancyGrid
    from housefly.room.model import Room
    from housefly.room.ros_map import import_ros_map
    from housefly.sensors.contracts import Sensor, SensorHealth, SensorSink
    from housefly.sensors.message_rate import MessageRate
    from housefly.sites.loaded_site import LoadedSite, load_site
    from housefly.tasks.api.topics import TASK_NEWS_TOPIC
    from housefly.tasks.client.async_house import AsyncHouse
    from housefly.tasks.client.connect import connect
    from housefly.tasks.client.house_client import HouseClient
    from housefly.twin.contracts import TwinDrone
    from housefly.twin.plain_drone import PlainDrone
    from housefly.twin.process import run_twin

# fmt: off
__all__ = [
    "DEPTH_TOPIC", "FRAME_TOPIC", "LEVEL", "OBSTACLE_TOPIC", "ROOM_EVENT_TOPIC", "ROOM_NEWS_TOPIC",
    "ROOM_TOPICS", "SENSOR_TOPIC", "SIGHT_TOPIC", "TASKS_QUERY", "TASK_NEWS_TOPIC", "Action",
    "Advice", "Airframe", "AnySetpoint", "ArDrone", "AsyncHouse", "Behavior", "Bus",
    "CampaignResult", "Capabilities", "Clearing", "Clock", "Command", "ConfigError", "Covariance",
    "DepthImage", "DriverServer", "DroneConfig", "DroneDriver", "DroneFault", "DroneStatus",
    "DroneTopics", "EditsError", "Estimate", "Event", "EventCode", "Fact", "Facts", "Failsafe",
    "Flight", "HouseClient", "HouseflyError", "Identified", "Inputs", "Judgement", "KnownMotion",
    "LimitsConfig", "LinkError", "LinkStatus", "LoadedSite", "MessageRate", "MissingPartError",
    "Observation", "Obstacle", "ObstacleKind", "OccupancyGrid", "Order", "OrderAnswer", "OrderKind",
    "OrderOutcome", "OrderSource", "Outputs", "Path", "Phase", "PilotStep", "PlainDrone",
    "PlanAnswer", "PlannedTrajectory", "PlayedScene", "Pose", "PositionSetpoint", "PreflightCheck",
    "RealClock", "RecordingError", "RecordingNews", "Reference", "RemoteDrone", "ReplayResult",
    "Room", "RoomClient", "RoomError", "RoomEvent", "SafetyMode", "Scan", "Sensor", "SensorHealth",
    "SensorReport", "SensorSink", "Setpoint", "SetpointForm", "Severity", "SharedStoreError",
    "SightNews", "Sighting", "Simulation", "Site", "StaleEdits", "StoreError", "Summary",
    "TaskError", "Telemetry", "ThingError", "TrackedFrame", "TrajectoryPoint", "TwinDrone",
    "UnknownState", "VelocitySetpoint", "VideoFrame", "WireError", "ZenohBus", "airframe_in",
    "choose_gains", "connect", "draw_room", "fly", "identify", "import_ros_map", "judge_gains",
    "launch", "load_site", "open_flight", "play_scene", "run_campaign", "run_twin", "text_map",
]
# fmt: on

_MODULES = {
    "sites.loaded_site": "LoadedSite load_site",
    "app.public.campaign": "CampaignResult run_campaign",
    "app.public.flight": "Flight fly open_flight",
    "app.public.gains": "choose_gains judge_gains",
    "app.public.identification": "identify",
    "app.public.launch": "launch",
    "app.public.scene": "PlayedScene play_scene",
    "lab.lockstep.simulation": "Simulation",
    "bus.bus": "Bus",
    "bus.topics": (
        "DEPTH_TOPIC DroneTopics FRAME_TOPIC OBSTACLE_TOPIC ROOM_EVENT_TOPIC ROOM_TOPICS"
        " SENSOR_TOPIC SIGHT_TOPIC TASKS_QUERY"
    ),
    "bus.zenoh_bus": "ZenohBus",
    "clock": "Clock RealClock",
    "config.airframe": "Airframe airframe_in",
    "config.capabilities": "Capabilities",
    "config.drone": "DroneConfig",
    "config.limits": "LimitsConfig",
    "config.site": "Site",
    "drones.ardrone.driver": "ArDrone",
    "drones.contract": "DroneDriver",
    "drones.driver_server": "DriverServer",
    "drones.failsafe": "Failsafe",
    "drones.remote_drone": "RemoteDrone",
    "errors": (
        "ConfigError EditsError HouseflyError LinkError MissingPartError RecordingError"
        " RoomError SharedStoreError StaleEdits StoreError TaskError ThingError UnknownState"
        " WireError"
    ),
    "hub.api.topics": "ROOM_NEWS_TOPIC",
    "hub.client.room_client": "RoomClient",
    "lab.identification.result": "Identified",
    "lab.tuning.advice": "Advice Judgement",
    "record.replay": "ReplayResult",
    "record.summary": "Summary",
    "room.draw": "draw_room text_map",
    "room.grid": "OccupancyGrid",
    "room.model": "Room",
    "room.ros_map": "import_ros_map",
    "sensors.contracts": "Sensor SensorHealth SensorSink",
    "sensors.message_rate": "MessageRate",
    "tasks.api.topics": "TASK_NEWS_TOPIC",
    "tasks.client.async_house": "AsyncHouse",
    "tasks.client.connect": "connect",
    "tasks.client.house_client": "HouseClient",
    "twin.contracts": "TwinDrone",
    "twin.plain_drone": "PlainDrone",
    "twin.process": "run_twin",
}
"""Names by the module that they come from; all others come from ``housefly.messages``."""
_MODULE_OF = {name: module for module, names in _MODULES.items() for name in names.split()}


def __dir__() -> list[str]:
    return list(__all__)


if not TYPE_CHECKING:  # or every misspelt name would pass the type check

    def __getattr__(name: str) -> object:
        if name not in __all__:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        value = getattr(import_module(f"housefly.{_MODULE_OF.get(name, 'messages')}"), name)
        globals()[name] = value
        return value
