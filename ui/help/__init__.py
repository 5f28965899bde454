"""What helps to find one's way: tour, manual, table of keys, about."""
