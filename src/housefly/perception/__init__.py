"""From measured distances to people and things that no map shows: what differs from the room,
clustered, followed in time.
"""
