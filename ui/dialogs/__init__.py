"""Start page with its jobs, sweep, manual and coach marks."""
