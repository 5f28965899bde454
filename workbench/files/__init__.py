"""Scene and session files: strict when read, whole or not at all when written."""
