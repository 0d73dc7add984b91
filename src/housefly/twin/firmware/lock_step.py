"""Lock step with ArduPilot's program over UDP: one step of the room for one answer.

The room waits for the program, the program for the room. Where it does not answer in time the
motors stand, and the room goes on without it, looking for it at every step.
"""

from __future__ import annotations

import socket
from collections.abc import Callable

from housefly.errors import WireError
from housefly.twin.disturbance import MotorGains
from housefly.twin.firmware.ardupilot_json import ServoOutput, body_line, servo_output_in
from housefly.twin.simulated_body import BodyState

PATIENCE = 1.0
"""So long the room waits for an answer [s]; a program says the same again after a second."""
_DATAGRAM_MAX = 2048
_STALE_MAX = 64
"""So many datagrams are read at once; they are repetitions."""
_STOPPED: MotorGains = (0.0, 0.0, 0.0, 0.0)
_PULSE_LOW, _PULSE_SPAN = 1000.0, 1000.0


class LockStep:
    """The simulator's end of ArduPilot's wire.

    Args:
        has_ended: whether the program is gone.
        host: where the program reaches us.

    Attributes:
        port: ours.
        steps: how many were answered.
        missed: how many were not.
        broken: datagrams that were no servo packet.
    """

    def __init__(
        self, has_ended: Callable[[], bool] = lambda: False, host: str = "127.0.0.1"
    ) -> None:
        self.has_ended = has_ended
        self.steps = self.missed = self.broken = 0
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.bind((host, 0))
        self.port: int = self._socket.getsockname()[1]
        self._peer: tuple[str, int] | None = None
        self._frame: int | None = None
        self._is_lost = False

    def exchange(self, at: float, body: BodyState) -> MotorGains:
        """Return what the motors are told in the step that begins now [s], and tell of its state.

        The program's answer to a state is used from the next step on, as a sensor's is on a drone.
        """
        told = self._heard()
        if told is None:
            self.missed += 1
            self._is_lost = True
            return _STOPPED
        self.steps += 1
        self._is_lost = False
        if self._peer is not None:
            self._socket.sendto(body_line(at, body), self._peer)
        return motors_of(told)

    def close(self) -> None:
        """Release the port."""
        self._socket.close()

    def _heard(self) -> ServoOutput | None:
        """Return the next frame; None where none came in time."""
        is_waiting = self._peer is not None and not self._is_lost and not self.has_ended()
        self._socket.settimeout(PATIENCE if is_waiting else 0.0)
        for _ in range(_STALE_MAX):
            try:
                datagram, peer = self._socket.recvfrom(_DATAGRAM_MAX)
            except (TimeoutError, BlockingIOError):
                return None
            try:
                told = servo_output_in(datagram)
            except WireError:
                self.broken += 1
                continue
            is_known = peer == self._peer and told.frame == self._frame
            if is_known and not self._is_lost:
                continue
            self._peer, self._frame = peer, told.frame
            return told
        return None


def motors_of(told: ServoOutput) -> MotorGains:
    """Return the throttles of an X of four, in the order of ``quadrotor.motors``.

    ArduPilot counts front right, rear left, front left, rear right.
    """
    front_right, rear_left, front_left, rear_right = (
        min(max((pulse - _PULSE_LOW) / _PULSE_SPAN, 0.0), 1.0) for pulse in told.pulses[:4]
    )
    return front_left, front_right, rear_right, rear_left
