"""Judges a finished lens by means of its own."""
