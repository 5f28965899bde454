"""Inspection of a made part: alignment of its measurement, residual, light and correction."""
