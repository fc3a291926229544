"""Scenes as MJCF, for MuJoCo 4: plate and drive, the sheet as a lattice of nodes or as a shell, and their contact."""
