"""Writes a scene with a wavy grid of triangles as one `mesh2` with normals: `wavy_mesh.py 708 > million.pov` has a million (38 MB)."""

import math
import sys

n = int(sys.argv[1]) if len(sys.argv) > 1 else 708
out = sys.stdout.write


def vector(*numbers):
    return "<" + ",".join(f"{x:.5f}" for x in numbers) + ">"


def height(x, z):
    return 0.25 * math.sin(9 * x) * math.cos(7 * z) + 0.02 * math.sin(60 * x + 40 * z)


def normal(x, z):
    slope = 1.2 * math.cos(60 * x + 40 * z)
    dx = 2.25 * math.cos(9 * x) * math.cos(7 * z) + slope
    dz = -1.75 * math.sin(9 * x) * math.sin(7 * z) + slope * 2 / 3
    return vector(-dx, 1, -dz)


points = [(2 * i / n - 1, 2 * j / n - 1) for i in range(n + 1) for j in range(n + 1)]
faces = [(i * (n + 1) + j, i * (n + 1) + j + n + 1, i * (n + 1) + j + n + 2, i * (n + 1) + j + 1) for i in range(n) for j in range(n)]
out("""#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.3, 1.6, -2.6> look_at 0 angle 50 }
light_source { <-5, 8, -4>, rgb 1 }
mesh2 {
""")
out(f"vertex_vectors {{ {len(points)},\n" + ",\n".join(vector(x, height(x, z), z) for x, z in points) + "\n}\n")
out(f"normal_vectors {{ {len(points)},\n" + ",\n".join(normal(x, z) for x, z in points) + "\n}\n")
out(f"face_indices {{ {2 * len(faces)},\n")
out(",\n".join(f"<{a},{b},{c}>,<{a},{c},{d}>" for a, b, c, d in faces))
out("\n}\npigment { rgb <0.8, 0.5, 0.3> } finish { specular 0.4 }\n}\n")
