"""Engines: each takes prepared runs and gives recordings of them."""
