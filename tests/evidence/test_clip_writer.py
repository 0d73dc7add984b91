"""Whatever a crash leaves of a clip is finished so that it plays, or removed."""

from __future__ import annotations

import resource
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import av
from filming import number_of, video
from hypothesis import example, given, settings
from hypothesis import strategies as st

from housefly.evidence.clip_writer import ClipWriter, duration_of, finish_leftover


@cache
def unfinished() -> bytes:
    """Return what is on the disk after three seconds of recording."""
    with TemporaryDirectory() as folder:
        writer = ClipWriter(Path(folder) / "a.mp4")
        for frame in video(3.1, group=5):
            writer.add(frame)
        written = (Path(folder) / "a.mp4.part").read_bytes()
        writer.abandon()
        return written


@settings(max_examples=10)
@example(0.0, b"no clip at all")
@given(st.floats(0.0, 1.0), st.binary(max_size=40))
def test_a_torn_clip_plays_as_far_as_it_is_whole(share: float, garbage: bytes) -> None:
    whole = unfinished()
    with TemporaryDirectory() as folder:
        part = Path(folder) / "a.mp4.part"
        torn = whole[: round(share * len(whole))] + garbage
        part.write_bytes(torn)
        path = finish_leftover(part)
        assert not part.exists()
        if path is None:
            assert share < 0.6
            assert not list(Path(folder).iterdir())
            return
        try:
            with av.open(str(path)) as clip:
                shown = list(clip.decode(video=0))
        except (av.FFmpegError, IndexError):
            assert share < 0.6 and path.read_bytes() == torn, "kept as it is, for who can read it"
            return
        numbers = [number_of(frame.to_ndarray(format="rgb24")) for frame in shown]
        assert numbers == list(range(len(numbers)))
        assert len(numbers) >= 46 * share - 10, "at most two groups are lost"


def test_a_disk_without_room_for_a_copy_loses_nothing_of_a_clip(tmp_path: Path) -> None:
    """A limit on the size of files stands for a full disk: the same call fails."""
    part = tmp_path / "a.mp4.part"
    part.write_bytes(unfinished())
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (len(unfinished()) // 2, limits[1]))
    try:
        path = finish_leftover(part)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert path is not None
    assert list(tmp_path.iterdir()) == [path]
    assert path.read_bytes() == unfinished()
    with av.open(str(path)) as clip:
        assert sum(1 for _ in clip.decode(video=0)) >= 35
    assert 2.3 < duration_of(path) < 3.2


def test_a_clip_has_its_name_only_when_it_is_whole(tmp_path: Path) -> None:
    writer = ClipWriter(tmp_path / "a.mp4")
    for frame in video(1.0):
        writer.add(frame)
        assert [path.name for path in tmp_path.iterdir()] == ["a.mp4.part"]
    assert (tmp_path / "a.mp4.part").stat().st_mode & 0o777 == 0o600
    assert writer.finish() is not None
    assert [path.name for path in tmp_path.iterdir()] == ["a.mp4"]
    assert (tmp_path / "a.mp4").stat().st_mode & 0o777 == 0o600
