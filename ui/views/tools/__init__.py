"""Tools of the 3D view: interaction of mouse and keyboard, one tool at a time."""
