"""Faces blurred by a program of one's own: pictures in, pictures of the same size out.

The program runs as long as pictures come. It reads binary PPM pictures (P6, 8 bits) from its input,
one after the other, and writes each back to its output, blurred.
"""

from __future__ import annotations

import os
import re
import selectors
import shlex
import shutil
import subprocess
import time

import numpy as np

from housefly.errors import ConfigError, HouseflyError
from housefly.evidence.picture_codec import Picture

_TIMEOUT = 5.0
"""Longest time for one picture [s]."""
_CHUNK = 2**16
_HEADER = re.compile(rb"P6\s+(\d{1,5})\s+(\d{1,5})\s+255\s")
_HEADER_MAX = 32


class BlurCommand:
    """Implements ``face_blur.FaceBlur``.

    Args:
        command: the program with its arguments, as in a shell.
        timeout: for one picture [s].

    Raises:
        ConfigError: there is no such program.
    """

    def __init__(self, command: str, timeout: float = _TIMEOUT) -> None:
        try:
            self._command = shlex.split(command)
        except ValueError as error:
            raise ConfigError("tasks.blur_command", f"is {command!r}: {error}") from error
        if not self._command or shutil.which(self._command[0]) is None:
            words = f"is {command!r}; allowed: a program that can be started"
            raise ConfigError("tasks.blur_command", words)
        self._timeout = timeout
        self._process: subprocess.Popen[bytes] | None = None

    def blurred(self, picture: Picture) -> Picture:
        """Return a picture without faces; raises HouseflyError when the program gives none."""
        height, width, _ = picture.shape
        sent = b"P6\n%d %d\n255\n" % (width, height) + picture.tobytes()
        try:
            return _decoded(self._answer_to(sent), picture.shape)
        except (OSError, ValueError) as error:
            self.close()
            words = f"faces cannot be looked for: {self._command[0]}: {error}"
            raise HouseflyError(words) from error

    def close(self) -> None:
        """End the program."""
        process, self._process = self._process, None
        if process is not None:
            process.kill()
            process.communicate()

    def _answer_to(self, sent: bytes) -> bytes:
        """Return what the program answers; raises OSError, ValueError."""
        process = self._process or subprocess.Popen(
            self._command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0
        )
        self._process = process
        assert process.stdin is not None and process.stdout is not None
        for pipe in (process.stdin, process.stdout):
            os.set_blocking(pipe.fileno(), False)
        deadline, waiting, answer = time.monotonic() + self._timeout, memoryview(sent), bytearray()
        with selectors.DefaultSelector() as ready:
            ready.register(process.stdin, selectors.EVENT_WRITE)
            ready.register(process.stdout, selectors.EVENT_READ)
            while len(answer) < _expected_size(answer):
                found = ready.select(deadline - time.monotonic())
                if not found or time.monotonic() > deadline:
                    raise TimeoutError(f"no picture came back within {self._timeout:g} s")
                for key, _ in found:
                    if key.fileobj is process.stdout:
                        if not (more := os.read(key.fd, _CHUNK)):
                            raise ValueError("it ended")
                        answer += more
                    else:
                        waiting = waiting[os.write(key.fd, waiting[:_CHUNK]) :]
                        if not waiting:
                            ready.unregister(process.stdin)
        if waiting:
            raise ValueError("it answered before it had the picture")
        return bytes(answer)


def _expected_size(answer: bytearray) -> int:
    """Return how long the answer will be, at least [bytes]; raises ValueError for no picture."""
    header = _HEADER.match(answer)
    if header is None:
        if len(answer) > _HEADER_MAX:
            raise ValueError("what came back is no binary PPM picture")
        return len(answer) + 1
    return header.end() + 3 * int(header[1]) * int(header[2])


def _decoded(answer: bytes, shape: tuple[int, ...]) -> Picture:
    header = _HEADER.match(answer)
    if header is None or (int(header[2]), int(header[1])) != shape[:2]:
        raise ValueError("the picture that came back has another size")
    if len(answer) != header.end() + 3 * shape[0] * shape[1]:
        raise ValueError("more than one picture came back")
    return np.frombuffer(answer, np.uint8, offset=header.end()).reshape(shape).copy()
