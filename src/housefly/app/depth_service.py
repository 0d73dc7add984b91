"""Turns depth images from the bus into obstacles on the bus.

It works on the bus's own thread, so that no scanner waits for an image.
"""

from __future__ import annotations

import threading
from math import inf

from housefly.bus.bus import Bus
from housefly.bus.topics import DEPTH_TOPIC, OBSTACLE_TOPIC
from housefly.clock import Clock
from housefly.messages import DepthImage, SensorReport
from housefly.messages.words import UNSAID, Words, literal
from housefly.perception.depth_tracker import DepthTracker
from housefly.perception.laser_tracker import OwnFootprint
from housefly.perception.sensor_freshness import SensorFreshness
from housefly.room.tracked import untracked
from housefly.sensors.message_rate import MessageRate
from housefly.sites.loaded_site import LoadedSite

CAMERA_SILENT_AFTER = 2.0
"""A camera that sends nothing for this long is reported [s]."""
REFUSED_IMAGE_SHOWN_FOR = 5.0
"""A refused image is reported for this long [s]."""


class DepthService:
    """Processes the images of a site's depth cameras, until closed.

    Attributes:
        own: where our drones are, of those in the air whose place is known.
        sight: until when the cameras were believed.
    """

    def __init__(self, loaded: LoadedSite, bus: Bus, clock: Clock) -> None:
        site = loaded.site
        height, half = site.map.flight_height, site.map.half_band
        self.own: tuple[OwnFootprint, ...] = ()
        self._bus, self._clock = bus, clock
        self._tracker = DepthTracker(
            untracked(loaded.room, site), site.depth_cameras, (height - half, height + half)
        )
        names = [camera.name for camera in site.depth_cameras]
        self.sight = SensorFreshness(names)
        self._lock = threading.Lock()
        self._rates = {name: MessageRate() for name in names}
        self._refused = dict.fromkeys(["", *names], ("", -inf))
        self._subscription = bus.subscribe(DEPTH_TOPIC, self._on_image) if names else None

    def reports(self) -> tuple[SensorReport, ...]:
        """Return the state of each camera, and of a sender that is no camera of this site."""
        with self._lock:
            reports = [
                self._report(name, rate, self._clock.now()) for name, rate in self._rates.items()
            ]
            return (*reports, *self._strangers(self._clock.now()))

    def _report(self, name: str, rate: MessageRate, now: float) -> SensorReport:
        age = rate.age(now)
        is_sending = age <= CAMERA_SILENT_AFTER
        problem = self._refusal(name, now) or (
            UNSAID if is_sending else Words("{name}: no depth images", name=name)
        )
        return SensorReport(name, "depth camera", is_sending, rate.rate_hz(now), age, problem)

    def _strangers(self, now: float) -> tuple[SensorReport, ...]:
        problem = self._refusal("", now)
        return (
            (SensorReport("other images", "depth camera", False, 0.0, inf, problem),)
            if problem
            else ()
        )

    def _refusal(self, name: str, now: float) -> Words:
        words, at = self._refused[name]
        return literal(words) if now - at < REFUSED_IMAGE_SHOWN_FOR else UNSAID

    def close(self) -> None:
        """Stop listening."""
        if self._subscription is not None:
            self._subscription.close()

    def _on_image(self, image: DepthImage) -> None:
        now = self._clock.now()
        name = image.source if image.source in self._rates else ""
        seen = self._tracker.update(image, now, self.own)
        with self._lock:
            if name:
                self._rates[name].add(now)
            if seen.problem:
                self._refused[name] = seen.problem, now
            else:
                self.sight.believed(name, image.captured_at)
        for obstacle in seen.obstacles:
            self._bus.publish(OBSTACLE_TOPIC, obstacle)
