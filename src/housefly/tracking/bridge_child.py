"""Reads any tracking system that PyPI ``motioncapture`` knows; writes one line per frame.

A process of its own, because ``motioncapture`` connects with the interpreter's lock held and waits
for frames for ever: neither can be interrupted from inside. ``tracking.bridge`` starts it; it ends
with its parent.
"""

from __future__ import annotations

import json
import os
import signal
import sys
import threading
from typing import IO, Any

_CONNECT_TIMEOUT = 10.0
"""Longest time to connect [s] before the process ends."""


def main() -> None:
    """Read frames until the parent is gone or the system fails."""
    system, settings = sys.argv[1], json.loads(sys.argv[2])
    out = _own_output()
    threading.Thread(target=_end_with_parent, daemon=True).start()
    try:
        _bridge(system, settings, out)
    except BrokenPipeError:
        return
    except Exception as error:  # whatever the library raises; the parent says it in words
        _write(out, {"problem": str(error) or type(error).__name__})


def _bridge(system: str, settings: dict[str, str], out: IO[str]) -> None:
    import motioncapture

    signal.setitimer(signal.ITIMER_REAL, _CONNECT_TIMEOUT)
    client = motioncapture.connect(system, settings)
    signal.setitimer(signal.ITIMER_REAL, 0.0)
    _write(out, {"bodies": {}})
    while True:
        client.waitForNextFrame()
        _write(out, {"bodies": {name: _numbers(body) for name, body in client.rigidBodies.items()}})


def _numbers(body: Any) -> list[float]:
    turn = body.rotation
    return [*map(float, body.position), float(turn.w), float(turn.x), float(turn.y), float(turn.z)]


def _own_output() -> IO[str]:
    """Return the standard output; what the library itself prints goes to the standard error."""
    out = os.fdopen(os.dup(1), "w", buffering=1)
    os.dup2(2, 1)
    return out


def _write(out: IO[str], line: dict[str, Any]) -> None:
    out.write(json.dumps(line) + "\n")


def _end_with_parent() -> None:
    sys.stdin.buffer.read()
    os._exit(0)


if __name__ == "__main__":
    main()
