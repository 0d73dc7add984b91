"""What is to be started is called by its name: the makers' program, or the simulated room."""

from __future__ import annotations

import pytest

from housefly.tracking.software import software_at


@pytest.mark.parametrize(
    ("address", "called"),
    [
        ("127.0.0.1", "the simulated room"),
        ("127.3.4.5", "the simulated room"),
        ("::1", "the simulated room"),
        ("localhost", "the simulated room"),
        ("192.168.10.1", "Vicon Tracker"),
        ("vicon-pc", "Vicon Tracker"),
    ],
)
def test_the_program_at_the_other_end_is_called_by_its_name(address: str, called: str) -> None:
    assert software_at(address, "Vicon Tracker") == called
