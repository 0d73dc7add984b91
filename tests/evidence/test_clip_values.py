"""Why clips are refused, as everybody who asks the tasks knows it."""

from __future__ import annotations

from housefly.evidence.clip_values import ClipRefusal
from housefly.tasks.api.values import ReasonCode


def test_each_refusal_is_a_reason_of_the_tasks() -> None:
    assert {refusal.value for refusal in ClipRefusal} <= {reason.value for reason in ReasonCode}
