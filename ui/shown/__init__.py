"""Frames of a run or a preview, and their history."""
