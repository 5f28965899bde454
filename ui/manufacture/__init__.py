"""What a shop asks of the lens on show: figures, limits and maps."""
