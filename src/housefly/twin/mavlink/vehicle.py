"""The autopilot of a simulated drone: modes, arming, setpoints, and what it does in silence.

It knows no socket: messages come in, and messages go out. Its time is the world's.
"""

from __future__ import annotations

from collections.abc import Callable
from math import isfinite
from typing import Any

from housefly.clock import ClockOffset
from housefly.geometry import Vec3, wrap_angle
from housefly.messages import Pose, VelocitySetpoint
from housefly.twin.contracts import FlightState, OnboardLimits, OnboardState, TwinDrone
from housefly.twin.mavlink.parameters import Parameters
from housefly.wires.mavlink.autopilots import AUTOPILOTS, TAKE_OFF_HEIGHT, FlightMode
from housefly.wires.mavlink.dialect import dialect
from housefly.wires.mavlink.poses import pose_in, vision_in
from housefly.wires.mavlink.reports import Landed, Result
from housefly.wires.mavlink.requests import GROUND_SYSTEM, CommandId
from housefly.wires.mavlink.setpoints import setpoint_in

_FORCE = 21196.0
_FRESH_POSE = 1.0
"""Without a pose for longer it knows no position, and does not arm [s]."""
_POSELESS = {"arducopter": 8.0, "px4": 5.0}
"""It flies on its own reckoning for so long [s]: measured on ArduCopter's own program; PX4's
EKF2_NOAID_TOUT by its description."""
_STREAM_AGE_MAX = 0.5
"""PX4 wants two setpoints a second before OFFBOARD [s]."""
_GCS_TIMEOUT = 5.0
_PAUSE = {"arducopter": 4.0, "px4": 0.0}
"""It stays so long where it is before a landing of its own [s]: LAND_WITH_DELAY_MS; measured."""
_HEADING_SHARE = 0.05
_CLIMB = VelocitySetpoint(vz=0.4)
_CRITICAL, _WARNING, _INFO = 2, 4, 6
_IN_AIR = frozenset({FlightState.FLYING, FlightState.HOVERING})
_NO_POSITION = {
    "arducopter": "Arm: Need Position Estimate",
    "px4": "Arming denied: Resolve system health failures first",
}


