"""Flies chunks on a Dask cluster: workers may come, go and die; the numbers stay the same."""

from __future__ import annotations

from collections.abc import Iterator
from importlib import metadata

from housefly.campaigns.plan import Chunk, Plan
from housefly.campaigns.runner import Landed
from housefly.errors import ConfigError, LinkError, MissingPartError
from housefly.experiments.engine import fly_many
from housefly.experiments.outcomes import Outcomes

try:
    from distributed import Client, as_completed
except ImportError as error:
    raise MissingPartError("distributed (campaigns on a cluster)", "pip install 'housefly[cluster]'") from error

PATIENCE = 10.0
"""How long the scheduler may take to answer, and the first worker to come [s]."""
PACKAGES = ("housefly", "numba", "numpy")
"""What must be the same everywhere, or the numbers would not be."""
RETRIES = 5
"""How often a chunk whose worker died is given to another one."""


class ClusterFleet:
    """The workers of one scheduler; use it as a context manager."""

    def __init__(self, address: str) -> None:
        """Connect.

        Raises:
            LinkError: nobody answers there, or no worker comes.
            ConfigError: a worker has another version.
        """
        try:
            self._client = Client(address, timeout=PATIENCE, set_as_default=False)  # type: ignore[no-untyped-call]
        except (OSError, TimeoutError, ValueError) as error:
            raise LinkError(f"no scheduler answers at {address}: start one with: dask scheduler") from error
        try:
            self._client.wait_for_workers(1, timeout=PATIENCE)
        except TimeoutError as error:
            self.close()
            raise LinkError(f"no worker at {address} after {PATIENCE:.0f} s: start one with: dask worker {address}") from error
        self._check_versions()

    def __enter__(self) -> ClusterFleet:
        return self

    def __exit__(self, *reason: object) -> None:
        self.close()

    def close(self) -> None:
        """Leave the cluster."""
        self._client.close()  # type: ignore[no-untyped-call]

    def fly(self, plan: Plan, chunks: tuple[Chunk, ...], on_landed: Landed) -> Iterator[tuple[Chunk, Outcomes]]:
        """Hand out all chunks and yield each as it lands."""
        futures = {self._client.submit(fly_chunk, plan, chunk, pure=False, retries=RETRIES): chunk for chunk in chunks}
        for future in as_completed(list(futures)):  # type: ignore[no-untyped-call]
            outcomes = future.result()
            chunk = futures.pop(future)
            future.release()
            on_landed(chunk.stop - chunk.start)
            yield chunk, outcomes

    def _check_versions(self) -> None:
        ours = versions()
        for worker, theirs in self._client.run(versions).items():
            for package, version in ours.items():
                if theirs.get(package) != version:
                    self.close()
                    raise ConfigError("--cluster", f"{worker} has {package} {theirs.get(package)}, this machine {version}")


def versions() -> dict[str, str]:
    """Return the versions of what the numbers depend on."""
    return {package: metadata.version(package) for package in PACKAGES}


def fly_chunk(plan: Plan, chunk: Chunk) -> Outcomes:
    """Fly one chunk on one thread of a worker."""
    cases, _ = plan.cases_of(chunk)
    return fly_many(cases, plan.legs[chunk.leg].mission, threads=1)
