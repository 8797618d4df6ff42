# SPDX-License-Identifier: MIT
"""First steps: load a scene, tune it, step, look at numbers, a picture and a plot."""
import numpy as np

import pabd

sim = pabd.load("stack", set={"contact.d_hat": 0.01})
print(sim)

sim.params["contact.kappa"] = 5000  # J, from the next step on
report = sim.run(1.0)  # s
print(f"t = {sim.time:.3f} s: {report['status']}, {report['contacts']} contacts, "
      f"smallest gap {report['min_gap']:.2e} m, kinetic energy {report['kinetic']:.2e} J")

# Views: no copies, refreshed by every step.
movable = ~sim.fixed
print(f"highest body: {sim.positions[movable, 1].max():.3f} m")

# The weight of the stack, carried by the contacts of the ground.
contacts = sim.contacts
below = contacts[np.isin(contacts["a"], np.flatnonzero(sim.fixed)) | np.isin(contacts["b"], np.flatnonzero(sim.fixed))]
weight = 9.81 * sim.masses[movable].sum()
print(f"contacts of the ground carry {below['normal_force'].sum():.0f} N, the weight is {weight:.0f} N")

pabd.write_png("stack.png", sim.render(640, 360, overlay="contacts"), force=True)
sim.plot().save("stack.svg", force=True)
print("wrote stack.png, stack.svg; state", sim.hash)
