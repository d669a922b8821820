"""povplot: runs `povray` with `+O-`, takes the picture from standard output, and reports exit code and standard error as `PovrayError`."""

from clients import Case

SCRIPT = """
import jinja2, matplotlib, numpy
matplotlib.use("Agg")
from matplotlib import cm, pyplot
# povplot is older than these libraries.
jinja2.environmentfilter = jinja2.pass_environment
cm.get_cmap = pyplot.get_cmap
import povplot
x, y = numpy.meshgrid(numpy.linspace(-1, 1, 5), numpy.linspace(-1, 1, 5))
points = numpy.stack([x.ravel(), y.ravel(), 0.3 * (x * x - y * y).ravel()], 1)
cells = [(i + 5 * j, i + 1 + 5 * j, i + 5 + 5 * j) for i in range(4) for j in range(4)]
cells += [(i + 1 + 5 * j, i + 6 + 5 * j, i + 5 + 5 * j) for i in range(4) for j in range(4)]
camera = dict(location=(1.5, -3, 2.5), look_at=(0, 0, 0), sky=(0, 0, 1))
for name, words in [("plain.png", {}), ("fine.png", dict(antialias=True, transparent=True))]:
    grid = dict(vertices=points, triangles=numpy.array(cells), values=points[:, 2], cmap="viridis")
    povplot.render_tripcolor(name, size=(80, 60), camera=camera, **grid, **words)
try:
    povplot.render("broken.png", scene="sphere { 0 }", size=(8, 6))
except povplot.PovrayError as fault:
    print("read", fault, "Parse Error" in fault.stderr)
"""

CASES = [Case("grid", lambda box: box.python(SCRIPT), needs=("python:povplot",))]
