"""A simulated DJI Tello on its real ports: UDP 8889 here, 8890 and 11111 of its client.

It speaks SDK 2.0 as a Tello EDU does, without flips, curves and mission pads. What it is told in
lines is obeyed by ``PlainDrone``; steps are flown by ``steps``. The server does not advance the
world; its owner does, and its state leaves by the world's time.
"""

from __future__ import annotations

import asyncio
from dataclasses import dataclass

from housefly.errors import LinkError, WireError
from housefly.messages import Action, Command
from housefly.messages.steering import flying
from housefly.twin.address import PeerAddress, check_address
from housefly.twin.contracts import DroneCamera, EncodedPicture, FlightState, TwinDrone
from housefly.twin.link_counters import Counters
from housefly.twin.link_filters import UNFILTERED, LinkFilters
from housefly.twin.plain_drone import PlainDrone, as_measured, telemetry_of
from housefly.twin.tello.steps import Flown
from housefly.wires.tello.answers import DONE, TelloAnswer, encode_tello_answer, refusal, value
from housefly.wires.tello.conversions import full_sticks_of, native_state, velocity_of
from housefly.wires.tello.lines import (
    COMMAND_PORT,
    STATE_PORT,
    VIDEO_PORT,
    Go,
    Line,
    Question,
    SetSpeed,
    Step,
    Sticks,
    Word,
    decode_line,
)
from housefly.wires.tello.pieces import pieces_of
from housefly.wires.tello.state import STATE_RATE_HZ, TelloState, encode_state

_TICK = 0.02
"""How often it looks at the world's time [s]."""
_STATE_PERIOD = 1.0 / STATE_RATE_HZ
_STEP_PERIOD = 0.05
"""How often a step is steered [s]."""
_TAKE_OFF_BEGINS = 1.0
"""A take-off that has not begun by then is refused [s]."""
_SERIAL = "0HOUSEFLYTWIN0"


@dataclass(slots=True)
class _Awaited:
    """A take-off or landing, or a step, that is answered once it is over."""

    line: Line
    client: PeerAddress
    since: float
    flown: Flown | None = None


