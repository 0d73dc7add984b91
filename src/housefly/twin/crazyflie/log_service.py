"""The log blocks of the simulated Crazyflie: created by number, sent at their rate."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass

from housefly.errors import WireError
from housefly.twin.crazyflie.variables import LOG_ENTRIES, Told, logged
from housefly.wires.crazyflie.crtp import Packet
from housefly.wires.crazyflie.log_blocks import (
    BLOCK_DATA_MAX,
    BLOCKS_MAX,
    VARIABLES_MAX,
    BlockError,
    BlockOrder,
    BlockRequest,
    encode_answer,
    encode_values,
)
from housefly.wires.crazyflie.tables import ValueType


@dataclass(slots=True)
class _Block:
    variables: list[tuple[ValueType, int]]
    period: float = 0.0
    due_at: float = 0.0


class LogService:
    """Keeps the blocks of the client."""

    def __init__(self) -> None:
        self._blocks: dict[int, _Block] = {}

    def obey(self, request: BlockRequest, now: float) -> Packet:
        """Obey an order now [s]; return the answer."""
        return encode_answer(request.order, request.block, self._obeyed(request, now))

    def due(self, told: Told, now: float) -> list[Packet]:
        """Return what is to be sent now [s]; what lay behind is not caught up with."""
        packets: list[Packet] = []
        for number, block in self._blocks.items():
            if block.period <= 0.0 or now < block.due_at:
                continue
            block.due_at = max(block.due_at + block.period, now)
            values = [(kind, logged(variable, told)) for kind, variable in block.variables]
            # a value may not fit the type that it was asked for as
            with suppress(WireError):
                packets.append(encode_values(number, int(1000.0 * now), values))
        return packets

    def _obeyed(self, request: BlockRequest, now: float) -> BlockError:
        block = self._blocks.get(request.block)
        match request.order:
            case BlockOrder.RESET:
                self._blocks.clear()
            case BlockOrder.CREATE if block is not None:
                return BlockError.EXISTS
            case BlockOrder.CREATE if len(self._blocks) >= BLOCKS_MAX:
                return BlockError.NO_MEMORY
            case BlockOrder.CREATE:
                return self._add(request, _Block([]))
            case _ if block is None:
                return BlockError.NO_SUCH_BLOCK
            case BlockOrder.APPEND:
                return self._add(request, block)
            case BlockOrder.DELETE:
                del self._blocks[request.block]
            case BlockOrder.STOP:
                block.period = 0.0
            case BlockOrder.START | BlockOrder.START_MS:
                block.period, block.due_at = request.period, now
        return BlockError.NONE

    def _add(self, request: BlockRequest, block: _Block) -> BlockError:
        if any(number >= len(LOG_ENTRIES) for _, number in request.variables):
            return BlockError.NO_SUCH_BLOCK
        variables = [*block.variables, *request.variables]
        held = sum(len(one.variables) for one in self._blocks.values()) - len(block.variables)
        if held + len(variables) > VARIABLES_MAX:
            return BlockError.NO_MEMORY
        if sum(kind.form.size for kind, _ in variables) > BLOCK_DATA_MAX:
            return BlockError.TOO_LARGE
        block.variables = variables
        self._blocks[request.block] = block
        return BlockError.NONE
