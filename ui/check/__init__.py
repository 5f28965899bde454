"""Independent checks of lenses, asked for and during runs."""
