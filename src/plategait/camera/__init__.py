"""What film-makers and trackers share: the pinhole, the printed fiducials, the film file."""
