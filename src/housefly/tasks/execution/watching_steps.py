"""Steps that watch: a panorama by turning on the spot, and following a person."""

from __future__ import annotations

from dataclasses import replace
from math import cos, pi, radians, sin

from housefly.config.people import PeopleConfig
from housefly.errors import HouseflyError
from housefly.geometry import Vec2, Vec3, distance, heading_to, wrap_angle
from housefly.messages import Order, OrderKind
from housefly.messages.words import Words
from housefly.room.level_camera import LevelCamera
from housefly.tasks.api.values import ReasonCode
from housefly.tasks.execution.flight_steps import (
    ARRIVED_WITHIN,
    FACE_HEIGHT,
    FACING_TIME,
    FACING_WITHIN,
    REGO_PERIOD,
    FlightStep,
    has_moved,
    nearest_person,
)
from housefly.tasks.execution.last_seen import ANYBODY, age_of
from housefly.tasks.execution.step_behavior import StepFailed
from housefly.tasks.execution.values import Say
from housefly.tasks.vantage.viewpoint import Viewpoint

SWEEP_RADIUS = 2.0
"""The points faced in a panorama lie so far around the drone [m]."""
UNSEEN_TIME = 3.0
"""Whom nothing saw for longer [s] is not flown after, wherever the memory has them."""
COMFORT_DISTANCE = PeopleConfig().comfort_distance + PeopleConfig().body_radius
"""No step asks to hover nearer to where somebody stands [m]; the pilot keeps its own distance."""
TURN_FROM = 0.25
"""Who is so far beside the middle of the picture is turned to [rad]."""
PICTURE_EDGE = LevelCamera.of(None).width / 2.0
"""From the middle of a usual picture to its edge [rad]."""


class Sweep(FlightStep):
    """Turns on the spot and takes a picture in each direction."""

    def begin(self) -> None:
        """Work out the directions and turn to the first."""
        inputs = self.context.inputs
        if not self.context.hovers or inputs.position is None or inputs.yaw is None:
            raise StepFailed("a panorama is taken where the drone hovers; fly there first")
        count, angle = int(self.number("views")), radians(self.number("angle"))
        is_whole = angle > 2.0 * pi - 0.01
        pitch = angle / count if is_whole else angle / (count - 1)
        first = inputs.yaw if is_whole else inputs.yaw - 0.5 * angle
        self._left = [wrap_angle(first + index * pitch) for index in range(count)]
        self._here: Vec3 = inputs.position
        self.context.looks = Words("Looking around")
        super().begin()

    def order(self) -> Order:
        """Return the order to stay here and face the next direction."""
        x, y, z = self._here
        yaw = self._left[0]
        point = (x + SWEEP_RADIUS * cos(yaw), y + SWEEP_RADIUS * sin(yaw), z)
        return Order(OrderKind.GO, goal=(x, y), look_at=point)

    def send(self) -> None:
        """Turn."""
        self._sent = self.context.time
        super().send()

    def proceed(self) -> bool:
        """Take a picture when it faces the direction; return whether it was the last."""
        if not self.is_accepted() or not self._is_turned():
            return False
        self.context.actions.append(self.context.snapshot(self.text("subject")))
        self._left.pop(0)
        if not self._left:
            return True
        self._tries = 0
        self.send()
        return False

    def limit(self) -> float:
        """Return the longest time that it may take [s]."""
        timeout = self.step.timeout
        return timeout if isinstance(timeout, float) else 20.0 + 2.0 * FACING_TIME * 36.0

    def _is_turned(self) -> bool:
        yaw, elapsed = self.context.inputs.yaw, self.context.time - self._sent
        if yaw is None or not self.context.hovers or elapsed < 0.5:
            return False
        return abs(wrap_angle(self._left[0] - yaw)) < FACING_WITHIN or elapsed > 2.0 * FACING_TIME


