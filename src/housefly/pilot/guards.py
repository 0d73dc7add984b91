"""Which guards a pilot has; less than all is for negative controls in the simulated room only."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Guards:
    """What keeps a flight safe.

    Attributes:
        gate: the rules of the last gate; limits of the command and a person's STOP stay.
        belief: tracking is held against what the drone itself feels.
        sight: people and things that no map shows are heeded.
    """

    gate: bool = True
    belief: bool = True
    sight: bool = True


ALL_GUARDS = Guards()
NO_GUARDS = Guards(gate=False, belief=False, sight=False)
