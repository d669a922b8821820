"""Random scenes of everything that durer draws, for `../shared/random/random_scenes.py --generator tests/random/scenes.py`.

A family is a word of FAMILIES; a scene has some of them. Add one with each new feature: a shape, a camera, a light is done when it
holds in random company.
"""

import re
from math import cos, pi, sin

from random_scenes import FAMILIES as GIVEN
from random_scenes import Scene

FAMILIES = GIVEN + [
    "pictures", "uv", "blends", "angles", "insides", "materials", "prisms", "defaults", "declared", "loops", "cameras", "settings",
    "lights", "colors", "sizes", "quality", "curved", "meshes", "letters", "blobs", "eyes", "lamps", "air",
]

# How many entries the list of a pattern takes.
CELLS = {"checker": 2, "brick": 2, "hexagon": 3, "triangular": 6, "square": 4, "cubic": 6}

# A quick colour with its colour.
QUICK = r" quick_color s?rgb (<[^>]*>|[\d.]+)"


class Scenes(Scene):
    """The given scenes, and more to choose from."""

    # Is the scene's language older than 3.5, where media are random unless they say otherwise?
    old_language = False

    def joined(self, count, text):
        return " ".join(text() for _ in range(count))

    def color(self, clear=0.0):
        if self.has("colors") and self.chance(0.2):
            return self.pick(
                f"red {self.f(0, 1)} green {self.f(0, 1)}",
                f"rgb <{self.f(-0.5, 1)}, {self.f(-0.5, 1)}, {self.f(0, 1)}>",
                f"rgb <{self.f(0, 1)}, {self.f(0, 1)}, {self.f(1, 3)}>",
                f"color rgb {self.v(0, 1)}*{self.f(0.2, 1.2)}",
                f"srgb {self.v(0, 1)} filter {self.f(0, 0.8) if clear else 0}",
                f"color blue {self.f(0.2, 1)} transmit {self.f(0, 0.9) if clear else 0}",
            )
        return super().color(clear)

    # Patterns

    def pattern(self):
        if self.has("angles") and self.chance(0.25):
            place = f"{{ {self.v(-1, 1)} altitude {self.v(-1, 1)} }}"
            return self.pick("aoi", f"slope {self.v(-1, 1)}", f"slope {place}"), self.waves()
        if self.has("pictures") and self.chance(0.25):
            return f"image_pattern {{ {self.picture()} {self.mapping()} }}", self.waves()
        if self.chance(0.15):
            more = self.pick(
                f"function {{ x*{self.f(-2, 2)} + sin(y*{self.f(1, 5)}) - z*z }}",
                # (Within functions POV-Ray obeys quick colours, durer does not.)
                f"pigment_pattern {{ {re.sub(QUICK, '', self.pigment(2))} }}",
                f"crackle form {self.v(-1, 1)} metric {self.f(1, 3)}",
                f"agate agate_turb {self.f(0, 1.5)}",
                f"quilted control0 {self.f(0, 1)} control1 {self.f(0, 1)}",
                f"magnet {self.pick(1, 2)} mandel 12",
                f"mandel 20 exponent 3 interior {self.r.randrange(0, 7)}, 1 exterior {self.r.randrange(0, 7)}, 1",
                f"pavement number_of_sides {self.pick(3, 4, 6)} number_of_tiles {self.r.randrange(1, 5)}",
                f"tiling {self.r.randrange(1, 25)}",
            )
            return more, self.waves()
        name, mods = super().pattern()
        if self.chance(0.25):
            mods = mods + [self.warp()]
        return name, mods

    def waves(self):
        out = []
        if self.chance(0.3):
            out.append(f"frequency {self.f(-2, 4)}")
        if self.chance(0.3):
            out.append(f"phase {self.f(-1, 1)}")
        if self.chance(0.3):
            out.append(self.pick("sine_wave", "triangle_wave", "scallop_wave", "cubic_wave", f"poly_wave {self.f(0.5, 3)}"))
        return out

    def warp(self):
        return self.pick(
            f"warp {{ repeat {self.f(0.3, 2)}*{self.pick('x', 'y', 'z')} offset {self.v(-0.3, 0.3)} flip <{self.pick(0, 1)}, 1, 0> }}",
            f"warp {{ black_hole {self.v(-0.5, 0.5)}, {self.f(0.2, 0.9)} falloff {self.f(0.5, 3)} strength {self.f(0.5, 2)} inverse }}",
            f"warp {{ black_hole {self.v(-0.2, 0.2)}, {self.f(0.2, 0.4)} repeat {self.f(0.9, 1.5)} turbulence {self.f(0, 0.3)} }}",
            f"warp {{ turbulence {self.v(0, 0.7)} octaves {self.r.randrange(1, 7)} lambda {self.f(1.5, 3)} omega {self.f(0.2, 0.8)} }}",
            f"warp {{ planar {self.v(-1, 1)}, {self.f(-1, 1)} }}",
            f"warp {{ spherical orientation {self.pick('x', 'y', 'z')} dist_exp {self.f(0, 1)} }}",
            f"warp {{ cylindrical orientation {self.pick('x', 'y', 'z')} }}",
            f"warp {{ toroidal orientation y major_radius {self.f(0.3, 1.2)} }}",
        )

    def picture(self):
        """A picture that a function makes."""
        w, h = self.r.randrange(2, 9), self.r.randrange(2, 9)
        body = self.pick("{ x*0.7 + y*0.2 }", "{ sin(x*9)*0.5 + 0.5 }", "{ pigment { bozo color_map { [0.3 rgb <1, 0, 0>] [0.7 rgb <0, 1, 1>] } scale 0.2 } }")
        return f"function {w}, {h} {body}"

    def mapping(self):
        out = [f"map_type {self.pick(0, 0, 1, 2, 5)}"]
        if self.chance(0.4):
            out.append(f"interpolate {self.pick(2, 3, 4)}")
        if self.chance(0.25):
            out.append("once")
        return " ".join(out)

    # Pigments, normals, textures

    def pigment(self, depth=0, clear=0.0):
        if self.has("pictures") and self.chance(0.2):
            some = f"filter all {self.f(0, 0.6)}" if clear and self.chance(0.5) else ""
            return f"image_map {{ {self.picture()} {self.mapping()} {some} }} {self.move(0.5) if self.chance(0.5) else ''}"
        if self.has("blends") and depth < 2 and self.chance(0.2):
            entries = self.joined(self.r.randrange(2, 4), lambda: f"[{self.f(0.2, 2)} {self.pigment(depth + 1, clear)}]")
            return f"average pigment_map {{ {entries} }} {self.move(0.4) if self.chance(0.4) else ''}"
        text = super().pigment(depth, clear)
        if self.has("uv") and depth == 0 and self.chance(0.2):
            text = "uv_mapping " + text
        if self.has("colors") and self.chance(0.1):
            text += f" quick_color {super().color(0)}"
        return text

    def normal(self):
        if self.has("blends") and self.chance(0.5):
            kind = self.r.randrange(4)
            if kind == 0:
                name, mods = self.pattern()
                entries = " ".join(f"[{at} <{self.f(0, 1)}, {self.f(-1, 1)}>]" for at in sorted(self.f(0, 1) for _ in range(3)))
                if name.split()[0] not in CELLS:
                    return f"normal {{ {name} {self.f(-0.8, 0.8)} slope_map {{ {entries} }} {' '.join(mods)} scale {self.f(0.2, 1)} }}"
            if kind == 1:
                return f"normal {{ bump_map {{ {self.picture()} {self.mapping()} bump_size {self.f(0.1, 2)} }} {self.move(0.4)} }}"
            if kind == 2:
                name, mods = self.pattern()
                inner = lambda: self.normal()[len("normal {"):-1]
                if name.split()[0] not in CELLS:
                    return f"normal {{ {name} normal_map {{ [0.2 {inner()}] [0.8 {inner()}] }} {' '.join(mods)} scale {self.f(0.2, 1)} }}"
            if kind == 3:
                inner = lambda: self.normal()[len("normal {"):-1]
                return f"normal {{ average normal_map {{ [1 {inner()}] [{self.f(0.3, 2)} {inner()}] }} }}"
        text = super().normal()
        if self.chance(0.15):
            text = text[:-1] + self.pick(f"accuracy {self.f(0.005, 0.1)}", "no_bump_scale") + " }"
        return text

    def finish(self):
        text = super().finish()
        more = []
        if self.chance(0.1):
            more.append(f"diffuse albedo {self.f(0.3, 0.9)}")
        if self.chance(0.1):
            more.append(f"diffuse {self.f(0.3, 0.7)}, {self.f(0.1, 0.5)}")
        if self.chance(0.1):
            more.append("conserve_energy")
        if self.chance(0.1):
            more.append(f"reflection {{ {self.f(0, 0.6)} exponent {self.f(0.5, 2)} }}")
        if self.chance(0.05):
            more.append(f"specular albedo {self.f(0, 0.8)} ambient rgb {self.v(0, 0.4)}")
        return text[:-1] + " ".join(more) + " }"

    def texture(self, depth=0):
        clear = 0.5 if self.has("glass") and self.chance(0.5) else 0
        body = lambda: f"texture {{ {self.texture_body(clear)} }}"
        if depth == 0 and self.has("blends") and self.chance(0.2):
            cells = self.pick("checker", "brick", "hexagon", "square", "triangular", "cubic")
            return f"texture {{ {cells} {', '.join(body() for _ in range(CELLS[cells]))} {self.move(0.4)} }}"
        if depth == 0 and self.has("pictures") and self.chance(0.15):
            # (Between its pixels, the last bits of the point decide in POV-Ray: see the README.)
            picture, mapping = self.picture(), re.sub(r"interpolate \d", "", self.mapping())
            return f"texture {{ material_map {{ {picture} {mapping} {self.joined(3, body)} }} {self.move(0.4)} }}"
        if depth == 0 and self.has("blends") and self.chance(0.1):
            return f"texture {{ average texture_map {{ [1 {self.texture_body(clear)}] [{self.f(0.5, 2)} {self.texture_body(clear)}] }} }}"
        text = super().texture(depth)
        if self.has("uv") and self.chance(0.15) and text.startswith("texture { pigment"):
            text = text.replace("texture {", "texture { uv_mapping", 1)
        return text

    # Objects

    def numbers(self, count, size=1.0):
        return "<" + ", ".join(str(self.f(-size, size)) for _ in range(count)) + ">"

    def near(self, radius):
        """For what has no end."""
        return f"clipped_by {{ sphere {{ 0, {radius} }} }}"

    def outline(self, count):
        """Points at rising angles."""
        corner = lambda k: (self.f(0.5, 1.2), 2 * pi * k / count)
        return [(round(r * cos(a), 3), round(r * sin(a), 3)) for r, a in map(corner, range(count))]

    def spline(self, points):
        """A closed curve of any kind: its word, how many points, and the points."""
        n, kind = len(points), self.r.randrange(4)
        row = lambda count: [points[k % n] for k in range(count)]
        if kind < 3:
            chosen = row(n + 1 + kind)
        else:
            pieces = [(points[k], points[(k + 1) % n]) for k in range(n)]
            chosen = [q for a, b in pieces for q in (a, (a[0] * 1.1, a[1] * 1.1), (b[0] * 0.9, b[1] * 0.9), b)]
        word = ("linear_spline", "quadratic_spline", "cubic_spline", "bezier_spline")[kind]
        return word, f"{len(chosen)}, " + ", ".join(f"<{x:.3f}, {y:.3f}>" for x, y in chosen)

    def curved(self):
        kind = self.r.randrange(8)
        if kind == 0:
            return f"quadric {{ {self.v(-1, 1)}, {self.v(-1, 1)}, {self.v(-1, 1)}, {self.f(-1, 1)} {self.near(1.5)}"
        if kind == 1:
            return f"cubic {{ {self.numbers(20)} sturm {self.near(1.5)}"
        if kind == 2:
            return f"quartic {{ {self.numbers(35)} sturm {self.near(1.3)}"
        if kind == 3:
            terms = ", ".join(f"xyz({self.pick('0, 0, 1', '2, 1, 0', '0, 3, 1', '4, 0, 0', '0, 2, 2', '1, 1, 1', '0, 1, 0')}): {self.f(-1, 1)}" for _ in range(4))
            return f"polynomial {{ 5, {terms}, xyz(0, 2, 0): 0.2, xyz(0, 0, 0): {self.f(-0.4, 0.4)} sturm {self.near(1.3)}"
        return self.curved_solid()

    def curved_solid(self):
        kind = self.r.randrange(6)
        if kind == 5:
            wave, container = self.f(0, 0.4), self.pick("box { -0.9, 0.9 }", "sphere { 0, 0.9 }")
            function = f"x*x + {self.f(0.7, 1.5)}*y*y + z*z - 0.6 + {wave}*sin({self.f(0, 7)}*x)*sin({self.f(0, 7)}*y)"
            gradient = 3 + 7 * float(wave)
            return f"isosurface {{ function {{ {function} }} accuracy 0.000001 max_gradient {gradient:.2f} contained_by {{ {container} }} all_intersections"
        if kind == 0:
            return f"superellipsoid {{ <{self.pick(self.f(0.1, 1), self.f(0.2, 2))}, {self.pick(self.f(0.1, 1), self.f(0.2, 2))}>"
        if kind == 1:
            word, points = self.spline([(round(0.7 + 0.5 * x, 3), round(0.5 * y, 3)) for x, y in self.outline(6)])
            return f"lathe {{ {word} {points} sturm"
        if kind == 2:
            points = ", ".join(f"<{self.f(0.2, 1)}, {0.4 * k - 1 + self.f(0, 0.2):.3f}>" for k in range(6))
            return f"sor {{ 6, {points} {self.pick('', '', 'open')}"
        if kind == 3:
            word, points = self.spline(self.outline(7))
            sweep, bottom = self.pick(("", self.f(-0.8, 0.1)), ("linear_sweep", self.f(-0.8, 0.1)), ("conic_sweep", self.f(0.2, 0.5)))
            return f"prism {{ {word} {sweep} {bottom}, {bottom + self.f(0.3, 1):.3f}, {points} {self.pick('', '', 'open')}"
        squares = f"<{self.f(0.7, 1.3)}, {self.f(0.7, 1.3)}, {self.f(0.7, 1.3)}>"
        return f"quadric {{ {squares}, {self.v(-0.6, 0.6)}, {self.v(-1, 1)}, {self.f(-1, -0.1)}"

    def list_of(self, word, rows):
        return f"{word} {{ {len(rows)}, {', '.join(rows)} }}"

    def mesh(self):
        """Triangles at random, or an octahedron with an inside; some with textures of their own."""
        solid = self.chance(0.5)
        if solid:
            corners = [f"<{a * self.f(0.6, 1.2)}, {b * self.f(0.6, 1.2)}, {c * self.f(0.6, 1.2)}>"
                       for a, b, c in ((1, 0, 0), (0, 1, 0), (0, 0, 1), (-1, 0, 0), (0, -1, 0), (0, 0, -1))]
            faces = [(i, j, k) for i in (0, 3) for j in (1, 4) for k in (2, 5)]
        else:
            corners = [self.v(-1, 1) for _ in range(6)]
            # (Which of two triangles at the same place shows depends on POV-Ray's tree of boxes.)
            chosen = [tuple(self.r.sample(range(6), 3)) for _ in range(self.r.randrange(1, 7))]
            faces = list({frozenset(face): face for face in chosen}.values())
        inside = f"inside_vector {self.v(-1, 1)}" if solid else ""
        return (self.old_mesh if self.chance(0.5) else self.new_mesh)(corners, faces) + inside

    def old_mesh(self, corners, faces):
        smooth, on_surface, textured = self.chance(0.4), self.chance(0.4), self.chance(0.5)
        out = "mesh { "
        for face in faces:
            points = [corners[i] for i in face]
            if smooth:
                points = [row for point in points for row in (point, point.replace("0.0", "0.3"))]
            word = "smooth_triangle" if smooth else "triangle"
            uv = f" uv_vectors <{self.f(0, 1)}, 0>, <1, {self.f(0, 1)}>, <0, 1>" if on_surface else ""
            paint = self.pick("", " texture { MeshA }", " texture { MeshB }", " texture_list { MeshA, MeshB, MeshA }") if textured else ""
            out += f"{word} {{ {', '.join(points)}{uv}{paint} }} "
        return out

    def new_mesh(self, corners, faces):
        out = "mesh2 { " + self.list_of("vertex_vectors", corners)
        if self.chance(0.5):
            out += " " + self.list_of("normal_vectors", [self.pick(corner, corner, self.v(-1, 1)) for corner in corners])
        if self.chance(0.5):
            out += " " + self.list_of("uv_vectors", [f"<{self.f(0, 1)}, {self.f(0, 1)}>" for _ in corners])
        textures = [f"texture {{ {self.texture_body(0)} }}" for _ in range(2)] if self.chance(0.5) else []
        if textures:
            out += f" texture_list {{ {len(textures)}, {' '.join(textures)} }}"
        many = self.pick(1, 3)
        paint = lambda: "".join(f", {self.r.randrange(2)}" for _ in range(many)) if textures else ""
        return out + " " + self.list_of("face_indices", [f"<{a}, {b}, {c}>{paint()}" for a, b, c in faces]) + " "

    def letters(self):
        font, string = self.pick("timrom", "cyrvetic", "crystal"), self.pick("o", "B", "ab", "x8", "Q")
        return f'text {{ ttf "{font}.ttf" "{string}" {self.f(0.1, 0.8)}, {self.pick(0, 0, "0.1*x", "<0.1, 0.2, 0>")}'

    def blob(self):
        parts = []
        for _ in range(self.r.randrange(1, 5)):
            paint = self.texture(1) if self.chance(0.3) else ""
            place = self.move(0.4) if self.chance(0.3) else ""
            if self.chance(0.7):
                parts.append(f"sphere {{ {self.v(-0.6, 0.6)}, {self.f(0.5, 1.2)}, {self.f(-0.5, 2)} {paint} {place} }}")
            else:
                parts.append(f"cylinder {{ {self.v(-1, 0)}, {self.v(0, 1)}, {self.f(0.3, 0.8)}, {self.f(0.2, 2)} {paint} {place} }}")
        return f"blob {{ threshold {self.f(0.1, 0.8)} {' '.join(parts)} {self.pick('', 'sturm')}"

    def newer(self, solid):
        """A mesh, letters or a blob; None where none of them is wanted."""
        if self.has("meshes") and self.chance(0.3):
            while True:
                text = self.mesh()
                if not solid or "inside_vector" in text:
                    return text
        if self.has("letters") and self.chance(0.2):
            return self.letters()
        if self.has("blobs") and self.chance(0.3):
            return self.blob()
        return None

    def shape(self):
        if newer := self.newer(False):
            return newer
        if self.has("curved") and self.chance(0.5):
            return self.curved()
        if self.chance(0.15):
            corners = ", ".join(f"<{self.f(-1, 1)}, {self.f(-1, 1)}, 0>" for _ in range(4))
            first = corners.split(">, ")[0] + ">"
            return f"polygon {{ 5, {corners}, {first}"
        return super().shape()

    def solid(self):
        if newer := self.newer(True):
            return newer
        if self.has("curved") and self.chance(0.4):
            while True:
                text = self.curved_solid()
                if "open" not in text:
                    return text
        if self.chance(0.1):
            return f"plane {{ {self.v(-1, 1)}, {self.f(0.1, 0.8)}"
        return super().solid()

    def part(self, depth):
        if self.has("declared") and self.chance(0.15):
            return f"object {{ {self.pick('Thing', 'Other')} {self.move(0.5)} {'inverse' if self.chance(0.1) else ''} }}"
        return super().part(depth)

    def csg(self, depth):
        text = super().csg(depth)
        # POV-Ray takes it in these alone.
        if self.has("insides") and self.chance(0.3) and text.startswith(("intersection", "difference")):
            text = text[:-1] + "cutaway_textures }"
        return text

    def modifiers(self):
        out = super().modifiers()
        if self.has("insides"):
            if self.chance(0.2):
                out += f" interior_texture {{ {self.texture_body(0)} }}"
        if self.has("uv") and self.chance(0.1):
            out = "uv_mapping " + out
        # (A texture over a patterned one is refused.)
        if self.has("materials") and self.chance(0.3) and "texture" not in out:
            out += f" material {{ {self.texture(1)} interior {{ ior {self.f(1, 1.7)} }} }}"
        if self.has("prisms") and self.chance(0.3):
            out += f" interior {{ ior {self.f(1.1, 1.7)} dispersion {self.f(1, 1.2)} dispersion_samples {self.r.randrange(2, 12)} }}"
        if self.has("glass") and self.chance(0.1):
            out += f" interior {{ ior {self.f(1, 1.6)} caustics {self.f(0, 1)} }}"
        if self.has("media") and self.chance(0.15) and "interior {" not in out:
            out += f" {self.pick('hollow', 'hollow', '')} {self.filled()}"
        return out

    # Media: no `jitter`, no method 1 and no more than the least number of samples, all of which are random

    def density_colors(self, depth):
        """A density's pattern with its colours."""
        name, mods = self.pattern()
        if self.chance(0.5) or re.match("image_pattern|aoi|slope", name):
            name, mods = self.pick("spherical", "boxed", "planar", "cylindrical", "onion", f"gradient {self.v(-1, 1)}", "bozo"), self.waves()
            if self.chance(0.3):
                mods.append(self.pick(self.warp(), f"turbulence {self.pick(self.f(0, 0.8), self.v(0, 0.6))}"))
        if cells := CELLS.get(name.split()[0]):
            body = f"{name} {', '.join(f'density {{ {self.density(depth + 1)} }}' for _ in range(cells))}"
        else:
            stops = sorted(self.f(0, 1) for _ in range(self.r.randrange(2, 5)))
            body = self.pick(
                lambda: name,
                lambda: f"{name} color_map {{ {' '.join(f'[{s} {self.density_color()}]' for s in stops)} }}",
                lambda: f"{name} density_map {{ {' '.join(f'[{s} {self.density(depth + 1)}]' for s in stops)} }}",
            )()
        return f"{body} {' '.join(mods)} {self.move(0.5) if self.chance(0.5) else ''} {self.pick('', f'scale {self.f(0.3, 1.5)}')}"

    def density_color(self):
        return self.pick("rgb 0", "rgb 1", f"rgb {self.f(0, 2)}", f"rgb {self.v(0, 1.5)}", f"srgb {self.v(0, 1)}")

    def density(self, depth=0):
        if self.chance(0.5 if depth else 0.15) or depth > 1:
            return self.density_color()
        return self.density_colors(depth)

    def scattering(self, strength):
        number = self.r.randrange(1, 6)
        bend = f"eccentricity {self.f(-0.8, 0.8)}" if number == 5 and self.chance(0.8) else ""
        return f"scattering {{ {number}, {self.strength(strength)} {bend} {self.pick('', '', f'extinction {self.f(0, 1.5)}')} }}"

    def strength(self, most):
        return f"rgb {self.pick(self.f(0, most), self.v(0, most), self.v(0, most))}"

    def media(self, strength=1.5):
        out = [f"method {self.pick(3, 3, 2)}"] if self.old_language or self.chance(0.6) else []
        if self.old_language or self.chance(0.6):
            samples = self.r.randrange(1, 10)
            out.append(f"samples {samples}{self.pick('', f', {samples}')}")
        for text in (
            f"intervals {self.r.randrange(1, 4)}", f"ratio {self.f(0, 1)}", f"aa_level {self.r.randrange(1, 5)}",
            f"aa_threshold {self.f(0.01, 0.4)}", f"confidence {self.f(0.2, 0.99)}", f"variance {self.f(0.001, 0.1)}",
        ):
            if self.chance(0.25) or text.startswith("intervals") and self.old_language:
                out.append(text)
        kinds = [f"absorption {self.strength(strength)}", f"emission {self.strength(strength)}", self.scattering(strength)]
        out += self.r.sample(kinds, self.pick(1, 1, 2, 3))
        out += [f"density {{ {self.density()} }}" for _ in range(self.pick(0, 1, 1, 1, 2))]
        return f"media {{ {' '.join(out)} {self.move(0.5) if self.chance(0.2) else ''} }}"

    def filled(self):
        """An interior with media."""
        media = self.joined(self.pick(1, 1, 1, 2), self.media)
        ior = f"ior {self.f(1, 1.6)}" if self.chance(0.25) else ""
        fade = f"fade_distance {self.f(0.3, 3)} fade_power {self.pick(1, 2)} fade_color {self.color()}" if self.chance(0.1) else ""
        return f"interior {{ {ior} {media} {fade} }}"

    def clear_texture(self):
        pigment = self.pick("rgbt 1", "rgbt 1", "rgbf 1", f"rgbft <{self.f(0, 1)}, {self.f(0, 1)}, {self.f(0, 1)}, {self.f(0, 0.8)}, {self.f(0.2, 0.9)}>")
        return f"texture {{ pigment {{ {pigment} }} {self.pick('finish { ambient 0 diffuse 0 }', self.finish())} }}"

    def smoke(self):
        """An object full of media, at times with others inside."""
        move = self.move(0.8)
        kind = self.r.randrange(8)
        if kind == 0:
            parts = self.joined(self.r.randrange(2, 4), lambda: f"{self.solid()} {self.move(0.5)} }}")
            head = f"{self.pick('union', 'intersection', 'difference', 'merge')} {{ {parts}"
        elif kind == 1:
            # (The camera is inside.)
            head, move = self.pick("sphere { 0, 9", "box { -9, 9"), ""
        else:
            head = self.solid()
        inside = f"{self.shape()} {self.modifiers()} }}\n" if self.chance(0.3) else ""
        if self.chance(0.15):
            inside += f"{self.solid()} {self.clear_texture()} hollow {self.filled()} scale 0.5 {move} }}\n"
        clip = f"clipped_by {{ {self.solid()} {self.move(0.3)} }} }}" if self.chance(0.12) else ""
        flags = " ".join(word for word in ("no_shadow", "no_image", "no_reflection", "double_illuminate") if self.chance(0.05))
        full = f"{self.clear_texture()} {self.filled()}"
        if self.chance(0.2):
            full = f"material {{ {full} }}"
        return f"{inside}{head} {full} {self.pick('hollow', 'hollow', 'hollow', 'hollow', 'hollow', '')} {clip} {flags} {move} }}"

    def smoky(self):
        """Media of the whole scene, and objects full of them."""
        out = []
        if self.chance(0.35):
            out += [self.media(0.12) for _ in range(self.pick(1, 1, 2))]
            # (Rays without an end are sampled millions away, where the last digits decide.)
            out.append(f"sphere {{ 0, {self.f(12, 30)} hollow no_shadow {self.texture()} }}")
        if not out or self.chance(0.7):
            out += [self.smoke() for _ in range(self.r.randrange(1, 4))]
        return out

    def in_media(self, light):
        """How a light shines in media."""
        if not self.has("media"):
            return ""
        off = self.pick("", "", "", "", "media_interaction off")
        # (Not with a grid: see `lamp`.)
        return off + (" media_attenuation on" if "area_light" not in light and self.chance(0.4) else "")

    # Scenes

    def camera(self):
        place = f"<{self.f(-2, 2)}, {self.f(0, 3)}, {self.f(-7, -5)}>"
        words = [f"location {place}"]
        if self.chance(0.4):
            words.append(f"sky {self.v(-1, 1)}")
        if self.chance(0.4):
            words.append(f"right <{self.f(0.8, 2)}, {self.f(-0.2, 0.2)}, 0> up <0, {self.f(0.8, 1.4)}, 0>")
        if self.chance(0.3):
            words.append(f"direction <0, 0, {self.f(0.7, 2)}>")
        if self.chance(0.7):
            words.append(f"look_at {self.v(-0.3, 0.3)}")
        if self.chance(0.4):
            words.append(f"angle {self.f(25, 70)}")
        if self.chance(0.3):
            words.append(f"rotate {self.v(-20, 20)} translate {self.v(-0.4, 0.4)}")
        return f"camera {{ {' '.join(words)} }}"

    def eye(self):
        """A camera of another kind."""
        kind = self.pick(
            "orthographic", f"orthographic angle {self.f(20, 60)}", f"orthographic right {self.f(2, 6)}*x up {self.f(2, 5)}*y",
            f"fisheye angle {self.f(60, 300)}", f"ultra_wide_angle angle {self.f(40, 200)}", "panoramic", "omnimax",
            f"cylinder {self.pick(1, 2)} angle {self.f(40, 200)}", f"cylinder {self.pick(3, 4)} right 4*x up 3*y angle {self.f(40, 160)}",
            "spherical", f"spherical angle {self.f(60, 360)} {self.f(40, 180)}",
        )
        sky = f"sky {self.v(-1, 1)}" if self.chance(0.3) else ""
        moved = f"rotate {self.v(-20, 20)} translate {self.v(-0.4, 0.4)}" if self.chance(0.3) else ""
        place = f"<{self.f(-2, 2)}, {self.f(0, 3)}, {self.f(-6, -3)}>"
        return f"camera {{ {kind} location {place} {sky} look_at {self.v(-0.3, 0.3)} {moved} }}"

    def lamp(self):
        """A light of another kind, none of which is random."""
        edge = lambda a, b, c: f"radius {self.f(0, a)} falloff {self.f(a, b)} tightness {self.pick(0, 1, self.f(0, c))}"
        kind = self.pick("", f"spotlight {edge(15, 40, 20)}", f"cylinder {edge(1, 3, 3)}", "parallel", f"parallel spotlight {edge(20, 40, 5)}")
        if kind:
            kind += f" point_at {self.v(-0.5, 0.5)}"
        if self.chance(0.4):
            most = 4 if self.has("media") else 6
            n, m = self.r.randrange(2, most), self.r.randrange(2, most)
            kind += f" area_light {self.v(-1, 1)}, {self.v(-1, 1)}, {n}, {m} {self.pick('', 'adaptive 0', 'adaptive 1')}"
            kind += self.pick("", "", " circular", " circular orient", " area_illumination", " area_illumination circular")
        if self.chance(0.2):
            kind += f" looks_like {{ sphere {{ 0, {self.f(0.1, 0.6)} {self.texture()} }} }}"
        if self.chance(0.1):
            kind += f" projected_through {{ {self.solid()} translate <0, 1.5, -2> }} }}"
        fade = self.pick("", f"fade_distance {self.f(2, 9)} fade_power {self.pick(1, 2, 3)}")
        # (Not with a grid, whose light POV-Ray's fog weakens by the light's distance from the origin as well; see README.md.)
        fog = "media_attenuation on" if self.has("air") and self.chance(0.3) and "area_light" not in kind else ""
        fog = self.in_media(kind) if self.has("media") else fog
        moved = f"rotate {self.v(-20, 20)}" if self.chance(0.2) else ""
        return f"light_source {{ <{self.f(-6, 6)}, {self.f(2, 6)}, {self.f(-7, -3)}> {self.color()} {kind} {fade} {fog} {moved} }}"

    def haze(self):
        """What lies between and behind the surfaces."""
        out = []
        if self.chance(0.6):
            pigments = self.joined(self.r.randrange(1, 3), lambda: f"pigment {{ {self.pigment(0, 0.6)} }}")
            bright = self.pick("", "", f"emission {self.f(0, 2)}", f"emission rgb {self.v(0, 2)}")
            # (POV-Ray crashes where a sky asks for uv.)
            out.append(f"sky_sphere {{ {pigments.replace('uv_mapping', '')} {bright} {self.move(0.5) if self.chance(0.4) else ''} }}")
        for _ in range(self.r.randrange(0, 3)):
            ground = f"fog_type 2 fog_offset {self.f(-1, 1)} fog_alt {self.f(0.1, 2)}" if self.chance(0.5) else ""
            tilt = self.pick("", "", f"up {self.v(-1, 1)}", f"rotate {self.v(-90, 90)}") if ground else ""
            stir = f"turbulence {self.pick(self.f(0, 1), self.v(0, 1))} turb_depth {self.f(0, 1)}" if self.chance(0.4) else ""
            out.append(f"fog {{ distance {self.f(3, 30)} {self.color(0.5)} {ground} {tilt} {stir} }}")
        if self.chance(0.3):
            arc = self.pick("", f"arc_angle {self.f(90, 300)} falloff_angle {self.f(10, 90)} up {self.v(-1, 1)}")
            colors = f"[0 {self.color(0.5)}] [0.5 {self.color(0.5)}] [1 {self.color(0.5)}]"
            far = self.pick("", f"distance {self.f(3, 30)}")
            out.append(f"rainbow {{ direction {self.v(-1, 1)}+2*z angle {self.f(5, 40)} width {self.f(5, 30)} {far} color_map {{ {colors} }} {arc} }}")
        return out

    def grouped(self):
        """Lights that shine on something alone."""
        things = self.joined(self.r.randrange(1, 3), lambda: f"{self.shape()} {self.modifiers()} }}")
        lights = self.joined(self.r.randrange(1, 3), self.lamp)
        return f"light_group {{ {lights} {things} {self.pick('', 'global_lights on', 'global_lights off')} }}"

    def light(self):
        fade = self.pick("", f"fade_distance {self.f(2, 9)} fade_power {self.pick(1, 2, 3, self.f(0.5, 4))}")
        moved = f"rotate {self.v(-20, 20)}" if self.chance(0.2) else ""
        return f"light_source {{ <{self.f(-9, 9)}, {self.f(2, 9)}, {self.f(-9, -3)}> {self.color()} {fade} {self.pick('', '', 'shadowless')} {self.in_media('')} {moved} }}"

    def settings(self):
        out = []
        if self.chance(0.4):
            out.append(f"ambient_light {self.pick(self.f(0, 2), 'rgb ' + self.v(0, 2))}")
        if self.chance(0.3):
            out.append(f"adc_bailout {self.pick('1/255', '0', '0.02', '0.1')}")
        if self.chance(0.3):
            out.append(f"number_of_waves {self.r.randrange(1, 20)}")
        if self.chance(0.3):
            out.append(f"noise_generator {self.r.randrange(1, 4)}")
        if self.chance(0.2):
            out.append(f"irid_wavelength rgb {self.v(0.3, 0.8)}")
        return " ".join(out)

    def looped(self):
        text = f"{self.shape()} {self.modifiers()} }}"
        if self.chance(0.5):
            return (
                f"#macro Placed(Where, Turn)\n  object {{ {text} scale 0.4 rotate Turn*{self.pick('x', 'y', 'z')} translate Where }}\n#end\n"
                f"#for (I, 0, {self.r.randrange(1, 4)})\n  Placed(<I - 1, {self.f(-0.5, 0.5)}*I, 0>, I*{self.f(10, 80)})\n#end"
            )
        return (
            f"#declare Count = 0;\n#while (Count < {self.r.randrange(2, 5)})\n"
            f"  object {{ {text} scale 0.35 translate <Count - 1.5, mod(Count, 2), Count/3> }}\n  #declare Count = Count + 1;\n#end"
        )

    def sized(self, text):
        """The same scene, large or small about the origin, or far away from it."""
        size = self.pick("0.0001", "0.01", "100", "10000", "1")
        away = self.v(-1e6, 1e6) if size == "1" else "<0, 0, 0>"
        # (POV-Ray shows none of these so near: see the README.)
        if size == "0.0001" and re.search("blob|isosurface", text):
            size = "0.01"
        head, rest = text.split("camera {", 1)
        camera, rest = rest.split("}", 1)
        move = f"scale {size} translate {away}"
        lines, lights = [], []
        for line in rest.split("\n"):
            # (What lies behind and between things is not put into a union.)
            apart = ("light_source", "background", "sky_sphere", "fog", "rainbow", "media")
            (lights if line.startswith(apart) or not line.strip() else lines).append(line)
        moved = [line[:-1].rstrip() + f" {move} }}" if line.startswith("light_source") else line for line in lights]
        body = "\n".join(lines)
        if "#" in body or not body.strip():
            return text
        return head + f"camera {{{camera} {move} }}\n" + "\n".join(moved) + f"\nunion {{\n{body}\n{move} }}\n"

    def text(self):
        lines = super().text().split("\n")
        if self.has("media") and self.chance(0.1):
            lines[0], self.old_language = "#version 3.1;", True
        out = []
        for line in lines:
            if line.startswith("camera") and self.has("cameras"):
                line = self.camera()
            if line.startswith("camera") and self.has("eyes") and self.chance(0.8):
                line = self.eye()
            if line.startswith("global_settings") and self.has("media"):
                line = re.sub(r"max_trace_level \d+", f"max_trace_level {self.r.randrange(3, 6)}", line)
            if line.startswith("global_settings") and self.has("settings"):
                line = line[:-1] + self.settings() + " }"
            if line.startswith("light_source") and self.has("lights"):
                line = "\n".join(self.light() for _ in range(self.r.randrange(1, 3 if self.has("media") else 5)))
            elif line.startswith("light_source") and self.has("lamps"):
                line = "\n".join(self.lamp() for _ in range(self.r.randrange(1, 3)))
            out.append(line)
        head = out[:3]
        rest = out[3:]
        if self.has("meshes"):
            for name in ("MeshA", "MeshB"):
                head.insert(2, f"#declare {name} = texture {{ {self.texture_body(0)} }}")
        if self.has("defaults"):
            plain = f"texture {{ {self.texture_body(0)} }}"
            head.append(f"#default {{ {self.pick(plain, f'pigment {{ {self.pigment()} }}', self.finish())} }}")
        if self.has("declared"):
            head.append(f"#declare Thing = {self.solid()} {self.texture() if self.chance(0.5) else ''} {self.move(0.5)} }}")
            head.append(f"#declare Other = {self.csg_of_solids()}")
            bare = "texture" not in head[-1] and "pigment" not in head[-1]
            said = self.modifiers() if bare and self.chance(0.5) else ""
            rest.insert(0, f"object {{ Other {self.move(1)} {said} }}")
            rest.insert(0, f"object {{ Thing {self.move(1)} }}")
        if self.has("loops"):
            rest.append(self.looped())
        if self.has("lamps") and self.chance(0.3):
            rest.append(self.grouped())
        if self.has("air"):
            rest += self.haze()
        if self.has("media"):
            rest += self.smoky()
        text = "\n".join(head + rest) + "\n"
        if "image_pattern" in text:
            # (Where a pigment starts as a picture, `image_pattern` makes POV-Ray crash, or draw what lies in memory.)
            text = re.sub(r"#default \{ (texture \{ )?pigment \{ (uv_mapping )?image_map .*\n", "", text)
        if "assumed_gamma" not in text:
            # POV-Ray wants to know the gamma before it takes one of these.
            text = text.replace("srgb", "rgb")
        if self.has("quality"):
            # (Which `tool.py` understands.)
            text = f"// quality {self.r.randrange(12)}\n{text}"
        return self.sized(text) if self.has("sizes") and self.chance(0.7) else text

    def csg_of_solids(self):
        parts = self.joined(2, lambda: f"{self.solid()} {self.texture() if self.chance(0.4) else ''} {self.move(0.3)} }}")
        return f"{self.pick('union', 'intersection', 'difference', 'merge')} {{ {parts} {self.move(0.5)} }}"
