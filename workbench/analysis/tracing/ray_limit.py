"""How many rays a check may have."""

MOST_RAYS = 10_000_000_000
"""About an hour on two cores; rays scatter less than the rounding of any exported lens by then."""
