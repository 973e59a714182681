# SPDX-License-Identifier: MIT
"""Half an aircraft in symmetric flight (Pommier, §1, example 1): the fuselage heaves by z; the wing is four rigid panels in a
row along y, joined to it and to one another by elastic hinges about x, beta_1 to beta_4 from panel to panel; the engine hangs
by an elastic hinge, too, under the end of the first panel, turned by gamma from it. Everything is counted from steady flight:
weight and the lift that bears it are left out, and a gust adds a force at the middle of each panel."""
from torsor.scene import Inertia, Scene, axis, quantity

scene = Scene("elastic_wing", "Half an aircraft with an elastic wing and an engine")

m_fuselage = scene.parameter("m_fuselage", "kg", 15700)
m_engine = scene.parameter("m_engine", "kg", 2000)
length = scene.parameter("length", "m", 4)  # of a panel
hang = scene.parameter("hang", "m", 1.2)  # of the engine below its hinge
J_engine = scene.parameter("J_engine", "kg m^2", 700)
k_engine = scene.parameter("k_engine", "N m", 600000)
delay = scene.parameter("delay", "s", quantity("0.002", "s"))  # c = delay k
gust = scene.run_time_parameter("gust", "N", 10000)  # more lift of each panel
mass, stiffness = [], []
for i, (kg, hinge) in enumerate([(1300, 30000000), (800, 14000000), (450, 6000000), (250, 2500000)], 1):
    mass.append(scene.parameter(f"m_{i}", "kg", kg))
    stiffness.append(scene.parameter(f"k_{i}", "N m", hinge))

z = scene.coordinate("z", "m")
beta = [scene.coordinate(f"beta_{i + 1}", "rad") for i in range(4)]
gamma = scene.coordinate("gamma", "rad")

fuselage = scene.prismatic("fuselage", scene.ground, axis.z, z)
scene.body("fuselage", fuselage, Inertia.point(m_fuselage))
wing = []
for i in range(4):
    before, end = (wing[-1], length) if wing else (fuselage, 0)
    panel = scene.revolute(f"panel_{i + 1}", before, axis.x, beta[i], origin=(0, end, 0))
    # A thin panel in a plane motion: a rod along y.
    scene.body(f"panel_{i + 1}", panel, Inertia.rod(mass[i], length, 1).at((0, length / 2, 0)))
    middle = scene.point(f"middle_{i + 1}", panel, (0, length / 2, 0))
    scene.force(f"gust_{i + 1}", body=panel, point=middle, components=(0, 0, gust), axes=scene.ground)
    scene.spring(f"hinge_{i + 1}", beta[i], stiffness[i])
    scene.damper(f"friction_{i + 1}", beta[i], delay * stiffness[i])
    wing.append(panel)
scene.point("tip", wing[-1], (0, length, 0))
engine = scene.revolute("engine", wing[0], axis.x, gamma, origin=(0, length, 0))
scene.body("engine", engine, Inertia.general(m_engine, J_engine, 0, 0).at((0, 0, -hang)))
scene.spring("pylon", gamma, k_engine)
scene.damper("pylon_friction", gamma, delay * k_engine)

if __name__ == "__main__":
    scene.main()
