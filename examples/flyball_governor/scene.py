# SPDX-License-Identifier: MIT
"""Stiff flyball governor (IFToMM benchmark A05). The shaft turns freely about the vertical z0 by psi; a slider runs on it, its
centre s above the base. Two rods are hinged about the shaft's y at +-x from its top and hang outwards, beta_1 and beta_2 below
the horizontal, a ball at the end of each. A spring and a damper, both stiff, tie the middle of each rod to the slider."""
from torsor.scene import Inertia, Scene, axis, pi, quantity

scene = Scene("flyball_governor", "Stiff flyball governor (IFToMM benchmark A05)")

g = scene.parameter("g", "m/s^2", 9.81)
density = scene.parameter("density", "kg/m^3", 3000)
length = scene.parameter("length", "m", 1)  # of the shaft and of each rod
width = scene.parameter("width", "m", 0.01)  # of their square sections
edge = scene.parameter("edge", "m", 0.1)  # of the slider, a cube
m_ball = scene.parameter("m_ball", "kg", 5)
k = scene.parameter("k", "N/m", 800000)
c = scene.parameter("c", "N s/m", 40000)
rest = scene.parameter("rest", "m", 0.5)
m_rod = density * length * width * width  # and of the shaft
m_slider = density * edge**3

psi = scene.coordinate("psi", "rad")
s = scene.coordinate("s", "m")
beta_1 = scene.coordinate("beta_1", "rad")
beta_2 = scene.coordinate("beta_2", "rad")
scene.initial(psi, 0, 2 * pi * quantity("1", "rad/s"))
scene.initial(s, length / 2)
scene.initial(beta_1, pi / 6)
scene.initial(beta_2, pi / 6)

shaft = scene.revolute("shaft", scene.ground, axis.z, psi)
slider = scene.prismatic("slider", shaft, axis.z, s)
scene.body("shaft", shaft, Inertia.box(m_rod, width, width, length).at((0, 0, length / 2)))
scene.body("slider", slider, Inertia.box(m_slider, edge, edge, edge))
def arm(number, side, hinge, beta):
    """Rod 1 points along +x of its frame, rod 2 along -x: a positive angle lowers the end of either."""
    rod = scene.revolute(f"rod_{number}", shaft, hinge, beta, origin=(side * edge / 2, 0, length))
    scene.body(f"rod_{number}", rod, Inertia.box(m_rod, length, width, width).at((side * length / 2, 0, 0)))
    scene.body(f"ball_{number}", rod, Inertia.point(m_ball).at((side * length, 0, 0)))
    middle = scene.point(f"middle_{number}", rod, (side * length / 2, 0, 0))
    ear = scene.point(f"ear_{number}", slider, (side * edge / 2, 0, 0))
    scene.spring(f"spring_{number}", a=middle, b=ear, stiffness=k, rest=rest)
    scene.damper(f"damper_{number}", middle, ear, c)


arm(1, 1, axis.y, beta_1)
arm(2, -1, (0, -1, 0), beta_2)
scene.gravity((0, 0, -g))

if __name__ == "__main__":
    scene.main()
