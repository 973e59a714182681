# SPDX-License-Identifier: MIT
"""The third case of the spring (Pommier, §6.5.3): nothing holds the cylinder T, the support, any more. Its place H is OH =
lambda y, the mass P is at HP = l y, and the spring works between H and P. Seen from the mass alone it gives Q_lambda = Q_l = -k
(l - l0), hence dQ_lambda/dl = -k and dQ_l/dlambda = 0: no force function. Of both ends together Q_lambda = 0, and -k (l -
l0)²/2 is a force function with a potential energy. A spring between points has the length sqrt(l²): the equations hold on
either side of the support."""
from torsor.scene import Inertia, Scene, axis, quantity

scene = Scene("shaker_free_support", "Mass on a spring from a support that moves freely")

M = scene.parameter("M", "kg", 1)
m_T = scene.parameter("m_T", "kg", 3)  # of the cylinder T
k = scene.parameter("k", "N/m", 400)
l0 = scene.parameter("l0", "m", 0.2)
g = scene.parameter("g", "m/s^2", 9.81)

lambda_ = scene.coordinate("lambda", "m")
l = scene.coordinate("l", "m")
# Thrown upwards, the spring stretched by 2 cm.
scene.initial(lambda_, 0, quantity("5", "m/s"))
scene.initial(l, 0.22)

support = scene.prismatic("support", scene.ground, axis.y, lambda_)
mass = scene.prismatic("mass", support, axis.y, l)
scene.body("support", support, Inertia.point(m_T))
scene.body("mass", mass, Inertia.point(M))
H = scene.point("H", support, (0, 0, 0))
P = scene.point("P", mass, (0, 0, 0))
scene.gravity((0, -g, 0))
scene.spring("spring", a=H, b=P, stiffness=k, rest=l0)

if __name__ == "__main__":
    scene.main()
