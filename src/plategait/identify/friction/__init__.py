"""An object on a plate that is slowly tilted."""
