"""Byte layouts of other people's protocols: pure encode and decode, for drivers and the twin."""
