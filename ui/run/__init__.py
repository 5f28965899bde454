"""Runs in a thread of their own: steering them, showing them, keeping them."""