class MavlinkVehicle:
    """One simulated drone as ArduCopter or PX4 flies it.

    Args:
        drone: what flies.
        model: a row of ``AUTOPILOTS``.

    Attributes:
        autopilot: its row.
        parameters: what is set on it.
        mode: the number of its flight mode.
        armed: whether its motors may turn.
        has_origin: whether its map has an origin.
        is_failing: a failsafe of its own is at work.
        place: where it was told to be last [m]; None before.
        reported: what is told of its state.
    """

    def __init__(self, drone: TwinDrone, model: str) -> None:
        self._drone, self._model = drone, model
        self.autopilot = AUTOPILOTS[model]
        self.parameters = Parameters(model, self.autopilot)
        self.mode, self.armed = self.autopilot.ready.number, False
        self.has_origin = self.is_failing = False
        self.place: Vec3 | None = None
        self._heading = 0.0
        self._clock = ClockOffset(10.0)
        self._pose_at = self._setpoint_at = self._armed_at = float("-inf")
        self._ground_at: float | None = None
        self._was_airborne = self._is_stopped = False
        self._height: float | None = None
        self._lands_at: float | None = None
        self._saying: list[Any] = []
        self.reported: Callable[[OnboardState], OnboardState] = lambda onboard: onboard
        drone.set_limits(OnboardLimits(silence=3600.0))

    @property
    def drone(self) -> TwinDrone:
        """What flies."""
        return self._drone

    @property
    def onboard(self) -> OnboardState:
        """What it tells of its state."""
        return self.reported(self._drone.onboard())

    @property
    def heading(self) -> float:
        """Where it looks in our world [rad], by the poses that it was told."""
        return wrap_angle(self._heading + self._drone.onboard().psi)

    @property
    def landed(self) -> Landed:
        """Whether it flies, as it tells."""
        match self._drone.onboard().flight:
            case FlightState.TAKING_OFF:
                return Landed.TAKING_OFF
            case FlightState.LANDING:
                return Landed.LANDING
            case FlightState.FLYING | FlightState.HOVERING:
                if self._lands_at is not None:
                    return Landed.LANDING
                return Landed.TAKING_OFF if self._height is not None else Landed.IN_AIR
        return Landed.ON_GROUND

    def hear(self, message: Any) -> list[Any]:
        """Obey a message; return what is answered. Raises WireError for one that is refused."""
        obey = _OBEYED.get(message.get_type())
        return obey(self, message) if obey else []

    def step(self) -> list[Any]:
        """Let time pass up to the world's; return what it says to everybody."""
        self._drone.keep_alive()
        flight = self._drone.onboard().flight
        if self._was_airborne and not flight.airborne:
            self.armed = self.is_failing = False
            self._height = self._lands_at = None
        self._was_airborne = flight.airborne
        self._rest(flight)
        if flight in _IN_AIR:
            self._rise()
            self._bear_silence()
            self._sink()
        said, self._saying = self._saying, []
        return said

    def _rest(self, flight: FlightState) -> None:
        """Disarm by itself where it was armed and nothing came of it."""
        delay = self.parameters.number("DISARM_DELAY", 10.0)
        is_idle = self.armed and not flight.airborne and self._drone.now - self._armed_at > delay
        if is_idle:
            self.armed = False

    def _rise(self) -> None:
        """Climb on to the height that a take-off was told, beyond the drone's own."""
        if self._height is None:
            return
        if self._drone.onboard().height < self._height - 0.1:
            self._drone.steer(_CLIMB)
            return
        self._height = None
        self._drone.steer(VelocitySetpoint())
        if self.mode in self.autopilot.passing:
            self.mode = self.autopilot.ready.number

    def _bear_silence(self) -> None:
        now = self._drone.now
        steered = self.mode == self.autopilot.steered.number and self._height is None
        quiet = now - max(self._setpoint_at, self._armed_at)
        if self._model == "px4":
            if steered and quiet > self.parameters["COM_OF_LOSS_T"]:
                self._fail("Failsafe activated: no offboard signal")
        else:
            if steered and quiet > self.parameters["GUID_TIMEOUT"] and not self._is_stopped:
                self._is_stopped = True
                self._drone.steer(VelocitySetpoint())
            # without a ground station from the start there is none to lose
            is_lost = self._ground_at is not None and now - self._ground_at > _GCS_TIMEOUT
            if is_lost and self.parameters["FS_GCS_ENABLE"] == 5:
                self._fail("GCS Failsafe")
        if now - self._pose_at > _POSELESS[self._model]:
            self._fail("EKF Failsafe: changed to LAND Mode")

    def _sink(self) -> None:
        """Begin a landing of its own once it has waited for it."""
        if self._lands_at is not None and self._drone.now >= self._lands_at:
            self._lands_at = None
            self._drone.request_land()

    def _fail(self, text: str) -> None:
        if self.mode == self.autopilot.landing.number:
            return
        self.is_failing = True
        self._say(_CRITICAL, text)
        lands = self._model != "px4" or self.parameters["COM_OBL_RC_ACT"] == 4
        if lands and _PAUSE[self._model]:
            self.mode, self._height = self.autopilot.landing.number, None
            self._drone.steer(VelocitySetpoint())
            self._lands_at = self._drone.now + _PAUSE[self._model]
            return
        self._change_mode(self.autopilot.landing.number if lands else self.autopilot.ready.number)

    def _heartbeat(self, message: Any) -> list[Any]:
        if message.get_srcSystem() == GROUND_SYSTEM:
            self._ground_at = self._drone.now
        return []

    def _command(self, message: Any) -> list[Any]:
        """Obey a command with seven parameters; places of COMMAND_INT are left out."""
        is_long = message.get_type() == "COMMAND_LONG"
        tail = [message.param5, message.param6, message.param7] if is_long else [0, 0, message.z]
        given = [message.param1, message.param2, message.param3, message.param4, *tail]
        result, answers = self._result(message.command, given)
        sender = message.get_srcSystem(), message.get_srcComponent()
        acknowledge = dialect().MAVLink_command_ack_message(
            message.command, int(result), 0, 0, *sender
        )
        return [acknowledge, *answers]

    def _result(self, number: int, given: list[float]) -> tuple[Result, list[Any]]:
        match number:
            case CommandId.SET_MODE:
                return self._set_mode(given[1], given[2]), []
            case CommandId.ARM:
                return self._arm(given[0] >= 0.5, given[1] == _FORCE), []
            case CommandId.TAKE_OFF:
                return self._take_off(given[6]), []
            case CommandId.LAND:
                return self._change_mode(self.autopilot.landing.number), []
        return Result.UNSUPPORTED, []

    def _set_mode(self, main: float, sub: float) -> Result:
        if not (isfinite(main) and isfinite(sub) and 0 <= main < 256 and 0 <= sub < 256):
            return Result.DENIED
        is_packed = self.autopilot.steered.is_packed
        return self._change_mode(FlightMode(int(main), int(sub), is_packed).number)

    def _mode_message(self, message: Any) -> list[Any]:
        self._change_mode(message.custom_mode)
        return []

    def _change_mode(self, number: int) -> Result:
        autopilot = self.autopilot
        if number not in autopilot.modes:
            return Result.DENIED
        is_steered = number == autopilot.steered.number
        is_quiet = self._drone.now - self._setpoint_at > _STREAM_AGE_MAX
        if is_steered and autopilot.stream_first and is_quiet:
            self._say(_WARNING, "Switching to Offboard is currently not available")
            return Result.TEMPORARILY_REJECTED
        if is_steered and not self._knows_place():
            self._say(
                _WARNING, f"Mode change to {autopilot.mode_name(number)} failed: requires position"
            )
            return Result.FAILED
        self.mode, self._lands_at = number, None
        if not self._drone.onboard().flight.airborne or is_steered:
            return Result.ACCEPTED
        self._height = None
        if number == autopilot.landing.number:
            self._drone.request_land()
        else:
            self._drone.steer(VelocitySetpoint())
        return Result.ACCEPTED

    def _knows_place(self) -> bool:
        return self.has_origin and self._drone.now - self._pose_at < _FRESH_POSE

    def _arm(self, arms: bool, by_force: bool) -> Result:
        flight = self._drone.onboard().flight
        if not arms:
            if flight.airborne and not by_force:
                self._say(_CRITICAL, "Disarm: not landed")
                return Result.FAILED
            if flight.airborne:
                self._drone.toggle_emergency()
            self.armed = False
            return Result.ACCEPTED
        if flight.airborne or self.armed:
            return Result.ACCEPTED
        if not by_force and not self._knows_place():
            self._say(_CRITICAL, _NO_POSITION[self._model])
            return Result.TEMPORARILY_REJECTED if self._model == "px4" else Result.FAILED
        if self.mode == self.autopilot.landing.number and self._model != "px4":
            self._say(_CRITICAL, "Arm: Mode not armable")
            return Result.FAILED
        if self._drone.onboard().low_battery:
            self._say(_CRITICAL, "PreArm: Battery 1 below minimum arming voltage")
            return Result.FAILED
        if flight is FlightState.EMERGENCY:
            self._drone.toggle_emergency()
        self._drone.request_land()  # a take-off counts once for each of these
        self.armed, self._armed_at = True, self._drone.now
        if self.mode in self.autopilot.passing and self.mode != self.autopilot.ready.number:
            self._leave_ground(self.parameters.number("MIS_TAKEOFF_ALT", TAKE_OFF_HEIGHT))
        return Result.ACCEPTED

    def _take_off(self, height: float) -> Result:
        if self._drone.onboard().flight.airborne:
            return Result.FAILED
        if self._model == "px4":
            self.mode = next(iter(self.autopilot.passing - {self.autopilot.ready.number}))
            height = self.parameters["MIS_TAKEOFF_ALT"]
        elif self.mode != self.autopilot.steered.number:
            return Result.FAILED
        if not self.armed:
            return Result.ACCEPTED if self._model == "px4" else Result.FAILED
        self._leave_ground(height if isfinite(height) and height > 0.0 else TAKE_OFF_HEIGHT)
        return Result.ACCEPTED

    def _leave_ground(self, height: float) -> None:
        self._height = height
        self._drone.request_take_off()

    def _setpoint(self, message: Any) -> list[Any]:
        asked = setpoint_in(message)
        self._setpoint_at, self._is_stopped = self._drone.now, False
        flies = self._drone.onboard().flight in _IN_AIR and self._height is None
        if flies and self.mode == self.autopilot.steered.number:
            self._drone.steer(asked)
        return []

    def _odometry(self, message: Any) -> list[Any]:
        pose, sent_at = pose_in(message)
        self._told(pose, sent_at)
        return []

    def _vision(self, message: Any) -> list[Any]:
        pose, sent_at = vision_in(message)
        self._told(pose, sent_at)
        return []

    def _told(self, pose: Pose, sent_at: float) -> None:
        now = self._drone.now
        captured_at = sent_at + self._clock.least(now - sent_at, now)
        error = wrap_angle(pose.yaw - self.heading)
        self._heading += error if self.place is None else _HEADING_SHARE * error
        self.place, self._pose_at = pose.position, now
        self._drone.tell_pose(pose, captured_at)

    def _origin(self, message: Any) -> list[Any]:
        if not (message.latitude or message.longitude):
            return []
        self.has_origin = True
        origin = dialect().MAVLink_gps_global_origin_message(
            message.latitude, message.longitude, message.altitude, 0
        )
        self._saying.append(origin)
        return []

    def _parameter_asked(self, message: Any) -> list[Any]:
        name = message.param_id if message.param_index < 0 else ""
        return self.parameters.told(name or self.parameters.name_at(message.param_index))

    def _parameters_asked(self, message: Any) -> list[Any]:
        return self.parameters.told()

    def _parameter_set(self, message: Any) -> list[Any]:
        self.parameters.set(message.param_id, message.param_value)
        return self.parameters.told(message.param_id)

    def _clock_asked(self, message: Any) -> list[Any]:
        if message.tc1:
            return []
        return [dialect().MAVLink_timesync_message(int(1e9 * self._drone.now), message.ts1)]

    def _mission_asked(self, message: Any) -> list[Any]:
        sender = message.get_srcSystem(), message.get_srcComponent()
        return [dialect().MAVLink_mission_count_message(*sender, 0, message.mission_type)]

    def _say(self, severity: int, text: str) -> None:
        self._saying.append(dialect().MAVLink_statustext_message(severity, text.encode()))


_OBEYED: dict[str, Callable[[MavlinkVehicle, Any], list[Any]]] = {
    "HEARTBEAT": MavlinkVehicle._heartbeat,
    "COMMAND_LONG": MavlinkVehicle._command,
    "COMMAND_INT": MavlinkVehicle._command,
    "SET_MODE": MavlinkVehicle._mode_message,
    "SET_POSITION_TARGET_LOCAL_NED": MavlinkVehicle._setpoint,
    "ODOMETRY": MavlinkVehicle._odometry,
    "VISION_POSITION_ESTIMATE": MavlinkVehicle._vision,
    "SET_GPS_GLOBAL_ORIGIN": MavlinkVehicle._origin,
    "PARAM_REQUEST_READ": MavlinkVehicle._parameter_asked,
    "PARAM_REQUEST_LIST": MavlinkVehicle._parameters_asked,
    "PARAM_SET": MavlinkVehicle._parameter_set,
    "TIMESYNC": MavlinkVehicle._clock_asked,
    "MISSION_REQUEST_LIST": MavlinkVehicle._mission_asked,
}
"""Method of each message that it reads."""
