"""Runs, live update, checks and kept runs."""
