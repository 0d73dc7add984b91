"""What a browser may filter by is never taken for what only the server says."""

from dataclasses import fields

import pytest

from housefly.tasks.api.endpoints import FILLED_IN, TASK_ENDPOINTS, TaskEndpoint

READING = [endpoint for endpoint in TASK_ENDPOINTS if endpoint.method == "GET"]


@pytest.mark.parametrize("endpoint", READING, ids=lambda endpoint: endpoint.path)
def test_every_filter_of_what_is_read_can_be_given(endpoint: TaskEndpoint) -> None:
    assert not {field.name for field in fields(endpoint.question)} & set(FILLED_IN)
