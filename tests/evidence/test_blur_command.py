"""A program of one's own blurs faces, and where it does not nothing is recorded."""

from __future__ import annotations

import shlex
import sys
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.config.drone import DroneConfig
from housefly.config.tasks import TasksConfig
from housefly.errors import ConfigError, HouseflyError
from housefly.evidence.blur_command import BlurCommand
from housefly.evidence.clip_recorder import ClipRecorder

_READS = """
import sys
source, target = sys.stdin.buffer, sys.stdout.buffer
def picture():
    head = b"".join(source.readline() for _ in range(3))
    width, height = map(int, head.split()[1:3]) if head else sys.exit()
    return head, bytearray(source.read(3 * width * height))
"""
_BLACKENS = """
while True:
    head, pixels = picture()
    target.write(head + bytes(len(pixels) // 2) + pixels[len(pixels) // 2:])
    target.flush()
"""
_MISBEHAVES = {
    "it ended": "",
    "no binary PPM": "picture(); target.write(b'x' * 1000); target.flush(); picture()",
    "another size": "picture(); target.write(b'P6 1 1 255 abc'); target.flush(); picture()",
    "more than one": "h, p = picture(); target.write(h + p + h); target.flush(); picture()",
    "within 0.5 s": "picture(); picture()",
}


def command(program: str) -> str:
    return shlex.join([sys.executable, "-c", _READS + program])


@settings(max_examples=5, deadline=None)
@given(st.lists(st.tuples(st.integers(1, 300), st.integers(1, 300)), min_size=1, max_size=4))
def test_every_picture_comes_back_as_the_program_made_it(sizes: list[tuple[int, int]]) -> None:
    blur = BlurCommand(command(_BLACKENS))
    for height, width in sizes:
        picture = np.random.default_rng(1).integers(1, 255, (height, width, 3), np.uint8)
        answer = blur.blurred(picture)
        half = picture.size // 2
        assert not answer.ravel()[:half].any()
        assert (answer.ravel()[half:] == picture.ravel()[half:]).all()
    blur.close()


@pytest.mark.parametrize("words", _MISBEHAVES)
def test_a_program_that_gives_no_picture_back_is_named(words: str) -> None:
    timeout = 0.5 if words == "within 0.5 s" else 20.0
    blur = BlurCommand(command(_MISBEHAVES[words]), timeout)
    with pytest.raises(HouseflyError, match=words):
        blur.blurred(np.zeros((90, 160, 3), np.uint8))


@pytest.mark.parametrize("wrong", ["/nowhere/blur --fast", "'", " "])
def test_a_program_that_is_not_there_lets_nothing_be_recorded(tmp_path: Path, wrong: str) -> None:
    with pytest.raises(ConfigError, match="blur_command"):
        BlurCommand(wrong)
    recorder = ClipRecorder(
        tmp_path, TasksConfig(blur_faces=True, blur_command=wrong), DroneConfig()
    )
    assert "nothing is recorded" in recorder.problem and "blur_command" in recorder.problem
    recorder.close()
