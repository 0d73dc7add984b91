"""Which drones a campaign flies: every point once a seed, whatever the chunks."""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.config.site import Site, changed
from housefly.errors import ConfigError
from housefly.lab.campaigns.draws import Draw, shares_of
from housefly.lab.campaigns.notes import notes
from housefly.lab.campaigns.plan import MAX_CHUNK, MIN_CHUNK, Plan, chunk_size, plan_campaign
from housefly.lab.campaigns.provenance import describe_plan
from housefly.lab.campaigns.spec import spec_from_tree
from housefly.lab.experiments.cases import BY_NAME, DEFAULT, PAPER, PARAMETERS, cases

WAY = {"waypoints": [[0.0, 0.0], [1.0, 0.0]]}


def planned(chunk: int | None = None, **keys: Any) -> Plan:
    return plan_campaign(spec_from_tree({"name": "a", "mission": WAY} | keys), Site(), chunk)


def flown(plan: Plan) -> Any:
    return np.concatenate([plan.cases_of(chunk)[0] for chunk in plan.chunks])


@settings(max_examples=30, deadline=None)
@given(
    seeds=st.integers(1, 40),
    first=st.integers(0, 1000),
    rates=st.lists(st.sampled_from([10, 20, 30, 50, 100]), min_size=1, max_size=4, unique=True),
    modes=st.lists(st.sampled_from(["default", "paper"]), min_size=1, max_size=2, unique=True),
    chunk=st.integers(1, 50),
)
def test_every_point_is_flown_once_a_seed_whatever_the_chunks(
    seeds: int, first: int, rates: list[int], modes: list[str], chunk: int
) -> None:
    plan = planned(
        chunk,
        seeds=seeds,
        first_seed=first,
        grid={"mocap_rate_hz": rates, "mode": modes},
        draw={"lag": {"normal": [7, 1]}},
    )
    assert max(part.drones for part in plan.chunks) <= chunk
    table = flown(plan)
    found = sorted(
        zip(
            table["mocap_rate_hz"].tolist(),
            table["mode"].tolist(),
            table["seed"].tolist(),
            strict=True,
        )
    )
    numbers = {"default": DEFAULT, "paper": PAPER}
    wanted = sorted(
        (float(r), numbers[m], first + s) for r, m, s in product(rates, modes, range(seeds))
    )
    assert found == wanted
    assert plan.drones == len(wanted)


@settings(max_examples=20, deadline=None)
@given(seeds=st.integers(1, 60), chunks=st.tuples(st.integers(1, 70), st.integers(1, 70)))
def test_how_it_is_cut_changes_no_drone(seeds: int, chunks: tuple[int, int]) -> None:
    keys: dict[str, Any] = {
        "seeds": seeds,
        "grid": {"mode": ["paper", "default"], "alpha": [2.0, 4.0]},
        "draw": {
            "lag": {"normal": [7, 1]},
            "drag": {"uniform": [0, 1]},
            "estimator": {"choice": ["on_arrival", "held_sample"]},
        },
    }
    one, other = (flown(planned(chunk, **keys)) for chunk in chunks)
    assert one.tobytes() == other.tobytes()


def test_chunks_grow_with_the_campaign_and_not_with_the_machine() -> None:
    assert chunk_size(1) == chunk_size(50_000) == MIN_CHUNK
    assert chunk_size(200_000) == 1000
    assert chunk_size(50_000_000) == MAX_CHUNK


def test_a_seed_draws_the_same_in_every_point_and_with_any_number_of_seeds() -> None:
    few = planned(
        seeds=5, first_seed=3, grid={"mocap_rate_hz": [10, 100]}, draw={"lag": {"uniform": [5, 9]}}
    )
    many = planned(seeds=50, draw={"lag": {"uniform": [5, 9]}})
    (chunk,), (all_,) = few.chunks, many.chunks
    lags = few.cases_of(chunk)[0]["lag"].reshape(2, 5)
    assert (lags[0] == lags[1]).all()
    assert (lags[0] == many.cases_of(all_)[0]["lag"][3:8]).all()


