"""Light of sources that are no point: their blur on a receiver, and what it allows."""
