"""Drawings of a part: on a page, as DXF, and of its measurement."""
