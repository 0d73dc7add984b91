"""Which HTTP status a refusal of the tasks has."""

from __future__ import annotations

from http import HTTPStatus

from housefly.tasks.api.values import ReasonCode

_STATUS_OF_REASON = {
    ReasonCode.UNKNOWN_SERVICE: HTTPStatus.NOT_FOUND,
    ReasonCode.UNKNOWN_TASK: HTTPStatus.NOT_FOUND,
    ReasonCode.UNKNOWN_PLACE: HTTPStatus.NOT_FOUND,
    ReasonCode.UNKNOWN_THING: HTTPStatus.NOT_FOUND,
    ReasonCode.BAD_PARAMETER: HTTPStatus.UNPROCESSABLE_ENTITY,
    ReasonCode.NOT_ALLOWED: HTTPStatus.FORBIDDEN,
    ReasonCode.QUEUE_FULL: HTTPStatus.TOO_MANY_REQUESTS,
    ReasonCode.RATE_LIMIT: HTTPStatus.TOO_MANY_REQUESTS,
    ReasonCode.COOLDOWN: HTTPStatus.TOO_MANY_REQUESTS,
    ReasonCode.NOT_READY: HTTPStatus.SERVICE_UNAVAILABLE,
    ReasonCode.NO_DRONE: HTTPStatus.SERVICE_UNAVAILABLE,
    ReasonCode.NO_CAMERA: HTTPStatus.SERVICE_UNAVAILABLE,
}


def status_of_reason(code: str) -> int:
    """Return the HTTP status of a refusal; what the room does not allow now is 409."""
    known = {reason.value: status for reason, status in _STATUS_OF_REASON.items()}
    return int(known.get(code, HTTPStatus.CONFLICT))
