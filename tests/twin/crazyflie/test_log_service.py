"""Log blocks as a client may ask for them, good and bad."""

from __future__ import annotations

import pytest

from housefly.config.site import Site
from housefly.room.files import load_room
from housefly.twin.crazyflie.firmware import CrazyflieFirmware
from housefly.twin.crazyflie.log_service import LogService
from housefly.twin.crazyflie.variables import LOG_ENTRIES, Told
from housefly.twin.world import SimulatedWorld
from housefly.wires.crazyflie.log_blocks import (
    BLOCKS_MAX,
    BlockError,
    BlockOrder,
    BlockRequest,
    read_block_answer,
    read_values,
)
from housefly.wires.crazyflie.tables import ValueType

NUMBERS = {entry.name: number for number, entry in enumerate(LOG_ENTRIES)}
X, YAW = NUMBERS["stateEstimate.x"], NUMBERS["stateEstimate.yaw"]
FLOAT = ValueType.FLOAT


@pytest.fixture(scope="module")
def told() -> Told:
    site = Site(drone={"kind": "crazyflie"})
    world = SimulatedWorld(site, load_room(site.room.model))
    world.advance(0.1)
    assert isinstance(world.firmware, CrazyflieFirmware)
    world.firmware.estimator.position = (-3.0, 2.0, 1.0)
    return world.firmware, world.onboard()


def answered(log: LogService, request: BlockRequest, now: float = 0.0) -> int:
    order, block, error = read_block_answer(log.obey(request, now))
    assert (order, block) == (request.order, request.block)
    return error


def created(block: int, *variables: tuple[ValueType, int]) -> BlockRequest:
    return BlockRequest(BlockOrder.CREATE, block, variables)


def test_a_block_is_sent_at_its_rate_until_it_is_stopped(told: Told) -> None:
    log = LogService()
    assert answered(log, created(3, (FLOAT, X), (FLOAT, YAW))) == BlockError.NONE
    assert answered(log, BlockRequest(BlockOrder.START, 3, period=0.05)) == BlockError.NONE
    sent = [packet for tick in range(100) for packet in log.due(told, 0.01 * tick)]
    assert len(sent) == 20
    clock, (x, _) = read_values(sent[-1], (FLOAT, FLOAT))
    assert 940 <= clock <= 970 and x == -3.0
    assert answered(log, BlockRequest(BlockOrder.STOP, 3)) == BlockError.NONE
    assert log.due(told, 2.0) == []


def test_a_value_that_does_not_fit_the_type_it_is_asked_for_as_stops_no_other_block(
    told: Told,
) -> None:
    log = LogService()
    for block, kind in ((1, ValueType.UINT8), (2, FLOAT)):
        answered(log, created(block, (kind, X)))
        answered(log, BlockRequest(BlockOrder.START, block, period=0.01))
    assert [packet.data[0] for packet in log.due(told, 0.0)] == [2]


def test_what_cannot_be_is_refused_with_its_number() -> None:
    log = LogService()
    assert answered(log, BlockRequest(BlockOrder.START, 9)) == BlockError.NO_SUCH_BLOCK
    assert answered(log, created(1, (FLOAT, 999))) == BlockError.NO_SUCH_BLOCK
    assert answered(log, created(1, *((FLOAT, X),) * 7)) == BlockError.TOO_LARGE
    assert answered(log, created(1, (FLOAT, X))) == BlockError.NONE
    assert answered(log, created(1, (FLOAT, X))) == BlockError.EXISTS
    for block in range(2, BLOCKS_MAX + 1):
        assert answered(log, created(block)) == BlockError.NONE
    assert answered(log, created(99)) == BlockError.NO_MEMORY
    assert answered(log, BlockRequest(BlockOrder.RESET)) == BlockError.NONE
    assert answered(log, created(99)) == BlockError.NONE
