"""Wiring: processes, launcher, lock step, doctor. The only folder that knows everybody."""
