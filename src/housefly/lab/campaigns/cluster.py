"""Fly chunks on a Dask cluster. Workers may join or die at any time; the numbers stay the same."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Iterator
from concurrent.futures import CancelledError
from contextlib import contextmanager
from typing import Any

from housefly.errors import LinkError, MissingPartError
from housefly.lab.campaigns.plan import Chunk, Plan
from housefly.lab.campaigns.provenance import processor, versions
from housefly.lab.experiments.cases import Cases
from housefly.lab.experiments.engine import Progress, fly_many
from housefly.lab.experiments.flight_plan import FlightPlan
from housefly.lab.experiments.outcomes import Outcomes

try:
    from distributed import Client, KilledWorker, wait
    from distributed.core import rpc
except ImportError as error:
    raise MissingPartError(
        "distributed (campaigns on a cluster)", "pip install 'housefly[cluster]'"
    ) from error

SCHEDULER_TIMEOUT = 5.0
"""How long the scheduler may take to answer, and the first worker to appear [s]."""
_WORKER_TIMEOUT = 60.0
"""How long to wait for a cluster that has no worker left [s]."""
_POLL_INTERVAL = 2.0
"""How often to check that the cluster is still there while nothing lands [s]."""
_CHUNKS_PER_THREAD = 4
"""Chunks handed out for each thread of the cluster."""
_RESUME_HINT = "what has landed is kept, run the same again to go on"


class ClusterFleet:
    """The workers of one scheduler; use it as a context manager."""

    def __init__(self, address: str) -> None:
        """Connect.

        Raises:
            LinkError: nobody answers there, no worker comes, or a worker has other versions than
                this machine.
        """
        self._address = address
        for logger in ("distributed", "distributed.client"):
            # Errors tell in one line what goes wrong.
            logging.getLogger(logger).setLevel(logging.CRITICAL)
        self._client = _connected(address)
        try:
            self._check_workers()
        except BaseException:
            self.close()
            raise

    def __enter__(self) -> ClusterFleet:
        return self

    def __exit__(self, *reason: object) -> None:
        self.close()

    def close(self) -> None:
        """Disconnect; chunks still handed out are cancelled."""
        self._client.close()  # type: ignore[no-untyped-call]

    def foreign_processors(self) -> set[str]:
        """Return the workers' kinds of processor that differ from this machine's.

        On such processors the last bits of the results may differ.
        """
        return set(self._client.run(processor).values()) - {processor()}

    def fly(
        self, plan: Plan, chunks: tuple[Chunk, ...], on_landed: Progress
    ) -> Iterator[tuple[Chunk, Outcomes]]:
        """Keep every thread of the cluster busy with chunks, and yield each chunk as it lands.

        Raises:
            LinkError: the scheduler is gone, no worker is left, or chunks kill every worker that
                takes them.
        """
        waiting = list(reversed(chunks))
        flying: dict[Any, Chunk] = {}
        while waiting or flying:
            with self._watching():
                self._hand_out(plan, waiting, flying)
                landed = [
                    (flying.pop(future), future.result()) for future in self._landed(list(flying))
                ]
            for chunk, outcomes in landed:
                on_landed(chunk.drones)
                yield chunk, outcomes

    def _hand_out(self, plan: Plan, waiting: list[Chunk], flying: dict[Any, Chunk]) -> None:
        most = _CHUNKS_PER_THREAD * max(self._threads(), 1)
        while waiting and len(flying) < most:
            chunk = waiting.pop()
            cases, _ = plan.cases_of(chunk)
            mission = plan.groups[chunk.group].mission
            future = self._client.submit(fly_chunk, cases, mission, versions(), pure=False)
            flying[future] = chunk

    def _landed(self, flying: list[Any]) -> list[Any]:
        """Return the futures that have finished, at least one."""
        alone = 0.0
        while alone <= _WORKER_TIMEOUT:
            try:
                with self._client.as_current():
                    first = wait(  # type: ignore[no-untyped-call]
                        flying, timeout=_POLL_INTERVAL, return_when="FIRST_COMPLETED"
                    )
                    return list(first.done)
            except TimeoutError:
                alone = 0.0 if self._threads() else alone + _POLL_INTERVAL
        raise LinkError(f"no worker at {self._address} for {_WORKER_TIMEOUT:.0f} s; {_RESUME_HINT}")

    @contextmanager
    def _watching(self) -> Iterator[None]:
        try:
            yield
        except KilledWorker as error:
            raise LinkError(
                f"the workers at {self._address} die of their work ({error}); {_RESUME_HINT}"
            ) from error
        # Which of the two depends on what the client was about to ask.
        except (CancelledError, OSError) as error:
            raise LinkError(f"the scheduler at {self._address} is gone; {_RESUME_HINT}") from error

    def _threads(self) -> int:
        if self._client.status != "running":
            raise ConnectionResetError(f"the client is {self._client.status}")
        return sum(self._client.nthreads().values())  # type: ignore[no-untyped-call]

    def _check_workers(self) -> None:
        try:
            self._client.wait_for_workers(1, timeout=SCHEDULER_TIMEOUT)
        except TimeoutError as error:
            raise LinkError(
                f"no worker at {self._address} after {SCHEDULER_TIMEOUT:.0f} s;"
                f" start one with: dask worker {self._address}"
            ) from error
        for worker, theirs in self._client.run(versions, on_error="return").items():
            if isinstance(theirs, Exception):
                raise LinkError(
                    f"the worker {worker} has no housefly {versions()['housefly']} ({theirs})"
                )
            _refuse_others(theirs, versions(), worker)


def _connected(address: str) -> Client:
    """Return a connected client.

    The scheduler is asked for its identity first: a client that cannot connect may block for ever
    and cannot be closed.
    """
    try:
        asyncio.run(_identity(address))
        return Client(address, timeout=SCHEDULER_TIMEOUT, set_as_default=False)  # type: ignore[no-untyped-call]
    except (OSError, ValueError) as error:
        raise LinkError(
            f"no scheduler answers at {address}; start one with: dask scheduler"
        ) from error


async def _identity(address: str) -> None:
    connection = rpc(address, timeout=SCHEDULER_TIMEOUT)  # type: ignore[no-untyped-call]
    async with asyncio.timeout(SCHEDULER_TIMEOUT), connection as scheduler:
        await scheduler.identity()


def fly_chunk(cases: Cases, mission: FlightPlan, wanted: dict[str, str]) -> Outcomes:
    """Fly one chunk on one thread of a worker.

    Raises LinkError when the worker's versions are not the wanted ones.
    """
    _refuse_others(versions(), wanted, "one that joined later")
    return fly_many(cases, mission, threads=1)


def _refuse_others(theirs: dict[str, str], ours: dict[str, str], worker: str) -> None:
    for name, version in ours.items():
        if theirs.get(name) != version:
            raise LinkError(
                f"the worker {worker} has {name} {theirs.get(name)}, this machine {version}: make"
                " them the same"
            )
