"""Dialogs of the window: help, start page, sweep."""
