"""Parts of what the rules of the safety gate say: what is done about it, and the limit."""

from __future__ import annotations

from housefly.messages.words import Words, figure


def landing(why: Words) -> Words:
    """Say that the drone lands, and why."""
    return Words("{why}: landing", why=why)


def coming_home(why: Words) -> Words:
    """Say that the drone comes home, and why."""
    return Words("{why}: coming home", why=why)


def holding_itself(why: Words) -> Words:
    """Say that the drone's own hover holds it, and why."""
    return Words("{why}: the drone holds itself", why=why)


def held(why: Words) -> Words:
    """Say that the drone is held, and why."""
    return Words("{why}: held", why=why)


def slowly(why: Words) -> Words:
    """Say that the drone flies slowly, and why."""
    return Words("{why}: slowly", why=why)


def with_time_limit(why: Words, limit: float, form: str = "g") -> Words:
    """Say what is wrong, and its limit [s]."""
    return Words("{why} (limit {n} s)", why=why, n=figure(limit, form))


def with_length_limit(why: Words, limit: float, form: str = "") -> Words:
    """Say what is wrong, and its limit [m]."""
    return Words("{why} (limit {d} m)", why=why, d=figure(limit, form))


def with_speed_limit(why: Words, limit: float, form: str) -> Words:
    """Say what is wrong, and its limit [m/s]."""
    return Words("{why} (limit {d} m/s)", why=why, d=figure(limit, form))


def with_angle_limit(why: Words, limit: float) -> Words:
    """Say what is wrong, and its limit [deg]."""
    return Words("{why} (limit {n})", why=why, n=figure(limit, ".0f"))
