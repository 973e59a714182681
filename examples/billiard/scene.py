# SPDX-License-Identifier: MIT
"""A ball on a hard cloth, which resists neither rolling nor spinning."""
from ball_on_cloth import ball_on_cloth


def hard(scene):
    return {"friction": scene.run_time_parameter("f", "1", 0.2), "restitution": scene.run_time_parameter("e", "1", 0)}


scene = ball_on_cloth("billiard", "Billiard ball that slides, then rolls", hard)

if __name__ == "__main__":
    scene.main()
