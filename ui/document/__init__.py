"""The open design, its undo steps, and the verified errors of its lenses."""
