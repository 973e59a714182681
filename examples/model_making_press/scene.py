# SPDX-License-Identifier: MIT
"""Model-making press (Pommier, §3.5.5), with every joint: a traverse slides on two columns; a screw in the summit, which is
fixed to the frame, moves it through a cup above and a cup below. z is the axis of the screw, O its end; A and B are on the
columns. The frame is the ground."""
from torsor.scene import Inertia, Rotation, Scene, axis, pi

scene = Scene("model_making_press", "Model-making press: two columns, a screw and two cups")

m10 = scene.parameter("m10", "kg", 0.8)
C10 = scene.parameter("C10", "kg m^2", 0.002)
m20 = scene.parameter("m20", "kg", 0.3)
C20 = scene.parameter("C20", "kg m^2", 0.0001)
m30 = scene.parameter("m30", "kg", 0.02)
C30 = scene.parameter("C30", "kg m^2", 0.00001)
g = scene.parameter("g", "m/s^2", 9.81)
p = scene.parameter("p", "m", 0.004 / (2 * pi))  # 4 mm a turn
K = scene.parameter("K", "N/m", 20000)  # of what is pressed
c = scene.parameter("c", "N m s/rad", 0.0005)  # of the thread
e = scene.parameter("e", "m", 0.1)  # of the columns
h = scene.parameter("h", "m", 0.15)  # of the summit

a_z = scene.coordinate("a_z", "m")
a = scene.coordinate("a", "rad")
column = scene.weld("column_A", scene.ground, origin=(-e, 0, 0))
ring = scene.cylindrical("ring_A", column, axis=axis.z, displacement=a_z, angle=a)
traverse = scene.weld("traverse", ring, origin=(e, 0, 0))

lower_cup = scene.spherical("lower_cup", traverse, scene.attitude("lower"))
upper_cup = scene.spherical("upper_cup", traverse, scene.attitude("upper"))

summit = scene.weld("summit", scene.ground, origin=(0, 0, h))
omega_z = scene.coordinate("omega_z", "rad")
screw = scene.helical("screw", summit, axis=axis.z, angle=omega_z, pitch=p, origin=(0, 0, -h))

scene.name_joint(ring, "L1")
scene.name_joint(lower_cup, "L4")
scene.name_joint(upper_cup, "L6")
scene.name_joint(screw, "L7")
scene.name_joint(summit, "L8")
# The axis of a cylindrical joint that closes a loop is x of both frames: here along the old z.
x_along_z = Rotation.about(1, -6)
column_B = scene.weld("column_B", scene.ground, origin=(e, 0, 0), rotation=x_along_z)
ring_B = scene.weld("ring_B", traverse, origin=(e, 0, 0), rotation=x_along_z)
scene.loop_joint("L2", type="cylindrical", a=column_B, b=ring_B)
scene.loop_joint("L3", type="planar", a=lower_cup, b=screw)
scene.loop_joint("L5", type="planar", a=upper_cup, b=screw)

scene.body("traverse", traverse, Inertia.general(m10, C10, C10, C10))
scene.body("screw", screw, Inertia.general(m20, C20, C20, C20))
scene.body("lower_cup", lower_cup, Inertia.general(m30, C30, C30, C30))
scene.body("upper_cup", upper_cup, Inertia.general(m30, C30, C30, C30))

scene.gravity((0, 0, -g))
scene.spring("pressed", a_z, K)
scene.damper("thread", omega_z, c)
scene.motor("C", omega_z)

if __name__ == "__main__":
    scene.main()
