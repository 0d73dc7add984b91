from __future__ import annotations

from math import atan2

import numpy as np
import pytest
from ardrone_flow import FLOW

from housefly.pilot.estimation.displacement import TRACK_ROW, keep_bias, predicted_bias
from housefly.pilot.estimation.flow_bias import first_bias


def test_what_a_row_predicts_turns_with_the_drone() -> None:
    row, new = np.zeros(2, TRACK_ROW).view(np.recarray)
    keep_bias(row, first_bias(0.0, 0.0, 0.002, FLOW)._replace(rate_x=0.004))
    new.at, new.psi = 2.0, 0.8
    expected = predicted_bias(row, new, FLOW)
    assert atan2(expected.rate_y, expected.rate_x) == pytest.approx(0.8)
    assert atan2(expected.y, expected.x) == pytest.approx(0.4)
