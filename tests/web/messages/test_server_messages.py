from __future__ import annotations

import json

from housefly.web.messages.server_messages import AcceptedReply, PongReply, to_text


def test_numbers_that_are_not_finite_become_null() -> None:
    assert json.loads(to_text(PongReply(float("nan"), 1.0)))["sent"] is None


def test_every_message_says_its_type() -> None:
    assert json.loads(to_text(AcceptedReply(3))) == {"id": 3, "type": "accepted"}
