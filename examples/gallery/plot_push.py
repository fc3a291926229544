"""
A session: change the motion, push the sheet
============================================

A sheet that is kept where it is while the plate changes its mind, and gets a push on the way.
"""

import matplotlib.pyplot as plt
import numpy as np

import plategait as pg

cheese = pg.preset("cheese").scenario.replace(slip_limit="1 m")
session = pg.Session([cheese])
poses = []
for tick in range(90):
    motion = cheese.motion.replace(frequency="20 Hz") if tick < 45 else cheese.motion.replace(frequency="14 Hz")
    if tick == 70:
        session.push(0, (0.2, 0.0, 0.0))
    session.advance(motion, 1 / 60)
    poses.append(session.poses[0])
x, y, angle = np.array(poses).T

figure, (turn, place) = plt.subplots(1, 2, figsize=(8, 3.5), layout="constrained")
turn.plot(np.arange(1, 91) / 60, np.degrees(np.unwrap(angle)))
turn.axvline(0.75, color="grey", ls=":")
turn.set(xlabel="time (s)", ylabel="angle (deg)", title="20 Hz, then 14 Hz")
place.plot(1e3 * x, 1e3 * y)
place.set(xlabel="along the bar (mm)", ylabel="across it (mm)", title="the push goes along", aspect="equal")
