"""Every claim of the paper, with what the measurements say about it."""

from __future__ import annotations

from housefly.lab.reproduction import claims_behavior, claims_control, claims_room, claims_service
from housefly.lab.reproduction.evidence import Evidence
from housefly.lab.reproduction.exhibit import ClaimFinding
from housefly.lab.reproduction.ruling import Claim, finding_of

CLAIMS: tuple[Claim, ...] = (
    *claims_room.ROOM_CLAIMS,
    *claims_behavior.BEHAVIOR_CLAIMS,
    *claims_control.CONTROL_CLAIMS,
    *claims_service.SERVICE_CLAIMS,
)
"""In the order of the paper."""


def findings(evidence: Evidence) -> tuple[ClaimFinding, ...]:
    """Return one finding per claim, in the order of the paper."""
    return tuple(finding_of(claim, evidence) for claim in CLAIMS)
