"""A lens for each of several values of a field, in a table."""
