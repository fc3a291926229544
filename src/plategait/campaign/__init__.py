"""Campaigns: many points, one labelled store, killed at any moment and resumed to the same bits."""
