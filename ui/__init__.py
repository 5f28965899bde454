"""The window. Only this package uses Qt; it contains no optics."""
