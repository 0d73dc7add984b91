"""Every fault that the simulated room can have, with unit and range."""

from __future__ import annotations

from functools import cache
from math import pi

from housefly.errors import ConfigError
from housefly.twin.faults.vocabulary import (
    LOCKSTEP,
    WIRES,
    FaultComponent,
    FaultKind,
    FaultType,
)

_C, _K = FaultComponent, FaultKind

FAULT_TYPES: tuple[FaultType, ...] = (
    FaultType(_C.MOCAP, "", _K.OFF, "no frames"),
    FaultType(_C.MOCAP, "", _K.STUCK, "the same poses under fresh stamps"),
    FaultType(_C.MOCAP, "", _K.GARBAGE, "positions that are not numbers"),
    FaultType(_C.MOCAP, "orientation", _K.GARBAGE, "quaternions that are no rotations"),
    FaultType(_C.MOCAP, "", _K.SLOW, "so many frames a second", "Hz", 10.0, 0.5, 200.0),
    FaultType(_C.MOCAP, "", _K.DELAYED, "frames late, with true stamps", "s", 0.2, 0.0, 2.0),
    FaultType(_C.MOCAP, "", _K.INTERMITTENT, "share of the frames lost", "1", 0.3, 0.0, 1.0),
    FaultType(
        _C.MOCAP, "position", _K.WRONG, "the drone seen so far off, somewhere level", "m", 1.0, 0.0,
        100.0,
    ),
    FaultType(
        _C.MOCAP, "latency", _K.WRONG, "frames late, stamped as if fresh", "s", 0.3, 0.0, 2.0
    ),
    FaultType(_C.MOCAP, "x", _K.WRONG, "the drone seen off along x", "m", 0.3, -100.0, 100.0),
    FaultType(_C.MOCAP, "y", _K.WRONG, "the drone seen off along y", "m", 0.3, -100.0, 100.0),
    FaultType(_C.MOCAP, "z", _K.WRONG, "the drone seen off in height", "m", 0.3, -100.0, 100.0),
    FaultType(
        _C.MOCAP, "drift", _K.WRONG, "the drone's place drifts, somewhere level", "m/s", 0.02, 0.0,
        5.0,
    ),
    FaultType(_C.MOCAP, "drift_x", _K.WRONG, "the same along x", "m/s", 0.02, -5.0, 5.0),
    FaultType(_C.MOCAP, "drift_y", _K.WRONG, "the same along y", "m/s", 0.02, -5.0, 5.0),
    FaultType(_C.MOCAP, "drift_z", _K.WRONG, "the same in height", "m/s", 0.02, -5.0, 5.0),
    FaultType(
        _C.MOCAP, "steps", _K.WRONG, "the drone's place steps once a second, somewhere level", "m",
        0.14, 0.0, 5.0,
    ),
    FaultType(_C.MOCAP, "steps_x", _K.WRONG, "the same along x", "m", 0.14, -5.0, 5.0),
    FaultType(_C.MOCAP, "steps_y", _K.WRONG, "the same along y", "m", 0.14, -5.0, 5.0),
    FaultType(
        _C.MOCAP, "yaw", _K.WRONG, "the drone's body defined turned about its up axis", "rad", pi,
        -pi, pi,
    ),
    FaultType(
        _C.MOCAP, "axes", _K.WRONG, "y mirrored in positions, headings true: a wrong axis setting"
    ),
    FaultType(_C.MOCAP, "map", _K.WRONG, "the room mirrored about the line along x on the pad"),
    FaultType(
        _C.MOCAP, "map_yaw", _K.WRONG, "the room turned about the pad", "rad", 0.5, -pi, pi
    ),
    FaultType(_C.MOCAP, "origin_x", _K.WRONG, "the room shifted along x", "m", 0.5, -100.0, 100.0),
    FaultType(_C.MOCAP, "origin_y", _K.WRONG, "the room shifted along y", "m", 0.5, -100.0, 100.0),
    FaultType(_C.MOCAP, "origin_z", _K.WRONG, "the room shifted in height", "m", 0.6, -10.0, 10.0),
    FaultType(
        _C.MOCAP, "bodies", _K.WRONG, "the drone and another body bear each other's name"
    ),
    FaultType(
        _C.MOCAP, "stamp", _K.WRONG, "stamps off: positive in the future", "s", 0.5, -10.0, 10.0
    ),
    FaultType(_C.MOCAP, "stamp", _K.STUCK, "every frame has the stamp and number of the first"),
    FaultType(
        _C.MOCAP, "stamp", _K.GARBAGE, "stamps go back and forth by up to so much", "s", 0.2, 0.0,
        10.0,
    ),
    FaultType(_C.TELEMETRY, "", _K.OFF, "no reports of the drone"),
    FaultType(_C.TELEMETRY, "", _K.STUCK, "fresh reports with old content"),
    FaultType(
        _C.TELEMETRY, "", _K.GARBAGE, "reports of numbers that are none; noise bytes on wires"
    ),
    FaultType(_C.TELEMETRY, "", _K.SLOW, "so many reports a second", "Hz", 5.0, 0.2, 200.0),
    FaultType(_C.TELEMETRY, "", _K.DELAYED, "reports late", "s", 1.0, 0.0, 10.0),
    FaultType(_C.TELEMETRY, "", _K.INTERMITTENT, "share of the reports lost", "1", 0.3, 0.0, 1.0),
    FaultType(
        _C.TELEMETRY, "order", _K.WRONG, "share of the reports overtaken by the next", "1", 0.3,
        0.0, 1.0,
    ),
    FaultType(_C.TELEMETRY, "yaw", _K.WRONG, "heading reported off", "rad", 0.5, -pi, pi),
    FaultType(_C.TELEMETRY, "height", _K.WRONG, "height reported off", "m", 0.3, -10.0, 10.0),
    FaultType(
        _C.TELEMETRY, "velocity", _K.WRONG, "forward speed reported off", "m/s", 0.3, -5.0, 5.0
    ),
    FaultType(_C.COMMANDS, "", _K.OFF, "no command reaches the drone"),
    FaultType(_C.COMMANDS, "", _K.STUCK, "the last command is heard again and again"),
    FaultType(_C.COMMANDS, "", _K.GARBAGE, "noise bytes instead of commands"),
    FaultType(_C.COMMANDS, "", _K.SLOW, "so many datagrams a second", "Hz", 5.0, 0.2, 200.0),
    FaultType(_C.COMMANDS, "", _K.DELAYED, "commands late", "s", 1.0, 0.0, 10.0),
    FaultType(_C.COMMANDS, "", _K.INTERMITTENT, "share of the datagrams lost", "1", 0.3, 0.0, 1.0),
    FaultType(
        _C.COMMANDS, "order", _K.WRONG, "share of the datagrams overtaken by the next", "1", 0.3,
        0.0, 1.0,
    ),
    FaultType(
        _C.COMMANDS, "copies", _K.WRONG, "share of the datagrams that arrive twice", "1", 0.3, 0.0,
        1.0,
    ),
    FaultType(_C.PILOT, "", _K.OFF, "the driver hears no pilot", where=LOCKSTEP),
    FaultType(
        _C.PILOT, "", _K.STUCK, "the pilot's last command again and again, as if given now",
        where=LOCKSTEP,
    ),
    FaultType(_C.PILOT, "", _K.GARBAGE, "setpoints that are not numbers", where=LOCKSTEP),
    FaultType(
        _C.PILOT, "", _K.SLOW, "so many steps a second are heard", "Hz", 5.0, 0.2, 200.0, LOCKSTEP
    ),
    FaultType(
        _C.PILOT, "", _K.DELAYED, "steps late, with true times", "s", 0.2, 0.0, 10.0, LOCKSTEP
    ),
    FaultType(
        _C.PILOT, "", _K.INTERMITTENT, "share of the pilot's steps lost", "1", 0.5, 0.0, 1.0,
        LOCKSTEP,
    ),
    FaultType(_C.VIDEO, "", _K.OFF, "no pictures", where=WIRES),
    FaultType(_C.VIDEO, "", _K.STUCK, "the same picture again and again", where=WIRES),
    FaultType(_C.VIDEO, "", _K.GARBAGE, "pictures of noise bytes", where=WIRES),
    FaultType(
        _C.VIDEO, "yaw", _K.WRONG, "the camera looks so far aside, to the left", "rad", 0.5, -pi,
        pi, WIRES,
    ),
    FaultType(
        _C.VIDEO, "", _K.SLOW, "so many pictures a second", "Hz", 2.0, 0.2, 200.0, WIRES
    ),
    FaultType(
        _C.VIDEO, "", _K.DELAYED, "pictures late, with true stamps", "s", 1.0, 0.0, 10.0, WIRES
    ),
    FaultType(_C.VIDEO, "", _K.INTERMITTENT, "share lost", "1", 0.3, 0.0, 1.0, WIRES),
    FaultType(_C.LASER, "", _K.OFF, "no scans"),
    FaultType(_C.LASER, "", _K.STUCK, "the same scan again and again"),
    FaultType(_C.LASER, "", _K.GARBAGE, "distances at random"),
    FaultType(_C.LASER, "", _K.WRONG, "distances off", "m", 0.3, -5.0, 5.0),
    FaultType(_C.LASER, "", _K.SLOW, "so many scans a second of each", "Hz", 2.0, 0.2, 200.0),
    FaultType(
        _C.LASER, "", _K.DELAYED, "scans late, and taken for fresh: nobody reads a scanner's clock",
        "s", 0.5, 0.0, 10.0,
    ),
    FaultType(_C.LASER, "", _K.INTERMITTENT, "share of the scans lost", "1", 0.3, 0.0, 1.0),
    FaultType(_C.DEPTH, "", _K.OFF, "no images"),
    FaultType(_C.DEPTH, "", _K.STUCK, "the same image again and again"),
    FaultType(_C.DEPTH, "", _K.GARBAGE, "depths at random"),
    FaultType(_C.DEPTH, "", _K.WRONG, "depths off, where there are any", "m", 0.3, -5.0, 5.0),
    FaultType(_C.DEPTH, "", _K.SLOW, "so many images a second of each", "Hz", 2.0, 0.2, 200.0),
    FaultType(_C.DEPTH, "", _K.DELAYED, "images late, with true stamps", "s", 0.5, 0.0, 10.0),
    FaultType(_C.DEPTH, "", _K.INTERMITTENT, "share of the images lost", "1", 0.3, 0.0, 1.0),
    FaultType(_C.DEVICES, "", _K.OFF, "no messages", where=WIRES),
    FaultType(
        _C.DEVICES, "", _K.STUCK, "fresh messages with old content, and no events", where=WIRES
    ),
    FaultType(_C.DEVICES, "", _K.GARBAGE, "payloads of noise bytes", where=WIRES),
    FaultType(
        _C.DEVICES, "values", _K.WRONG, "factor of what is measured", "1", 1.5, -10.0, 10.0, WIRES
    ),
    FaultType(
        _C.DEVICES, "state", _K.WRONG, "open is told as shut, on as off, moving as still, and back",
        where=WIRES,
    ),
    FaultType(
        _C.DEVICES, "", _K.SLOW, "so many messages a second of each", "Hz", 0.5, 0.01, 20.0, WIRES
    ),
    FaultType(
        _C.DEVICES, "", _K.DELAYED, "messages late, with true stamps", "s", 2.0, 0.0, 60.0, WIRES
    ),
    FaultType(_C.DEVICES, "", _K.INTERMITTENT, "share lost", "1", 0.3, 0.0, 1.0, WIRES),
    FaultType(_C.BATTERY, "", _K.WRONG, "the charge falls to this at once", "1", 0.08, 0.0, 1.0),
    FaultType(_C.BATTERY, "", _K.STUCK, "the gauge keeps its value"),
    FaultType(_C.BATTERY, "", _K.GARBAGE, "the charge reported is not a number", where=LOCKSTEP),
    FaultType(_C.BATTERY, "voltage", _K.WRONG, "voltage lost under load", "V", 1.0, 0.0, 5.0),
    FaultType(
        _C.MOTOR, "front_left", _K.WRONG, "share of the thrust left", "1", 0.6, 0.0, 1.0
    ),
    FaultType(_C.MOTOR, "front_right", _K.WRONG, "likewise", "1", 0.6, 0.0, 1.0),
    FaultType(_C.MOTOR, "rear_right", _K.WRONG, "likewise", "1", 0.6, 0.0, 1.0),
    FaultType(_C.MOTOR, "rear_left", _K.WRONG, "likewise", "1", 0.6, 0.0, 1.0),
    FaultType(_C.MOTOR, "all", _K.WRONG, "likewise, of all four", "1", 0.9, 0.0, 1.0),
    FaultType(
        _C.MOTOR, "propeller", _K.WRONG, "a damaged propeller: thrust left, and it shakes", "1",
        0.8, 0.0, 1.0,
    ),
    FaultType(_C.MOTOR, "front_left", _K.OFF, "that motor stands still"),
    FaultType(_C.MOTOR, "front_right", _K.OFF, "likewise"),
    FaultType(_C.MOTOR, "rear_right", _K.OFF, "likewise"),
    FaultType(_C.MOTOR, "rear_left", _K.OFF, "likewise"),
    FaultType(_C.SONAR, "", _K.OFF, "no echo"),
    FaultType(_C.SONAR, "", _K.STUCK, "the same height, in silence"),
    FaultType(_C.SONAR, "", _K.WRONG, "added to the height", "m", 0.3, -5.0, 5.0),
    FaultType(_C.SONAR, "", _K.GARBAGE, "noise on the height", "m", 0.3, 0.0, 5.0),
    FaultType(_C.FLOW, "", _K.OFF, "the speeds read 0"),
    FaultType(_C.FLOW, "", _K.STUCK, "the speeds keep their values"),
    FaultType(_C.FLOW, "gain", _K.WRONG, "factor of the speeds", "1", 0.5, 0.0, 10.0),
    FaultType(_C.FLOW, "bias", _K.WRONG, "added to the forward speed", "m/s", 0.2, -10.0, 10.0),
    FaultType(
        _C.FLOW, "bias_left", _K.WRONG, "added to the speed to the left", "m/s", 0.2, -10.0, 10.0
    ),
    FaultType(_C.FLOW, "", _K.GARBAGE, "noise on the speeds", "m/s", 0.5, 0.0, 10.0),
    FaultType(_C.IMU, "", _K.STUCK, "roll, pitch and yaw keep their values"),
    FaultType(_C.IMU, "", _K.WRONG, "added to the pitch", "rad", 0.05, -0.5, 0.5),
    FaultType(_C.IMU, "gyro", _K.GARBAGE, "noise on the gyros", "rad/s", 0.2, 0.0, 10.0),
    FaultType(
        _C.IMU, "acceleration", _K.GARBAGE, "noise on the accelerometers", "m/s^2", 2.0, 0.0, 100.0
    ),
    FaultType(
        _C.WIND, "", _K.WRONG, "steady wind, from somewhere level", "m/s", 1.5, 0.0, 20.0
    ),
    FaultType(_C.WIND, "x", _K.WRONG, "steady wind along x", "m/s", 1.5, -20.0, 20.0),
    FaultType(_C.WIND, "y", _K.WRONG, "steady wind along y", "m/s", 1.5, -20.0, 20.0),
    FaultType(_C.WIND, "gust", _K.WRONG, "gusts, one-sigma", "m/s", 0.8, 0.0, 10.0),
    FaultType(
        _C.FAN, "", _K.WRONG, "downwash of a ceiling fan above the drone", "m/s", 2.0, 0.0, 10.0
    ),
    FaultType(_C.PAYLOAD, "", _K.WRONG, "a load that it carries", "kg", 0.05, 0.0, 0.5),
    FaultType(
        _C.TETHER, "", _K.WRONG, "a line of this length to the floor below the drone", "m", 1.2,
        0.0, 100.0,
    ),
    FaultType(
        _C.OBSTACLES, "", _K.WRONG, "a chair stands so far ahead of the drone", "m", 1.0, 0.0, 20.0
    ),
    FaultType(_C.OBSTACLES, "pad", _K.WRONG, "a stool stands on the pad, once the drone is away"),
    FaultType(
        _C.OBSTACLES, "flat", _K.WRONG,
        "a box, 0.12 m high, lies on the pad, once the drone is away",
    ),
    FaultType(
        _C.OBSTACLES, "pole", _K.WRONG,
        "a pole, 0.08 m thick, stands 0.2 m beside the pad's middle, once the drone is away",
    ),
    FaultType(
        _C.PEOPLE, "", _K.WRONG, "somebody stands so far ahead of the drone", "m", 1.5, 0.0, 20.0
    ),
    FaultType(
        _C.PEOPLE, "walking", _K.WRONG,
        "somebody walks up to where the drone is, from 3 m ahead, and on", "m/s", 1.0, 0.05, 3.0,
    ),
    FaultType(
        _C.PEOPLE, "crossing", _K.WRONG,
        "somebody crosses 1.5 m ahead of the drone, from 2 m to its left", "m/s", 1.0, 0.05, 3.0,
    ),
    FaultType(_C.PEOPLE, "pad", _K.WRONG, "a child stands on the pad, once the drone is away"),
    FaultType(
        _C.PEOPLE, "below", _K.WRONG, "a child comes to stand below the drone, once it hovers"
    ),
    FaultType(_C.PEOPLE, "lying", _K.WRONG, "somebody comes to lie below the drone, likewise"),
)  # fmt: skip
"""Every fault that the simulated room can have; the first of a pair is meant without an aspect."""


@cache
def fault_type(component: FaultComponent, kind: FaultKind, aspect: str = "") -> FaultType:
    """Return the type of a fault; raises ConfigError naming what the component can have."""
    if kind is FaultKind.OK and not aspect:
        return FaultType(component, "", kind, "well again")
    own = [known for known in FAULT_TYPES if known.component is component]
    for known in own:
        if known.kind is kind and aspect in (known.aspect, ""):
            return known
    part = f".{aspect}" if aspect else ""
    raise ConfigError(
        "fault",
        f"{component.value}{part}:{kind.value} is not simulated; {component.value} can have:"
        f" {', '.join(known.name for known in own)}",
    )
