#!/usr/bin/env python3
"""Table of radiosity's brightness in scenes with known answers: durer, POV-Ray, truth.

Use: known_answers.py DURER, with `povray` on the path. The script fails if durer's mean
differs from the truth by more than 1 %.

The truth is the solution of the radiosity equation L = e + rho * sum(F * L) with the form factors F of each scene.
`cornell` has no closed form: its truth is POV-Ray's picture with more samples, which is not independent of POV-Ray's errors.
"""
import pathlib, struct, subprocess, sys, tempfile

SIZE = (64, 48)
SETTINGS = "count 400 recursion_limit 20 adc_bailout 0.001 nearest_count 10 error_bound 0.5 pretrace_end 0.02"
CONVERGED = "count 500 recursion_limit 20 adc_bailout 0.001 nearest_count 15 error_bound 0.35 pretrace_end 0.02"
HEAD = "#version 3.7;\nglobal_settings { assumed_gamma 1 radiosity { %s } }\n"
DOWN = "camera { location <0, 5, 0> look_at 0 right x*4/3 up z sky z }\n"


def surface(emission, diffuse):
    return "pigment { rgb 1 } finish { ambient 0 emission %g diffuse %g }" % (emission, diffuse)


CORNELL = f"""camera {{ location <0, 0, -2.9> look_at 0 right x*4/3 angle 70 }}
light_source {{ <0, 1.3, 0> rgb 0.5 }}
box {{ <-2, -1.5, -3>, <2, 1.5, 3> {surface(0, 0.7)} }}
box {{ <-1, -1.5, 0>, <0.2, 0, 1> {surface(0, 0.5)} rotate 20*y }}
"""
SCENES = {
    # Inside a sphere every point sees the sphere: L = e/(1 - rho).
    "furnace": ("camera { location 0 look_at z }\nsphere { 0, 10 %s }\n" % surface(0.2, 0.5), 0.4),
    # The floor sees the sky only: rho * L_sky.
    "sky": (DOWN + "background { rgb 0.5 }\nplane { y, 0 %s }\n" % surface(0, 0.6), 0.3),
    # Each plane sees the other only: L0 = 0.1 + 0.6 L1, L1 = 0.3 + 0.5 L0.
    "parallel plates": (DOWN + "plane { y, 0 %s }\nplane { -y, -10 %s }\n" % (surface(0.1, 0.6), surface(0.3, 0.5)), 0.4),
    # The outer sphere sees the inner one with F = 1/9: L1 = 1 + 0.5 L2, L2 = 0.6 (L1/9 + 8 L2/9).
    "sphere in a sphere": (
        "camera { location <0, 0, 1.5> look_at z*3 }\nsphere { 0, 1 %s }\nsphere { 0, 3 %s }\n"
        % (surface(1, 0.5), surface(0, 0.6)),
        0.153846,
    ),
    # Floor and wall see half of each other: Lf = 0.3 Lw, Lw = 0.8 + 0.25 Lf.
    "corner": (
        "camera { location <5, 5, 0> look_at <5, 0, 0> right x*4/3 up z sky z angle 60 }\nplane { y, 0 %s }\nplane { x, 0 %s }\n"
        % (surface(0, 0.6), surface(0.8, 0.5)),
        0.259459,
    ),
    "cornell": (CORNELL, None),
}


def mean(path):
    """Mean of a PPM picture with 16 bits of linear light."""
    count = SIZE[0] * SIZE[1] * 3
    return sum(struct.unpack(f">{count}H", path.read_bytes()[-2 * count :])) / count / 65535


def drawn(program, folder):
    """Mean of the picture that durer or POV-Ray renders of `scene.pov`."""
    options = ["+Iscene.pov", "+Opicture.ppm", "+FP16", "File_Gamma=1", f"+W{SIZE[0]}", f"+H{SIZE[1]}", "-D", "-A", "+WT1"]
    subprocess.run([program, *options], cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return mean(folder / "picture.ppm")


def main():
    durer, failed = pathlib.Path(sys.argv[1]).resolve(), False
    print(f"{'scene':20}{'truth':>10}{'durer':>10}{'error':>9}{'POV-Ray':>10}{'error':>9}")
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        for name, (text, truth) in SCENES.items():
            scene = folder / "scene.pov"
            if truth is None:
                scene.write_text(HEAD % CONVERGED + text)
                truth = drawn("povray", folder)
            scene.write_text(HEAD % SETTINGS + text)
            theirs = drawn("povray", folder)
            ours = drawn(durer, folder)
            errors = [value / truth - 1 for value in (ours, theirs)]
            failed |= abs(errors[0]) > 0.01
            print(f"{name:20}{truth:10.4f}{ours:10.4f}{errors[0]:9.2%}{theirs:10.4f}{errors[1]:9.2%}", flush=True)
    sys.exit(failed)


if __name__ == "__main__":
    main()
