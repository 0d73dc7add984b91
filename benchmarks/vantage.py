"""How long a viewpoint takes in B-sen at 10 cm, beside one plan of the planner in the same run."""

from __future__ import annotations

import time
from collections.abc import Callable
from functools import partial

from _run import percentile, table
from housefly.errors import TaskError
from housefly.room.tracked import solids_of
from housefly.sites.loaded_site import load_site
from housefly.tasks.vantage.patrol import floor_share, patrol_viewpoints
from housefly.tasks.vantage.search_places import belief_of
from housefly.tasks.vantage.subject import (
    Subject,
    furniture_subject,
    person_subject,
    pieces_of,
    place_subject,
)
from housefly.tasks.vantage.thing_search import ThingSearch
from housefly.tasks.vantage.viewing_room import ViewingRoom
from housefly.tasks.vantage.viewpoints import find_viewpoint

REPEATS = 7
GOAL_MS = 50.0


def milliseconds(work: Callable[[], object]) -> float:
    """Return the processor time of the quickest of some runs [ms]."""
    best = float("inf")
    for _ in range(REPEATS):
        begin = time.process_time()
        work()
        best = min(best, time.process_time() - begin)
    return 1e3 * best


def main() -> None:
    """Print what each kind of subject takes."""
    loaded = load_site("bsen")
    viewing, room = ViewingRoom(loaded.site, loaded.room, loaded.grid), loaded.room
    things = sorted({solid.thing for solid in room.solids if solid.collides})
    kinds: dict[str, list[Subject]] = {
        "places": [place_subject(place.name, place.look_at) for place in room.places],
        "people": [
            person_subject("p", (x, y, 0.0), room)
            for x, y in ((0.85, 4.2), (7.2, 4.5), (9.4, 3.8), (13.4, 2.2))
        ],
        "furniture": [
            furniture_subject(name, piece, room)
            for name in things
            for piece in pieces_of(solids_of(room, name))
        ],
    }
    find_viewpoint(viewing, kinds["places"][0])
    plan = milliseconds(lambda: loaded.plan("entrance"))
    rows: list[list[object]] = []
    for name, subjects in kinds.items():
        took = [milliseconds(partial(found, viewing, one)) for one in subjects]
        seen = sum(found(viewing, one) for one in subjects)
        rows.append([name, f"{seen} of {len(subjects)}", *timed(took, plan)])
    views = patrol_viewpoints(viewing)
    round_ms = milliseconds(lambda: patrol_viewpoints(viewing))
    share = 100.0 * floor_share(views, viewing)
    seen_words = f"{len(views)} views, {share:.0f} % of the floor"
    rows.append(["a whole patrol", seen_words, *timed([round_ms], plan)])
    whole = patrol_viewpoints(viewing, whole=True)
    whole_ms = milliseconds(lambda: patrol_viewpoints(viewing, whole=True))
    seen_words = f"{len(whole)} views, {100.0 * floor_share(whole, viewing):.0f} % of the floor"
    rows.append(["a patrol of the whole floor", seen_words, *timed([whole_ms], plan)])
    looks = ThingSearch(viewing, belief_of(None, viewing)).looks()
    search_ms = milliseconds(lambda: ThingSearch(viewing, belief_of(None, viewing)).looks())
    rows.append(["a search anywhere", f"{len(looks)} looks", *timed([search_ms], plan)])
    print("### Viewpoints\n")
    print(table(["of", "found", "median [ms]", "longest [ms]", "longest, in plans"], rows))
    print(
        f"\nB-sen at 10 cm, {len(room.solids)} solids, quickest of {REPEATS}; one plan to the"
        f" entrance takes {plan:.2f} ms. Goal: under {GOAL_MS:.0f} ms a subject."
    )


def found(viewing: ViewingRoom, subject: Subject) -> bool:
    """Return whether there is a viewpoint."""
    try:
        find_viewpoint(viewing, subject)
    except TaskError:
        return False
    return True


def timed(took: list[float], plan: float) -> tuple[str, str, str]:
    """Return the cells of some times [ms]."""
    longest = max(took)
    return f"{percentile(took, 0.5):.1f}", f"{longest:.1f}", f"{longest / plan:.1f}"


if __name__ == "__main__":
    main()
