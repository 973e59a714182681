# SPDX-License-Identifier: MIT
"""All eight conditions of rolling without slipping, for any steering. The wheels may slide along their axes; the rank of the
conditions in the other seven rates says whether the vehicle can move while they do not."""
from vehicle import add_vehicle

from torsor.scene import Scene

scene = Scene("four_wheel_vehicle_all_wheels", "Four-wheel vehicle: the eight conditions of its four wheels")
vehicle = add_vehicle(scene, sliding=True)
for i in range(4):
    scene.rolling(f"wheel_{i + 1}", body=vehicle.wheel[i], on=scene.ground, contact=vehicle.P[i], tangents=vehicle.steered[i])

if __name__ == "__main__":
    scene.main()
