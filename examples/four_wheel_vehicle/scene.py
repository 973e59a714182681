# SPDX-License-Identifier: MIT
"""The vehicle in motion, its four wheels rolling. Where their axes meet, the eight conditions have rank six: two repeat the
others (those across wheels 3 and 4 are left out, which only holds for these angles: they are constants here), and the forces
across the wheels are not determined one by one. Motors turn the rear wheels; every wheel turns against a viscous torque."""
from vehicle import add_vehicle

from torsor.scene import Scene

scene = Scene("four_wheel_vehicle", "Four-wheel vehicle whose wheels roll without slipping")
vehicle = add_vehicle(scene, sliding=False)
c = scene.parameter("c", "N m s", 3)
for i in range(4):
    scene.rolling(f"wheel_{i + 1}", body=vehicle.wheel[i], on=scene.ground, contact=vehicle.P[i], tangents=vehicle.steered[i])
scene.motor("C3", vehicle.phi[2])
scene.motor("C4", vehicle.phi[3])
for i in range(4):
    scene.damper(f"bearing_{i + 1}", vehicle.phi[i], c)

if __name__ == "__main__":
    scene.main()
