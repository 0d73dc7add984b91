"""Facts that older versions kept as sentences, as this version keeps them."""

from __future__ import annotations

from housefly.hub.situations.hysteresis import NOT_KNOWN, UNKNOWN
from housefly.messages import Facts


def renewed(facts: Facts) -> Facts:
    """Return facts with those that stood only in a sentence of 0.2.0.

    The sources of an event's evidence ("bed: load 58 kg; last seen beside bed"), that an end only
    says that its situation is unknown, and which key of a device was refused ("open is 'ajar'").
    """
    known = dict(facts)
    if "refused" in known and "refused_key" not in known:
        facts = (*facts, ("refused_key", str(known["refused"]).partition(" ")[0]))
    if "evidence" in known and "sources" not in known:
        facts = (*facts, ("sources", ",".join(_sources_in(str(known["evidence"])))))
    if known.get("because") == NOT_KNOWN and UNKNOWN not in facts:
        facts = (*facts, UNKNOWN)
    return facts


def _sources_in(evidence: str) -> tuple[str, ...]:
    heads = (part.partition(":") for part in evidence.split("; "))
    return tuple(dict.fromkeys(head for head, colon, _ in heads if colon and " " not in head))
