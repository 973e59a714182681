# SPDX-License-Identifier: MIT
"""Question 4: the rotor as a system of bodies. Each blade turns about its span by a pitch of its own, alpha_1 to alpha_4, which
a link (spring and damper) holds near what the pilot commands, alpha + alpha_c cos(phi + (i - 1) pi/2): once a turn the blades
swing."""
from helicopter import add_blade, add_helicopter

from torsor.scene import Scene, cos, pi, quantity, sin

scene = Scene("helicopter_on_a_circle_pitching_blades", "The helicopter's rotor with blades of variable pitch")
helicopter = add_helicopter(scene)
alpha_c = scene.run_time_parameter("alpha_c", "rad", 0.1)
k = scene.run_time_parameter("k", "N m", 4000)
c = scene.run_time_parameter("c", "N m s", 8)
rate = quantity("30", "rad/s")
for i in range(1, 5):
    pitch = scene.coordinate(f"alpha_{i}", "rad")
    place = (i - 1) * pi / 2
    scene.initial(pitch, helicopter.alpha + alpha_c * cos(place), -alpha_c * sin(place) * rate)
    add_blade(scene, helicopter, i, pitch)
    swing = pitch - alpha_c * cos(helicopter.phi + place)
    scene.spring(f"link_{i}", swing, k, helicopter.alpha)
    scene.damper(f"link_damping_{i}", swing, c)

if __name__ == "__main__":
    scene.main()
