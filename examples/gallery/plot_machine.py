"""
What a motion asks of a machine
===============================

Reach, speed, acceleration and power of the plate's motion beside the limits of the source's machine, and the motion
itself, sample by sample, from rest to rest.
"""

import matplotlib.pyplot as plt
import numpy as np

import plategait as pg

motion = pg.preset("cheese").scenario.motion.replace(frequency="20 Hz")
print(pg.needs(motion, pg.machine_of("source-robot")))

# %%
# As a drive gets it.

made = pg.trajectory(motion, "1 kHz", "source-robot", duration="0.5 s")
figure, (slide, rock) = plt.subplots(2, figsize=(6, 4), sharex=True, layout="constrained")
slide.plot(made.time, 1e3 * made.position[0])
slide.set_ylabel("along the bar (mm)")
rock.plot(made.time, np.degrees(made.position[3]))
rock.set(xlabel="time (s)", ylabel="about the bar (deg)")
