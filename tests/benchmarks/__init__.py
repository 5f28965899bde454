"""Programs that developers run to see what a change does to designs."""
