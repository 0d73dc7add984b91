"""What a Tello answers on UDP 8889: ``ok``, a refusal in its own words, or a value.

An answer does not say what it answers. A take-off and a landing are answered once they are over;
``rc`` never is.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from housefly.errors import WireError

ANSWER_BYTES_MAX = 256
_REFUSALS = ("error", "unknown command", "false", "timeout")


class AnswerKind(Enum):
    """What sort of answer it is."""

    DONE = "done"
    REFUSED = "refused"
    VALUE = "value"


@dataclass(frozen=True, slots=True)
class TelloAnswer:
    """One answer; ``text`` is what it said."""

    kind: AnswerKind
    text: str


DONE = TelloAnswer(AnswerKind.DONE, "ok")


def refusal(reason: str = "") -> TelloAnswer:
    """Return a refusal with a reason in the drone's words."""
    return TelloAnswer(AnswerKind.REFUSED, f"error {reason}".strip())


def value(text: str) -> TelloAnswer:
    """Return the answer to a question."""
    return TelloAnswer(AnswerKind.VALUE, text)


def encode_tello_answer(answer: TelloAnswer) -> bytes:
    """Return the datagram of an answer."""
    return answer.text.encode("ascii", "replace")


def decode_tello_answer(datagram: bytes) -> TelloAnswer:
    """Read an answer; raises WireError for what is no line of text."""
    if len(datagram) > ANSWER_BYTES_MAX:
        raise WireError(f"an answer of {len(datagram)} bytes; allowed: {ANSWER_BYTES_MAX}")
    try:
        text = datagram.decode("ascii").strip("\r\n\0 ")
    except UnicodeDecodeError as error:
        raise WireError(f"an answer that is not text: {datagram[:40]!r}") from error
    if not text or not text.isprintable():
        raise WireError(f"an answer that is not a line of text: {datagram[:40]!r}")
    lowered = text.lower()
    if lowered == "ok":
        return DONE
    is_refused = lowered.startswith(_REFUSALS)
    return TelloAnswer(AnswerKind.REFUSED if is_refused else AnswerKind.VALUE, text)