class Follow(FlightStep):
    """Keeps a person in view: flies anew when where they are seen from moved.

    Whoever flies looks where it flies: as long as the drone sees the person from where it is, or is
    about to be, it only turns. Where the memory has somebody is no sight of them: whoever is not
    seen for a time is lost. Then the drone hovers, says so, looks where they were last if it is
    told to, and gives up.
    """

    TIMED_BY = "time"

    def begin(self) -> None:
        """Set off to where the person is seen from."""
        self._asked = self._seen = self.context.time
        self._waits = self._searches = False
        self._origin = self.context.inputs.position
        self._who = self.text("person")
        if self._who == ANYBODY:
            self._who = nearest_person(self.context, self._origin)
            self.context.faced = self._who
        self._view = self._fresh = self.context.room.viewpoint(self._who, self._origin)
        self.context.looks = Words("Following {who}", who=self.context.title_of(self._who))
        super().begin()

    def order(self) -> Order:
        """Return the order."""
        if self._waits and not self._searches:
            return Order(OrderKind.HOVER)
        return Order(OrderKind.GO, goal=self._view.position, look_at=self._view.look_at)

    def proceed(self) -> bool:
        """Return whether the time is over; fails when the person is lost."""
        self.is_accepted()
        if self.context.time - self._asked >= REGO_PERIOD:
            self._asked = self.context.time
            self._look()
        unseen, patience = self.context.time - self._seen, self.number("lost_after")
        if unseen > patience + self.number("search"):
            words = f"{self.context.title_of(self._who)} was not seen for {unseen:.0f} s"
            raise StepFailed(words, ReasonCode.UNKNOWN_THING)
        if unseen > patience and not self._searches:
            self._waits = self._searches = True
            self._view = self._fresh
            self._turn("is lost: looking where they were last")
        elif unseen > UNSEEN_TIME and not self._waits:
            self._waits = True
            self._turn(f"was not seen for {unseen:.0f} s: waiting here")
        return self.elapsed >= self.number("time")

    def limit(self) -> float:
        """Return the longest time that it may take [s]."""
        return self.number("time") + 1.0

    def _look(self) -> None:
        """Note when the person was seen last; fly after who is seen."""
        age = age_of(self._who, self.context)
        if age is not None:
            self._seen = max(self._seen, self.context.time - age)
        if age is None or age > UNSEEN_TIME:
            return
        view = self._view_now()
        if view is None:
            return
        self._fresh = view
        if self._waits:
            self._waits = self._searches = False
            self._view = view
            self._turn("is seen again")
        elif has_moved(self._view, view) or _turn_between(self._view, view) > TURN_FROM:
            self._view, self._tries = view, 0
            self.send()

    def _view_now(self) -> Viewpoint | None:
        """Return from where the person is seen now; None leaves everything as it is.

        Who comes too near is made way for by the pilot; nothing is ordered meanwhile.
        """
        here = self.context.inputs.position
        if here is None or not self._is_free(here[:2]):
            return None
        place, goal, room = here[:2], self._view.position, self.context.room
        is_on_way = distance(place, goal) > ARRIVED_WITHIN
        try:
            stays = room.view_from(self._who, place)
            if stays is not None and (not is_on_way or self._is_beside(stays)):
                return stays
            there = room.view_from(self._who, goal) if is_on_way else None
            view = there or room.viewpoint(self._who, here)
        except HouseflyError:
            return self._turned(place)
        return view if self._is_free(view.position) else self._turned(place)

    def _is_beside(self, view: Viewpoint) -> bool:
        """Return whether the drone looks elsewhere, as it does when it flies elsewhere."""
        yaw = self.context.inputs.yaw
        aim = heading_to(view.position, view.look_at[:2])
        return yaw is not None and abs(wrap_angle(aim - yaw)) > PICTURE_EDGE

    def _turned(self, here: Vec2) -> Viewpoint | None:
        """Return the view from here towards a person who is not seen well from anywhere."""
        seen = (one.position for one in self.context.room.people() if one.id == self._who)
        place = next(seen, None)
        if place is None:
            return None
        x, y, z = place
        return replace(self._view, position=here, look_at=(x, y, z + FACE_HEIGHT))

    def _turn(self, what: str) -> None:
        """Say what became of the person, and order what follows from it."""
        words = f"{self.context.title_of(self._who)} {what}"
        self.context.actions.append(Say(words[:1].upper() + words[1:]))
        self._tries = 0
        self.send()

    def _is_free(self, place: Vec2) -> bool:
        return all(
            distance(place, person.position[:2]) >= COMFORT_DISTANCE
            for person in self.context.room.people()
        )


def _turn_between(before: Viewpoint, now: Viewpoint) -> float:
    """Return by how much the drone would have to turn at its new place [rad]."""
    old, new = (heading_to(now.position, view.look_at[:2]) for view in (before, now))
    return abs(wrap_angle(new - old))
