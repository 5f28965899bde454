"""Docks, layout and state of a window; messages about edits and runs."""
