"""The constants of one drone from its own flight (paper V-C.1)."""
