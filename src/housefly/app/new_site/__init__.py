"""``housefly new``: asks what a site is, tries its wires, and writes its files."""
