"""Talk with a running house from asyncio: news are told while a task flies.

Needs: a house that runs: `housefly demo` in another terminal.
Learns: one client for any number of questions at once; news go on when the console is started
    again; a task that takes too long is stopped.
Prints: where the cup is, how many things there are, what happens meanwhile, and how the task ended.
"""

import asyncio

import housefly

PATIENCE = 180.0
"""How long the task may take [s]."""


async def tell_news(house: housefly.AsyncHouse) -> None:
    """Print what happens, until cancelled."""
    async for news in house.news():
        for event in news.events:
            print(f"news: {event.kind}: {event.thing}")


async def ended_in_time(house: housefly.AsyncHouse, task: int) -> str:
    """Return how a task ended; one that takes too long is stopped and ended."""
    try:
        async with asyncio.timeout(PATIENCE):
            return str((await house.ended(task)).words)
    except TimeoutError:
        await house.stop()
        await house.cancel(task)
        return "it took too long"


async def main() -> None:
    """Ask, listen, let it fly."""
    house = housefly.AsyncHouse()
    cup, things = await asyncio.gather(house.where("cup"), house.things())
    print("now:", cup.words)
    print(f"{len(things)} things, {len(await house.services())} services")
    listening = asyncio.create_task(tell_news(house))
    task = await house.request("visitor")
    print(f"task {task.id}: {task.title}")
    print("ended:", await ended_in_time(house, task.id))
    listening.cancel()


asyncio.run(main())
