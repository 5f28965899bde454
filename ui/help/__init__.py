"""Help: tour, manual, table of keys, about."""
