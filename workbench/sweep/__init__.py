"""Many designs: scenes and fields that are varied, worked on side by side, in one table."""
