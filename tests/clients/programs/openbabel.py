"""Open Babel: `obabel molecule.xyz -O molecule.pov` writes a scene that users pass to POV-Ray by hand, with the line in the
documentation.
"""

from clients import Case

# Folder of `babel_povray3.inc`, which the scenes include.
INCLUDES = "/usr/share/povray/include"

# Water with the hydrogen bonds' lengths in ångströms.
MOLECULE = """3
water
O 0.000 0.000 0.117
H 0.000 0.757 -0.470
H 0.000 -0.757 -0.470
"""

# Bonds as sticks, atoms as balls, and atoms that fill space.
MODELS = ["BAS", "SPF", "CST"]


def render(box):
    """Converts a molecule to the three models, and renders each."""
    box.write("water.xyz", MOLECULE)
    for model in MODELS:
        box.run("obabel", "water.xyz", "-O", f"water_{model}.pov", "-xm", model, name="exit code of obabel")
        box.run("povray", f"+Iwater_{model}.pov", f"+Owater_{model}.png", "+W96", "+H72", "+A0.3", "-D", "+FN", f"+L{INCLUDES}")


CASES = [Case("models", render, needs=("obabel",))]
