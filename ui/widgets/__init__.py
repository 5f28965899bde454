"""Widgets and looks that know nothing of designs."""
