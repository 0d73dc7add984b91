"""``housefly preflight --frames``: a person carries the drone, and is told what is seen of it."""
