"""Work in other threads, so that the window responds."""
