from __future__ import annotations

import contextlib
import json
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from housefly.messages import OrderKind
from housefly.web.messages.client_messages import CLIENT_MESSAGE


def test_an_order_is_read() -> None:
    message: Any = CLIENT_MESSAGE.validate_json(
        '{"type":"order","id":4,"order":"go","goal":[1,2.5]}'
    )
    assert (message.order, message.goal) == (OrderKind.GO, (1.0, 2.5))


@pytest.mark.parametrize(
    "text",
    [
        "",
        "null",
        "[]",
        "{}",
        '{"type":"fly"}',
        '{"type":"order","id":1,"order":"explode"}',
        '{"type":"order","id":-1,"order":"land"}',
        '{"type":"order","id":1,"order":"go","goal":[1]}',
        '{"type":"order","id":1,"order":"go","goal":[1,NaN]}',
        '{"type":"order","id":1,"order":"go","goal":[1,1e9]}',
        '{"type":"order","id":1,"order":"go","place":"x","speed":9}',
        '{"type":"order","id":1,"order":"service","look_s":1e9}',
        '{"type":"hello","tab":"short"}',
        '{"type":"lease","id":1,"action":"steal"}',
    ],
)
def test_a_message_outside_the_protocol_is_refused(text: str) -> None:
    with pytest.raises(ValidationError):
        CLIENT_MESSAGE.validate_json(text)


JSON_VALUE = st.recursive(
    st.none() | st.floats() | st.text(),
    lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner),
    max_leaves=10,
)


@given(st.text() | JSON_VALUE.map(json.dumps))
def test_any_text_is_either_read_or_refused(text: str) -> None:
    with contextlib.suppress(ValidationError):
        CLIENT_MESSAGE.validate_json(text.encode("utf-8", "replace"))
