"""What is said before a take-off where nobody is seen: by `housefly fly`, at the start of a run,
and in the air with every report of the pilot's links; on the ground a check says it.
"""

from __future__ import annotations

from housefly.config.site import Site
from housefly.messages.words import UNSAID, Words

UNSEEN_PEOPLE = Words("nothing here sees people: no scanner, no depth camera")
"""What everybody should know before the drone takes off."""


def people_note(site: Site) -> Words:
    """Return that nobody is seen in a site, in words, or UNSAID."""
    return UNSAID if site.sees_people else UNSEEN_PEOPLE
