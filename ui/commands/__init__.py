"""What a person can tell the window to do."""
