"""Pictures of curves, runs and modes."""
