"""What `tools/plot` draws, one module for each kind of file."""
