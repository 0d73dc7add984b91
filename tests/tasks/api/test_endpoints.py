"""What may be said over HTTP: every filter of what is read, and no number without end."""

from dataclasses import fields

import pytest

from housefly.errors import HouseflyError
from housefly.tasks.api.endpoints import FILLED_IN, TASK_ENDPOINTS, TaskEndpoint
from housefly.tasks.api.json import task_question_from_json

READING = [endpoint for endpoint in TASK_ENDPOINTS if endpoint.method == "GET"]


@pytest.mark.parametrize("endpoint", READING, ids=lambda endpoint: endpoint.path)
def test_every_filter_of_what_is_read_can_be_given(endpoint: TaskEndpoint) -> None:
    assert not {field.name for field in fields(endpoint.question)} & set(FILLED_IN)


@pytest.mark.parametrize("number", ["Infinity", "-1e999", "NaN"])
def test_a_parameter_without_end_is_refused(number: str) -> None:
    text = '{"ask":"request","service":"look","parameters":{"distance":%s}}'
    assert task_question_from_json(text % "1.5")
    with pytest.raises(HouseflyError, match="finite"):
        task_question_from_json(text % number)
