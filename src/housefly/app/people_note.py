"""What is said before a take-off where nobody is seen: by `housefly fly`, at the start of a run,
and with every report of the pilot's links.
"""

from __future__ import annotations

from housefly.config.site import Site

UNSEEN_PEOPLE = "nothing here sees people: no scanner, no depth camera"
"""What everybody should know before the drone takes off."""


def people_note(site: Site) -> str:
    """Return that nobody is seen in a site, in words, or ""."""
    return "" if site.sees_people else UNSEEN_PEOPLE
