# Ten thousand poses of one mesh over another: distance against height.
import matplotlib.pyplot as plt
import numpy as np

import thigma

upper = thigma.build_clod(thigma.Mesh.from_file("upper.obj", scale=0.00024))
lower = thigma.build_clod(thigma.Mesh.from_file("lower.obj", scale=0.00024))
poses = np.tile((0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0), (10_000, 1))
poses[:, 2] = np.linspace(0.0, upper.radius + lower.radius, len(poses))
found = thigma.contacts(upper, lower, poses, tolerance=0.01 * upper.radius)
plt.plot(poses[:, 2], found.distance)
plt.xlabel("height [m]"), plt.ylabel("least distance [m]")
plt.savefig("distance.png")
print(f"{found}, {1e6 * found.cpu.mean():.1f} us a pose")
