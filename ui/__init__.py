"""The window. Qt lives only here; no optics do."""
