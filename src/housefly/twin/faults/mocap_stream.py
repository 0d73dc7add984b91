"""The frames of a tracking system that fails or lies."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable
from dataclasses import replace

from housefly.geometry import Vec2
from housefly.messages import Pose
from housefly.twin.contracts import MocapFrame
from housefly.twin.faults.fault import Fault, FaultSchedule, seeded_uniform
from housefly.twin.faults.pose_lies import body_lie, room_lie
from housefly.twin.faults.slots import Slots
from housefly.twin.faults.vocabulary import FaultComponent, FaultKind

Bodies = tuple[tuple[str, Pose | None], ...]


class MocapStream:
    """Passes frames on; what is active when a frame is exposed befalls it.

    Args:
        drone: name of the drone's body.
        rate_hz: frames per second; a stamp that lies takes the frame's number along.
    """

    def __init__(self, drone: str, rate_hz: float) -> None:
        self._drone, self._rate = drone, rate_hz
        self._pad: Vec2 | None = None
        self._slots = Slots()
        self._frozen: dict[Fault, MocapFrame] = {}
        self._waiting: deque[MocapFrame] = deque()

    def passed(
        self, frames: Iterable[MocapFrame], schedule: FaultSchedule, now: float
    ) -> tuple[MocapFrame, ...]:
        """Return what arrives by now [s], given the frames that should; oldest first."""
        frames = tuple(frames)
        if self._pad is not None and not self._waiting and not schedule.faults:
            return frames
        for frame in frames:
            self._take(frame, schedule.active(frame.captured_at, FaultComponent.MOCAP))
        arrived = []
        while self._waiting and self._waiting[0].due_at <= now:
            arrived.append(self._waiting.popleft())
        return tuple(arrived)

    def _take(self, frame: MocapFrame, active: tuple[Fault, ...]) -> None:
        if self._pad is None:
            seen = dict(frame.bodies).get(self._drone)
            self._pad = None if seen is None else seen.position[:2]
        if any(self._loses(fault, frame) for fault in active):
            return
        for fault in active:
            frame = self._restamped(fault, self._lied(fault, frame))
        if self._waiting:
            frame = replace(frame, due_at=max(frame.due_at, self._waiting[-1].due_at))
        self._waiting.append(frame)

    def _loses(self, fault: Fault, frame: MocapFrame) -> bool:
        if fault.kind is FaultKind.SLOW:
            return not self._slots.opens(fault, frame.captured_at)
        return fault.kind is FaultKind.OFF or (
            fault.kind is FaultKind.INTERMITTENT and fault.strikes(frame.number)
        )

    def _lied(self, fault: Fault, frame: MocapFrame) -> MocapFrame:
        if fault.kind is FaultKind.STUCK and not fault.aspect:
            return replace(frame, bodies=self._frozen.setdefault(fault, frame).bodies)
        if fault.aspect == "bodies":
            return replace(frame, bodies=_exchanged(frame.bodies, self._drone))
        since, pad = frame.captured_at - fault.start, self._pad or (0.0, 0.0)
        of_room, of_drone = room_lie(fault), body_lie(fault)
        bodies = tuple(
            (name, lie(fault, pose, since, pad))
            if pose is not None and (lie := of_room or (of_drone if name == self._drone else None))
            else (name, pose)
            for name, pose in frame.bodies
        )
        return replace(frame, bodies=bodies)

    def _restamped(self, fault: Fault, frame: MocapFrame) -> MocapFrame:
        restamp = _STAMPS.get((fault.aspect, fault.kind))
        if restamp is not None:
            return restamp(fault, frame, self._rate)
        if (fault.aspect, fault.kind) == ("stamp", FaultKind.STUCK):
            first = self._frozen.setdefault(fault, frame)
            return replace(frame, captured_at=first.captured_at, number=first.number)
        return frame


def _exchanged(bodies: Bodies, drone: str) -> Bodies:
    """Return the bodies with the drone's pose and another's exchanged, one that is seen if any."""
    if len(bodies) < 2:
        return bodies
    poses = dict(bodies)
    others = [name for name in poses if name != drone]
    other = next((name for name in others if poses[name] is not None), others[0])
    swapped = {drone: poses.get(other), other: poses.get(drone)}
    return tuple((name, swapped.get(name, pose)) for name, pose in bodies)


def _late(fault: Fault, frame: MocapFrame, rate: float) -> MocapFrame:
    return replace(frame, due_at=frame.due_at + fault.size)


def _late_and_fresh(fault: Fault, frame: MocapFrame, rate: float) -> MocapFrame:
    late = _late(fault, frame, rate)
    return replace(late, captured_at=frame.captured_at + fault.size)


def _shifted(frame: MocapFrame, by: float, rate: float) -> MocapFrame:
    number = max(0, frame.number + round(by * rate))
    return replace(frame, captured_at=frame.captured_at + by, number=number)


def _mixed_up(fault: Fault, frame: MocapFrame, rate: float) -> MocapFrame:
    return _shifted(
        frame, fault.size * (2.0 * seeded_uniform(fault.seed, frame.number) - 1.0), rate
    )


_STAMPS: dict[tuple[str, FaultKind], Callable[[Fault, MocapFrame, float], MocapFrame]] = {
    ("", FaultKind.DELAYED): _late,
    ("latency", FaultKind.WRONG): _late_and_fresh,
    ("stamp", FaultKind.WRONG): lambda fault, frame, rate: _shifted(frame, fault.size, rate),
    ("stamp", FaultKind.GARBAGE): _mixed_up,
}
