"""Every sentence of the paper that claims something, with what the measurements say of it."""

from __future__ import annotations

from housefly.lab.reproduction import claims_behavior, claims_control, claims_room, claims_service
from housefly.lab.reproduction.evidence import Evidence
from housefly.lab.reproduction.exhibit import Finding
from housefly.lab.reproduction.ruling import Claim, found

CLAIMS: tuple[Claim, ...] = (
    *claims_room.CLAIMS,
    *claims_behavior.CLAIMS,
    *claims_control.CLAIMS,
    *claims_service.CLAIMS,
)
"""In the order of the paper."""


def findings(evidence: Evidence) -> tuple[Finding, ...]:
    """Return one finding a claim, in the order of the paper."""
    return tuple(found(claim, evidence) for claim in CLAIMS)
