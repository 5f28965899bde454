"""Exports of a lens and its light in formats of other programs."""
