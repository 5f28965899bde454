"""What helps to find one's way: tour, table of keys, about."""
