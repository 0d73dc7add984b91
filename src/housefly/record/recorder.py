"""The flight recorder: the whole flight in one folder, without ever delaying it.

flight.mcap    every step, whole, and standard ROS 2 topics beside it
video.mp4      the drone's pictures, where the site has no privacy zones
truth.jsonl    where the simulated drone really was, and what it touched
site.json      the site as it was flown
summary.json   the flight in numbers
report.html    the flight in pictures
"""

from __future__ import annotations

import logging
import queue
import threading
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import av

from housefly.config.site import Site
from housefly.errors import RecordingError, WireError
from housefly.messages import LinkStatus, PilotStep, PlannedTrajectory, VideoFrame
from housefly.messages import Path as PlannedPath
from housefly.pilot.behavior.planned_trajectory import planned_trajectory
from housefly.record import ros_messages
from housefly.record.mcap_log import McapLog
from housefly.record.movie import Movie
from housefly.record.replay import STEP_CHANNEL, read_steps
from housefly.record.report import write_report
from housefly.record.ros_topics import StepTopics
from housefly.record.series import collect
from housefly.record.summary import Summary, summarize_flight
from housefly.record.truth import TRUTH_FILE, read_truth
from housefly.room.grid import OccupancyGrid
from housefly.room.model import Room

_log = logging.getLogger(__name__)

_QUEUE_SIZE = 2000
"""Messages waiting for the disk: more than ten seconds of a flight with video."""
_TRUTH_LATE = 5.0
"""The simulated room may end this much before the pilot [s]."""
_PATIENCE = 2.0
"""How long a sender waits for room in the queue [s]; only a lock-step flight outruns the disk."""


