from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats

from housefly.lab.experiments.random import EDGES, LAYERS, exponential, mixed, normal, sown, uniform

MASK = 2**64 - 1


def splitmix(seed: int, count: int) -> list[int]:
    """The published algorithm with Python's own integers."""

    def mix(z: int) -> int:
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9 & MASK
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB & MASK
        return z ^ (z >> 31)

    state = mix((seed * 0x9E3779B97F4A7C15 + 0xBF58476D1CE4E5B9) & MASK)
    return [mix((state + (n + 1) * 0x9E3779B97F4A7C15) & MASK) for n in range(count)]


def drawn(draw: object, seed: int, count: int, *arguments: float) -> np.ndarray:
    state = np.zeros(1, np.uint64)
    sown(state, seed)
    return np.array([draw(state, *arguments) for _ in range(count)])  # type: ignore[operator]


@given(st.integers(0, 2**62))
def test_the_bits_are_those_of_splitmix64(seed: int) -> None:
    expected = [((bits >> 11) + 0.5) / 2**53 for bits in splitmix(seed, 5)]
    assert drawn(uniform, seed, 5).tolist() == expected


def test_mixing_matches_the_published_value() -> None:
    assert int(mixed(np.uint64(0x9E3779B97F4A7C15))) == 0xE220A8397B1DCDAF


def test_the_layers_of_the_bell_are_equal() -> None:
    heights = np.exp(-0.5 * EDGES**2)
    areas = EDGES[1:-1] * np.diff(heights[1:])
    assert areas == pytest.approx(np.full(LAYERS - 1, areas[0]), rel=1e-6)


@pytest.mark.parametrize(
    ("draw", "law", "arguments"),
    [
        (uniform, stats.uniform(), ()),
        (normal, stats.norm(), ()),
        (exponential, stats.expon(scale=0.3), (0.3,)),
    ],
)
def test_numbers_follow_their_distribution(
    draw: object, law: object, arguments: tuple[float, ...]
) -> None:
    numbers = drawn(draw, 5, 40_000, *arguments)
    assert stats.kstest(numbers, law.cdf).pvalue > 1e-3  # type: ignore[attr-defined]
    assert abs(np.corrcoef(numbers[:-1], numbers[1:])[0, 1]) < 0.02


def test_the_tail_of_the_bell_is_as_heavy_as_it_should_be() -> None:
    numbers = np.abs(drawn(normal, 11, 400_000))
    for sigmas in (3.0, 3.45, 4.0):
        expected = 400_000 * 2.0 * stats.norm.sf(sigmas)
        assert abs((numbers > sigmas).sum() - expected) < 5.0 * np.sqrt(expected)


def test_neighbouring_seeds_have_nothing_in_common() -> None:
    one, two = drawn(normal, 1, 5000), drawn(normal, 2, 5000)
    assert abs(np.corrcoef(one, two)[0, 1]) < 0.05
