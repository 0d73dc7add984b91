"""The page of ``housefly new``: a room and a site drawn in the browser."""