class FlightRecorder:
    """Records one flight; ``add_step`` and its like are thread-safe and never raise.

    Args:
        directory: where the files go; made if need be.
        site, room, grid: what is flown in.

    Raises:
        RecordingError: the directory cannot be written to.
    """

    def __init__(self, directory: Path, site: Site, room: Room, grid: OccupancyGrid) -> None:
        self._directory, self._site, self._room, self._grid = directory, site, room, grid
        self._topics = StepTopics(site.map.flight_height)
        self._problems: list[str] = []
        self._video_frames = 0
        self._map_written = False
        self._planned: list[PlannedTrajectory] = []
        self._path: PlannedPath | None = None
        try:
            directory.mkdir(mode=0o700, parents=True, exist_ok=True)
            (directory / "site.json").write_text(
                site.model_dump_json(indent=1) + "\n", encoding="utf-8"
            )
            for old in ("video.mp4", TRUTH_FILE):
                (directory / old).unlink(missing_ok=True)
            self._mcap: McapLog | None = McapLog(
                directory / "flight.mcap", {"site": site.name, "mode": site.mode, "room": room.name}
            )
        except OSError as error:
            raise RecordingError(f"{directory} cannot be written to: {error.strerror}") from error
        self._movie: Movie | None = Movie(directory / "video.mp4")
        self._queue: queue.Queue[Callable[[], None] | None] = queue.Queue(_QUEUE_SIZE)
        self._summary: Summary | None = None
        self._thread = threading.Thread(target=self._work, name="flight recorder", daemon=True)
        self._thread.start()

    @property
    def problems(self) -> tuple[str, ...]:
        """What went wrong with the recording so far."""
        return tuple(self._problems)

    @property
    def truth_file(self) -> Path:
        """Where the simulated room writes the truth, so that the summary is scored on it."""
        return self._directory / TRUTH_FILE

    def add_step(self, step: PilotStep) -> None:
        """Record one step of the pilot."""
        # Only a step that has crossed no wire still knows its path in space.
        before, path = self._path, step.outputs.path
        self._path = path
        if path is not before and (planned := planned_trajectory(path, step.now)) is not None:
            self.add_trajectory(planned)
        self._put(lambda: self._write_step(step))

    def add_video(self, frame: VideoFrame) -> None:
        """Record one video frame, but none where the site has privacy zones: they are not blank."""
        if not self._site.tasks.privacy_zones:
            self._put(lambda: self._write_video(frame))

    def add_trajectory(self, planned: PlannedTrajectory) -> None:
        """Record the path in use as it is planned in space; saying it again changes nothing."""
        if not self._planned or self._planned[-1].points != planned.points:
            self._planned.append(planned)
            self._put(
                lambda: self._into_mcap(
                    lambda log: log.add_own("/housefly/trajectory", planned.at, planned)
                )
            )

    def add_link(self, status: LinkStatus) -> None:
        """Record the health of the wires."""
        self._put(lambda: self._write_link(status))

    def finish(self, outcome: str, steps: Iterable[PilotStep] | None = None) -> Summary:
        """Close the recording, write summary and report, and return the summary.

        A second call returns the same summary.

        Args:
            outcome: "completed", or why not.
            steps: all that were recorded, where the caller has kept them; else the file is read.
        """
        if self._summary is None:
            self._queue.put(None)
            self._thread.join()
            self._summary = self._conclude(outcome, self._readable() if steps is None else steps)
        return self._summary

    def _put(self, work: Callable[[], None]) -> None:
        if self._summary is not None:
            return
        try:
            self._queue.put(work, timeout=_PATIENCE)
        except queue.Full:
            self._report("the disk is too slow: some of the flight was not recorded")

    def _work(self) -> None:
        while (work := self._queue.get()) is not None:
            work()
        self._guard("flight.mcap", self._mcap.close if self._mcap else lambda: None)
        self._guard("video.mp4", self._movie.close if self._movie else lambda: None)

    def _write_step(self, step: PilotStep) -> None:
        def write(log: McapLog) -> None:
            if not self._map_written:
                self._map_written = True
                log.add("/map", step.now, ros_messages.occupancy(step.now, self._grid))
            log.add_own(STEP_CHANNEL, step.now, step)
            for sample in self._topics.of(step):
                log.add(*sample)

        self._into_mcap(write)

    def _write_link(self, status: LinkStatus) -> None:
        self._into_mcap(lambda log: log.add_own("/housefly/link", status.at, status))

    def _write_video(self, frame: VideoFrame) -> None:
        self._video_frames += 1
        self._into_mcap(
            lambda log: log.add("/video", frame.received_at, ros_messages.compressed_video(frame))
        )
        movie = self._movie
        if movie is not None and not self._guard("video.mp4", lambda: movie.add(frame)):
            self._movie = None

    def _into_mcap(self, write: Callable[[McapLog], None]) -> None:
        log = self._mcap
        if log is None:
            return
        if not self._guard("flight.mcap", lambda: write(log)):
            self._mcap = None

    def _guard(self, name: str, work: Callable[[], Any]) -> bool:
        """Do the work and return whether the file can go on; failures are only reported."""
        try:
            work()
        except WireError as error:
            self._report(f"{name} lacks a message: {error}")
        except (OSError, av.FFmpegError, ValueError) as error:
            self._report(f"{name} is incomplete: {error}")
            return False
        return True

    def _report(self, problem: str) -> None:
        if problem not in self._problems:
            self._problems.append(problem)
            _log.error("recording: %s", problem)

    def _conclude(self, outcome: str, steps: Iterable[PilotStep]) -> Summary:
        flight = collect(steps, self._site.tracking.body, self._planned)
        truth = read_truth(self.truth_file)
        if truth is not None and flight.time.size:
            missing = float(flight.time[-1] - truth.time[-1])
            if missing > _TRUTH_LATE:
                self._report(
                    f"{TRUTH_FILE} ends {missing:.0f} s before the flight does: what is scored on"
                    " it lacks that time"
                )
        summary = summarize_flight(
            flight,
            outcome,
            self._site,
            self._room,
            self._grid,
            truth=truth,
            video_frames=self._video_frames,
            problems=self.problems,
        )
        self._guard(
            "summary.json",
            lambda: (self._directory / "summary.json").write_text(
                summary.to_json(), encoding="utf-8"
            ),
        )
        report = self._directory / "report.html"
        self._guard(
            "report.html",
            lambda: write_report(report, flight, summary, self._site, self._room, self._grid),
        )
        return summary

    def _readable(self) -> Iterable[PilotStep]:
        try:
            yield from read_steps(self._directory / "flight.mcap")
        except RecordingError as error:
            self._report(str(error))
