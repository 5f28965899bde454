"""Dialogs of the window: start page, gallery, sweep, manual, tour."""
