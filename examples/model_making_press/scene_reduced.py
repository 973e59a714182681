# SPDX-License-Identifier: MIT
"""Model-making press (Pommier, §3.5.5) reduced to three bodies and three joints: the traverse slides along z, the screw turns
and advances in the frame, and the screw's end touches the traverse at a point."""
from torsor.scene import Inertia, Scene, axis, pi

scene = Scene("model_making_press_reduced", "Model-making press, reduced: one prismatic, one helical, one point contact")

m10 = scene.parameter("m10", "kg", 0.84)  # both cups included
m20 = scene.parameter("m20", "kg", 0.3)
C20 = scene.parameter("C20", "kg m^2", 0.0001)
g = scene.parameter("g", "m/s^2", 9.81)
p = scene.parameter("p", "m", 0.004 / (2 * pi))  # 4 mm a turn
K = scene.parameter("K", "N/m", 20000)  # of what is pressed
c = scene.parameter("c", "N m s/rad", 0.0005)  # of the thread

a_z = scene.coordinate("a_z", "m")
omega_z = scene.coordinate("omega_z", "rad")
traverse = scene.prismatic("traverse", scene.ground, axis.z, a_z)
screw = scene.helical("screw", scene.ground, axis=axis.z, angle=omega_z, pitch=p)
scene.name_joint(traverse, "LA")
scene.name_joint(screw, "LC")
scene.loop_joint("LB", type="point_contact", a=traverse, b=screw)
scene.body("traverse", traverse, Inertia.point(m10))
scene.body("screw", screw, Inertia.general(m20, C20, C20, C20))

scene.gravity((0, 0, -g))
scene.spring("pressed", a_z, K)
scene.damper("thread", omega_z, c)
scene.motor("C", omega_z)

if __name__ == "__main__":
    scene.main()
