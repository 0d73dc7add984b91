"""The bell of the simulated room: a visitor comes, presses it once, waits, and leaves."""

from __future__ import annotations

from dataclasses import dataclass, field

from housefly.twin.doorbell import BellWire, Doorbell


@dataclass
class Door:
    """Who is at the door, and how often the bell was heard."""

    visitor_present: bool = False
    trouble: str = ""
    presses: list[float] = field(default_factory=list)
    now: float = 0.0

    def set_visitor(self, present: bool) -> None:
        self.visitor_present = present

    @property
    def bell(self) -> Doorbell:
        return Doorbell(self, BellWire(lambda: self.presses.append(self.now), lambda: self.trouble))

    def run(self, bell: Doorbell, until: float) -> None:
        while self.now < until:
            self.now += 0.1
            bell.advance(self.now)


def test_a_visitor_comes_presses_once_and_leaves_when_nobody_lets_them_in() -> None:
    door = Door()
    bell = door.bell
    press = bell.ring(0.0, 1000.0)
    assert press.pressed and press.has_wire and door.visitor_present
    door.run(bell, 200.0)
    assert len(door.presses) == 1 and abs(1000.0 + door.presses[0] - press.at) < 0.2
    assert door.visitor_present
    door.run(bell, 250.0)
    assert not door.visitor_present and len(door.presses) == 1


def test_a_second_ring_at_once_is_none_and_a_later_one_keeps_the_visitor_waiting() -> None:
    door = Door()
    bell = door.bell
    bell.ring(0.0, 1000.0)
    second = bell.ring(0.3, 1000.3)
    assert not second.pressed and "about to press" in second.words
    door.run(bell, 230.0)
    again = bell.ring(door.now, 1230.0)
    assert again.pressed and "again" in again.words
    door.run(bell, 400.0)
    assert len(door.presses) == 2 and door.visitor_present


def test_a_bell_that_nobody_hears_is_not_pressed_and_says_why() -> None:
    door = Door(trouble="no broker")
    press = door.bell.ring(0.0, 1000.0)
    assert not press.pressed and "no broker" in press.words and not door.visitor_present


def test_whoever_stood_there_before_stays_and_a_bell_without_a_wire_says_so() -> None:
    door = Door(visitor_present=True)
    bell = Doorbell(door)
    press = bell.ring(0.0, 1000.0)
    assert press.pressed and not press.has_wire
    door.run(bell, 500.0)
    assert door.visitor_present and door.presses == []
