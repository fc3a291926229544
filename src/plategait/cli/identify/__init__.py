"""The commands that turn bench recordings into parameters."""
