// The engine's worker.