class TelloServer:
    """Serves one drone of the room; all calls belong to one asyncio loop.

    Args:
        drone: what flies.
        address: IP address at which it answers.
        beyond_loopback: allow an address that other machines can reach.
        filters: what stands between the client and the drone.
        port: at which it answers; another one for clients that take 8889 of this machine.

    Raises:
        ConfigError: an address that is not loopback, without ``beyond_loopback``.
    """

    def __init__(
        self,
        drone: TwinDrone,
        address: str = "127.0.0.1",
        *,
        beyond_loopback: bool = False,
        filters: LinkFilters = UNFILTERED,
        port: int = COMMAND_PORT,
    ) -> None:
        check_address("drone.address", address, beyond_loopback)
        self.counters = Counters()
        self._drone, self._address, self._port = drone, address, port
        self._plain = PlainDrone(drone, "tello")
        self._full = full_sticks_of(self._plain.airframe.response)
        self._reported = filters.reported
        self._deliver = filters.uplink(self._receive)
        self._send_state = filters.downlink(lambda data: self._send(data, STATE_PORT))
        self._link: asyncio.DatagramTransport | None = None
        self._ticking: asyncio.Task[None] | None = None
        self._peer: PeerAddress = (address, 0)
        self._client = ""
        self._streams = False
        self._awaited: _Awaited | None = None
        self._speed = 1.0
        self._motor_time, self._told_at, self._steered_at = 0.0, -1.0, -1.0
        self._seen_at = drone.now

    @property
    def camera(self) -> DroneCamera:
        """The camera whose pictures the client wants."""
        return DroneCamera.FRONT

    async def start(self) -> None:
        """Open the port; raises LinkError when it cannot be had."""
        loop = asyncio.get_running_loop()
        try:
            self._link, _ = await loop.create_datagram_endpoint(
                lambda: _Ear(self), local_addr=(self._address, self._port)
            )
        except OSError as error:
            raise LinkError(
                f"cannot serve a Tello at {self._address}:{self._port}: {error.strerror or error}"
            ) from error
        self._ticking = asyncio.create_task(self._tick(), name="tello")

    async def stop(self) -> None:
        """Close it."""
        if self._ticking is not None:
            self._ticking.cancel()
            await asyncio.gather(self._ticking, return_exceptions=True)
        if self._link is not None:
            self._link.abort()
            self._link = None

    def publish(self, picture: EncodedPicture) -> None:
        """Send a picture to the client that asked for them."""
        if not self._streams:
            return
        for piece in pieces_of(picture.data):
            self._send(piece, VIDEO_PORT)
        self.counters.frames_sent += 1

    def hear(self, datagram: bytes, client: PeerAddress) -> None:
        """Take in a datagram of a client."""
        self._peer = client
        self._deliver(datagram)

    def _receive(self, datagram: bytes) -> None:
        """Obey a line, or refuse it in a Tello's words; never raises."""
        self.counters.datagrams += 1
        try:
            line = decode_line(datagram)
        except WireError:
            self.counters.malformed += 1
            if self._client:
                self._answer(refusal(), self._peer)
            return
        if line is Word.COMMAND:
            self._client = self._peer[0]
        if not self._client:
            return
        self.counters.commands += 1
        self._drone.keep_alive()
        answer = self._obey(line)
        if answer is not None:
            self._answer(answer, self._peer)

    def _obey(self, line: Line) -> TelloAnswer | None:
        """Obey a line; return the answer, None for one that comes later or never."""
        match line:
            case Sticks():
                self._steer(line)
                return None
            case Question():
                return value(self._told(line))
            case SetSpeed(speed):
                self._speed = speed / 100.0
                return DONE
            case Step() | Go():
                return self._begin_step(line)
            case Word.TAKE_OFF:
                return self._take_off()
            case Word.LAND:
                return self._land()
            case Word.EMERGENCY:
                self._awaited = None
                if self._flight is not FlightState.EMERGENCY:
                    self._drone.toggle_emergency()
                return DONE
            case Word.STOP:
                self._awaited = None
                self._steer(Sticks())
                return DONE
            case Word.STREAM_ON | Word.STREAM_OFF:
                self._streams = line is Word.STREAM_ON
                return DONE
            case Word.COMMAND | Word.KEEP_ALIVE:
                return DONE
            case _:
                return refusal()

    @property
    def _flight(self) -> FlightState:
        return self._drone.onboard().flight

    @property
    def _hangs(self) -> bool:
        """Whether it is in the air, and nothing else is under way."""
        is_up = self._flight in (FlightState.FLYING, FlightState.HOVERING)
        return is_up and self._awaited is None

    def _steer(self, sticks: Sticks) -> None:
        if not self._hangs:
            return
        asked = velocity_of(sticks, self._full)
        self._plain.obey(Command(Action.HOVER) if sticks == Sticks() else flying(asked))

    def _take_off(self) -> TelloAnswer | None:
        if self._awaited is not None or self._flight.airborne:
            return refusal()
        if self._flight is FlightState.EMERGENCY:
            self._drone.toggle_emergency()
        self._drone.request_land()
        self._drone.request_take_off()
        self._await(Word.TAKE_OFF)
        return None

    def _land(self) -> TelloAnswer | None:
        """Begin a landing; while a take-off or a landing is under way it is not heard."""
        under_way = self._awaited is not None and self._awaited.flown is None
        if under_way or not self._flight.airborne:
            return refusal()
        self._drone.request_land()
        self._await(Word.LAND)
        return None

    def _begin_step(self, step: Step | Go) -> TelloAnswer | None:
        if not self._hangs:
            return refusal("Motor stop") if not self._flight.airborne else refusal("Not joystick")
        speed = step.speed / 100.0 if isinstance(step, Go) else self._speed
        self._await(step)
        assert self._awaited is not None
        self._awaited.flown = Flown(step, speed, self._full, self._drone.onboard())
        return None

    def _await(self, line: Line) -> None:
        self._awaited = _Awaited(line, self._peer, self._drone.now)

    async def _tick(self) -> None:
        while True:
            await asyncio.sleep(_TICK)
            now = self._drone.now
            passed, self._seen_at = now - self._seen_at, now
            if self._flight.airborne:
                self._motor_time += passed
            self._see_to(now)
            if self._client and now - self._told_at >= _STATE_PERIOD:
                self._told_at = max(self._told_at + _STATE_PERIOD, now - _STATE_PERIOD)
                self._tell_state()

    def _see_to(self, now: float) -> None:
        """Go on with what is under way, and answer it once it is over."""
        awaited = self._awaited
        if awaited is None:
            return
        if awaited.flown is not None:
            self._fly_on(awaited, awaited.flown, now)
        elif awaited.line is Word.TAKE_OFF:
            if self._flight in (FlightState.FLYING, FlightState.HOVERING):
                self._end(awaited, DONE)
            elif now - awaited.since > _TAKE_OFF_BEGINS and not self._flight.airborne:
                self._end(awaited, refusal())
        elif now - awaited.since > _TAKE_OFF_BEGINS and not self._flight.airborne:
            self._end(awaited, DONE)

    def _fly_on(self, awaited: _Awaited, flown: Flown, now: float) -> None:
        if self._flight not in (FlightState.FLYING, FlightState.HOVERING):
            self._end(awaited, refusal("Auto land"))
            return
        if now - self._steered_at < _STEP_PERIOD:
            return
        self._steered_at = now
        velocity = flown.velocity(self._drone.onboard())
        if velocity is not None:
            self._plain.obey(flying(velocity))
            return
        self._plain.obey(Command(Action.HOVER))
        self._end(awaited, refusal("Run timeout") if flown.has_failed else DONE)

    def _end(self, awaited: _Awaited, answer: TelloAnswer) -> None:
        self._awaited = None
        self._answer(answer, awaited.client)

    def _state(self) -> TelloState:
        """Return its state; raises ValueError for one that is not in numbers."""
        onboard = self._reported(self._drone.onboard())
        report = as_measured(telemetry_of(onboard), self._plain.airframe.lacks)
        return native_state(report, self._motor_time, onboard.velocity[2])

    def _tell_state(self) -> None:
        try:
            self._send_state(encode_state(self._state()))
        except ValueError:
            self.counters.navdata_unsent += 1
            return
        self.counters.navdata_sent += 1

    def _told(self, question: Question) -> str:
        state = self._state()
        return {
            Question.BATTERY: f"{state.bat}",
            Question.SPEED: f"{100.0 * self._speed:.1f}",
            Question.TIME: f"{state.time}s",
            Question.WIFI: "90",
            Question.SDK: "20",
            Question.SERIAL: _SERIAL,
            Question.HEIGHT: f"{state.h // 10}dm",
            Question.TEMPERATURE: f"{state.templ}~{state.temph}C",
            Question.ATTITUDE: f"pitch:{state.pitch};roll:{state.roll};yaw:{state.yaw};",
            Question.BAROMETER: f"{state.baro:.6f}",
            Question.DISTANCE: f"{10 * state.tof}mm",
            Question.ACCELERATION: f"agx:{state.agx:.2f};agy:{state.agy:.2f};agz:{state.agz:.2f};",
        }[question]

    def _answer(self, answer: TelloAnswer, client: PeerAddress) -> None:
        if self._link is not None:
            self._link.sendto(encode_tello_answer(answer), client)

    def _send(self, data: bytes, port: int) -> None:
        if self._link is not None and self._client:
            self._link.sendto(data, (self._client, port))


class _Ear(asyncio.DatagramProtocol):
    """Hears the clients."""

    def __init__(self, server: TelloServer) -> None:
        self._server = server

    def datagram_received(self, data: bytes, addr: PeerAddress) -> None:
        """Pass on a line."""
        self._server.hear(data, addr)

    def error_received(self, exc: Exception) -> None:
        """Ignore that a client is gone."""
