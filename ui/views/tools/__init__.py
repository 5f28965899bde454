"""What the mouse does in the 3D scene: one tool at a time."""
