"""Faces that rays meet."""
