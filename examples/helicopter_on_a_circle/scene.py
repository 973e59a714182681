# SPDX-License-Identifier: MIT
"""Questions 1 to 3: the blades' pitch is constant, the rotor one rigid body."""
from helicopter import add_blade, add_helicopter

from torsor.scene import Scene

scene = Scene("helicopter_on_a_circle", "Rotor of a helicopter that goes round a circle")
helicopter = add_helicopter(scene)
for i in range(1, 5):
    add_blade(scene, helicopter, i, helicopter.alpha)

if __name__ == "__main__":
    scene.main()
