"""What a window is made of: its docks, its layout, the parts that are loaded late."""
