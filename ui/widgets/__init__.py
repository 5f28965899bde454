"""Widgets and themes, independent of designs."""
