"""What a vehicle refused, and what it says about that, in its own words. Pure."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass

from housefly.messages.words import Words, joined, literal
from housefly.wires.mavlink.reports import Answer, Result, Said
from housefly.wires.mavlink.requests import CommandId

_GRAVE = 4
"""Lines up to this severity are warnings, or worse."""
_KEPT_FOR = 6.0
"""A line explains a refusal for so long [s]; ArduPilot repeats its own every 30 s."""
_REFUSED_FOR = 4.0
"""A refusal is told for so long after it was heard last [s]: orders are repeated each second."""
_LINES_MAX = 3
_WANTED = {
    CommandId.ARM: "arm",
    CommandId.SET_MODE: "change its mode",
    CommandId.TAKE_OFF: "take off",
}
"""What the drone will not do."""
_RESULTS = {
    Result.TEMPORARILY_REJECTED: Words("not now"),
    Result.DENIED: Words("denied"),
    Result.UNSUPPORTED: literal("unsupported"),
    Result.FAILED: literal("failed"),
    Result.CANCELLED: Words("it was cancelled"),
}


@dataclass(frozen=True, slots=True)
class _Line:
    text: str
    severity: int
    at: float


class Refusals:
    """Remembers answers and lines for as long as they explain something."""

    def __init__(self) -> None:
        self._refused: dict[CommandId, tuple[Result, float]] = {}
        self._lines: deque[_Line] = deque(maxlen=20)
        self._pieces: dict[int, dict[int, str]] = {}

    def answered(self, answer: Answer, now: float) -> None:
        """Take in what became of a command."""
        if answer.command not in _WANTED:
            return
        command = CommandId(answer.command)
        if answer.result in _RESULTS:
            self._refused[command] = answer.result, now
        else:
            self._refused.pop(command, None)

    def said(self, line: Said, now: float) -> None:
        """Take in a line; a long one is whole with its last piece, which ends early."""
        text = self._whole(line)
        if text and line.severity <= _GRAVE:
            self._lines.append(_Line(text, line.severity, now))

    def _whole(self, line: Said) -> str:
        if not line.series:
            return line.text
        pieces = self._pieces.setdefault(line.series, {})
        pieces[line.piece] = line.text
        if len(self._pieces) > 8:
            self._pieces.pop(next(iter(self._pieces)))
        if len(line.text) >= 50:
            return ""
        self._pieces.pop(line.series, None)
        return "".join(pieces[number] for number in sorted(pieces))

    def told(self, now: float) -> tuple[Words, ...]:
        """Return what it refuses now [s] and why; without a refusal its newest warnings."""
        lines = self._newest(now)
        refused = [
            (command, result)
            for command, (result, at) in self._refused.items()
            if now - at <= _REFUSED_FOR
        ]
        if not refused:
            return lines
        return tuple(
            joined(
                ": ",
                (
                    Words("the drone will not {what}", what=_WANTED[command]),
                    joined("; ", lines) if lines else _RESULTS[result],
                ),
            )
            for command, result in refused
        )

    def _newest(self, now: float) -> tuple[Words, ...]:
        texts = [line.text for line in self._lines if now - line.at <= _KEPT_FOR]
        once = dict.fromkeys(reversed(texts))
        return tuple(map(literal, list(once)[:_LINES_MAX]))
