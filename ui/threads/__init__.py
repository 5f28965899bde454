"""Work in threads of its own, so that the window answers."""
