"""A loop that is kept busy for longer than its period still hears everybody else."""

from __future__ import annotations

import asyncio
import time

from housefly.bus.rate import Rate


async def test_a_loop_that_is_always_late_lets_the_others_run_at_every_tick() -> None:
    rate, heard = Rate(1000.0), asyncio.Event()
    asyncio.get_running_loop().call_later(0.01, heard.set)
    for _ in range(30):
        time.sleep(0.002)
        await rate.sleep()
    assert heard.is_set()
