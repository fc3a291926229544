"""A sheet or strip that rings."""
