"""Shown data: frames of a run or a preview, and their history."""
