"""The console's link to the pilot: STOP at once, orders in sequence, questions without blocking."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor

from housefly.bus.bus import Bus
from housefly.bus.topics import HUB_QUERY, DroneTopics
from housefly.clock import Clock
from housefly.errors import HouseflyError
from housefly.hub.api.answers import EventAnswer, EventsAnswer
from housefly.hub.api.json import answer_from_json, question_to_json
from housefly.hub.api.pilot_queries import PlanRequest, PreflightView, RoomView
from housefly.hub.api.pilot_queries_json import from_json, to_json
from housefly.hub.api.questions import EventsQuestion
from housefly.messages import Order, OrderKind, PlanAnswer
from housefly.messages.order_fault import NAME_LENGTH_MAX

_LOG = logging.getLogger(__name__)

_REMEMBERED_MAX = 200
"""So many events of the memory are asked for, the newest."""


class PilotLink:
    """Sends to the pilot; everything that may block runs on a thread.

    Args:
        bus: where orders and questions go.
        topics: of its drone.
        stop: sends STOP on its own path; must return at once.
        clock: stamps the orders.
    """

    def __init__(
        self, bus: Bus, topics: DroneTopics, stop: Callable[[], object], clock: Clock
    ) -> None:
        self._topics = topics
        self._bus, self._stop, self._clock = bus, stop, clock
        self._orders = ThreadPoolExecutor(1, "orders")
        self._questions = ThreadPoolExecutor(2, "questions")
        self._stopping: Future[str] | None = None

    def stop(self, sender: str) -> object:
        """Send STOP on its own path before anything else, then over the bus as well.

        Returns:
            What the path gives: a future of its acknowledgement, where there is one.
        """
        sent: object = None
        try:
            sent = self._stop()
        except (OSError, HouseflyError):
            _LOG.exception("the STOP path failed; STOP goes over the bus alone")
        if self._stopping is None or self._stopping.done():  # a key held down fills no queue
            by = sender[:NAME_LENGTH_MAX]
            order = Order(OrderKind.STOP, issued_at=self._clock.now(), sender=by)
            self._stopping = self._orders.submit(self._publish, order)
        return sent

    def send(self, order: Order) -> asyncio.Future[str]:
        """Publish an order after earlier ones; the future holds "" or what went wrong."""
        return asyncio.wrap_future(self._orders.submit(self._publish, order))

    async def room(self) -> RoomView:
        """Ask for the room; raises LinkError or WireError."""
        return from_json(RoomView, await self._ask(self._topics.room, ""))

    async def plan(self, request: PlanRequest) -> PlanAnswer:
        """Ask for a path; raises LinkError or WireError."""
        return from_json(PlanAnswer, await self._ask(self._topics.plan, to_json(request)))

    async def preflight(self) -> PreflightView:
        """Ask what the pre-flight checks found last; raises LinkError or WireError."""
        return from_json(PreflightView, await self._ask(self._topics.preflight, ""))

    async def happened(self, body: str, since: float) -> tuple[EventAnswer, ...]:
        """Ask the room's memory what it heard of a drone [Unix time, s]; raises HouseflyError."""
        question = EventsQuestion(since, thing=body, limit=_REMEMBERED_MAX)
        answer = answer_from_json(question, await self._ask(HUB_QUERY, question_to_json(question)))
        assert isinstance(answer, EventsAnswer)
        return answer.events

    def close(self) -> None:
        """Shut the threads down without waiting for answers."""
        self._orders.shutdown(wait=False, cancel_futures=True)
        self._questions.shutdown(wait=False, cancel_futures=True)

    async def _ask(self, query: str, request: str) -> str:
        return await asyncio.get_running_loop().run_in_executor(
            self._questions, self._bus.ask, query, request
        )

    def _publish(self, order: Order) -> str:
        try:
            self._bus.publish(self._topics.order, order)
        except HouseflyError as error:
            _LOG.exception("the order to %s was lost", order.kind.value)
            return str(error)
        return ""