@given(
    st.sampled_from(
        [p for p in PARAMETERS if p.low > 0 and np.isfinite(p.high) and p.low < p.high]
    ),
    st.sampled_from(["uniform", "loguniform", "normal"]),
)
def test_draws_stay_inside_the_range_of_their_column(parameter: Any, kind: str) -> None:
    numbers = (
        (parameter.low, 10 * parameter.high)
        if kind == "normal"
        else (parameter.low, parameter.high)
    )
    drawn = Draw.model_validate({kind: numbers}).at(shares_of(parameter.name, 0, 2000), parameter)
    assert drawn.min() >= parameter.low
    assert drawn.max() <= parameter.high
    assert len(np.unique(drawn)) > 1900


def test_a_normal_draw_has_its_mean_and_sigma() -> None:
    drawn = Draw(normal=(7.0, 0.5)).at(shares_of("lag", 0, 20_000), BY_NAME["lag"])
    assert drawn.mean() == pytest.approx(7.0, abs=0.02)
    assert drawn.std() == pytest.approx(0.5, abs=0.02)


def test_each_mode_flies_its_own_way_with_its_own_tolerances() -> None:
    spec = spec_from_tree(
        {
            "name": "a",
            "mission": {"goal": "entrance"},
            "seeds": 2,
            "grid": {"mode": ["paper", "default"]},
        }
    )
    plan = plan_campaign(spec, Site())
    default, paper = plan.groups
    corners = plan_campaign(spec, changed(Site(), map__planner="grid")).groups[0].mission
    assert len(paper.mission.waypoints) > 2 * len(corners.waypoints)
    assert paper.mission.trajectory is None and corners.trajectory is None
    trajectory = default.mission.trajectory
    assert trajectory is not None and trajectory.motion[-1, :2] == pytest.approx(
        corners.waypoints[-1], abs=0.05
    )
    assert default.cells == (1,) and paper.cells == (0,)
    table, cells = plan.cases_of(plan.chunks[1])
    assert (table == cases(plan.groups[1].site, 2, mode=PAPER, seed=[0, 1])).all()
    assert (cells == 0).all()


def to_the_entrance(**keys: Any) -> Plan:
    """Two speeds through B-sen in space; mode paper has one way for both."""
    tree = {"name": "a", "mission": {"goal": "entrance", "duration_s": 12.0}, "seeds": 2} | keys
    return plan_campaign(spec_from_tree(tree), Site())


def test_in_space_a_trajectory_is_planned_for_each_speed() -> None:
    grid = {"speed": [0.5, 1.0], "mode": ["default", "paper"], "mocap_rate_hz": [10, 100]}
    plan = to_the_entrance(grid=grid)
    assert [group.name for group in plan.groups] == [
        "default, speed 0.5",
        "default, speed 1",
        "paper",
    ]
    assert [group.cells for group in plan.groups] == [(0, 1), (4, 5), (2, 3, 6, 7)]
    slow, fast = (group.mission.trajectory for group in plan.groups[:2])
    assert slow is not None and fast is not None
    for trajectory, speed in ((slow, 0.5), (fast, 1.0)):
        assert np.hypot(*trajectory.motion[:, 3:5].T).max() == pytest.approx(speed, abs=0.01)
    assert all((plan.cases_of(chunk)[0]["speed"] > 0.0).all() for chunk in plan.chunks)
    digests = describe_plan(plan)["trajectory"]
    assert len(set(digests.values())) == 2 and "paper" not in digests
    (note,) = notes(plan)
    assert "in mode default, speed 0.5 take at least" in note
    with pytest.raises(ConfigError, match=r"draw\.speed"):
        to_the_entrance(draw={"speed": {"uniform": [0.4, 0.6]}})


def test_a_flight_that_cannot_end_in_time_is_noted() -> None:
    far = {"mission": {"waypoints": [[0.0, 0.0], [10.0, 0.0]], "duration_s": 21.9}}
    assert notes(planned(**far)) == [
        "mission.duration_s is 21.9 s, but the 10.0 m in mode default take at least 22 s: no drone"
        " will arrive"
    ]
    assert notes(planned(**far | {"fixed": {"speed": 1.0}})) == []
    for change in ({"duration_s": 22.1}, {"task": "step"}):
        assert notes(planned(mission=far["mission"] | change)) == []


def test_a_place_that_is_not_there_is_refused_by_name() -> None:
    spec = spec_from_tree({"name": "a", "mission": {"goal": "moon"}})
    with pytest.raises(ConfigError, match="moon"):
        plan_campaign(spec, Site())
