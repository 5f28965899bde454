"""The design in files: opened, saved, recovered, exported."""
