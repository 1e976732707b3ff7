# SPDX-License-Identifier: MIT
"""Random scenes for the exact checker: drawn() has the files of one of a class of CLASSES."""
import random

import varied_scenes

SPLINE, DWELL, LAW = (f'[[motion.segments]]\nkind = "{kind}"\n' for kind in ("spline", "dwell", "law"))
LAWS = ("modified_sine", "modified_trapezoid", "cycloidal", "polynomial_345", "simple_harmonic", "gutman_13", "asymmetric_cycloidal")


def tables(r, motion, limits="", more="", segments=(8, 10, 12, 16)):
    weights = {name: r.choice((0, 0.1, 0.3, 1)) for name in ("velocity", "acceleration", "jerk", "area")}
    if not any(weights.values()):
        weights["jerk"] = 1
    objective = "".join(f"{name} = {weight}\n" for name, weight in weights.items() if weight)
    degree, count = r.choice((3, 3, 5)), r.choice(segments)
    return f"[motion]\n{motion}[spline]\ndegree = {degree}\nsegments = {count}\n[objective]\n{objective}" + \
        (f"[limits]\n{limits}" if limits else "") + more


def caps(r):
    """Some that contradict each other."""
    found = ""
    for name, least in (("velocity", 1.4), ("acceleration", 4.5), ("jerk", 30)):
        kind = r.random()
        if kind < 0.3:
            found += f"{name} = {least * r.uniform(0.9, 2):.4g}\n"
        elif kind < 0.45:
            found += f"{name} = {{ min = {-least * r.uniform(0.9, 2):.4g}, max = {least * r.uniform(0.9, 2):.4g} }}\n"
    return found


def rise(r):
    via = f"via = [{{ at = {r.uniform(0.3, 0.7):.3f}, displacement = {r.uniform(0.3, 0.7):.3f} }}]\n" if r.random() < 0.4 else ""
    corridor = "[[motion.corridor]]\nto_deg = 15\ndisplacement = { max = 0.35 }\n" if r.random() < 0.2 else ""
    return tables(r, f'type = "DRD"\nlift_mm = {r.randint(5, 80)}\nrise_deg = {r.randint(40, 170)}\n' + via + corridor, caps(r))


def rise_and_return(r):
    angle = r.choice(("deg = {}", "deg = {}", "rad = {:.4g}"))
    return tables(r, f'type = "RR"\nlift_mm = {r.randint(5, 40)}\nrise_deg = {r.randint(50, 150)}\nreturn_' +
                  angle.format(r.randint(50, 150) if angle.startswith("deg") else r.uniform(0.9, 2.5)) + "\n", caps(r))


def program(r):
    first, rest = r.randint(60, 150), r.randint(10, 50)
    middle = DWELL + f"angle_deg = {rest}\n" if r.random() < 0.5 else ""
    back = 360 - first - 40 - (rest if middle else 0)
    law = LAW + f'law = "{r.choice(LAWS)}"\n' if r.random() < 0.4 else SPLINE
    return tables(r, f'type = "program"\nlift_mm = {r.randint(10, 60)}\nspeed_rpm = {r.randint(50, 300)}\n' + SPLINE +
                  f"angle_deg = {first}\nto = 1\n" + middle + law + f"angle_deg = {back}\nto = 0\n" + DWELL + "angle_deg = 40\n", caps(r),
                  segments=(8, 10))


def valve(r):
    ramp = f"opening_ramp = {{ height_mm = {r.choice((0.25, 0.3))}, velocity_mm_deg = {r.choice((0.01, 0.012))} }}\n"
    cam = '[cam]\ntype = "disk"\nfollower = "translating_flat"\nbase_radius_mm = 18\n[forces]\nmass_kg = 0.11\nspring_rate_n_mm = 28\n' \
        "preload_n = 260\n" if r.random() < 0.5 else ""
    limits = f"acceleration_mm_deg2 = {{ min = {-r.uniform(0.011, 0.014):.4g}, max = {r.uniform(0.018, 0.025):.4g} }}\n"
    return f'[motion]\ntype = "valve"\nlift_mm = {r.uniform(8, 10):.3g}\nlash_mm = 0.2\nduration_crank_deg = {r.randint(235, 260)}\n' \
        f"checking_height_mm = 0.15\nengine_speed_rpm = 5500\n{ramp}[spline]\nsegments = 16\n[objective]\narea = 1\n[limits]\n{limits}" + \
        (f"contact_force_min_n = {r.randint(20, 90)}\n" if cam else "") + cam


def cam(r):
    follower = r.choice(("translating_roller", "translating_flat", "oscillating_roller"))
    arm = follower == "oscillating_roller"
    lift, sizes = f"lift_mm = {r.randint(8, 20)}", f"base_radius_mm = {r.randint(30, 50)}\n"
    limits = f"cam_radius_min_mm = {r.randint(2, 6)}\n"
    if follower != "translating_flat":
        sizes += "roller_radius_mm = 8\n"
        limits = f"pressure_angle_deg = {r.randint(28, 45)}\n"
    if arm:
        lift, sizes = f"lift_deg = {r.randint(8, 16)}", sizes + "center_distance_mm = 90\narm_length_mm = 70\n"
    forces = "[forces]\ninertia_kg_m2 = 1e-3\nspring_rate_nm_rad = 10\npreload_nm = 4\n" if arm else \
        "[forces]\nmass_kg = 0.4\nspring_rate_n_mm = 5\npreload_n = 150\n"
    limits += f"contact_{'moment_min_nm' if arm else 'force_min_n'} = {r.uniform(0.2, 2):.3g}\n"
    return tables(r, f'type = "RR"\n{lift}\nrise_deg = {r.randint(70, 120)}\nspeed_rpm = {r.randint(100, 400)}\n', limits,
                  f'[cam]\ntype = "disk"\nfollower = "{follower}"\n{sizes}{forces}', (8, 10))


def servo(r):
    limit = f"[limits]\nmotor_torque_nm = {r.uniform(3, 8):.3g}\n" if r.random() < 0.7 else ""
    return f'[motion]\ntype = "DRD"\nlift_mm = 100\nrise_deg = {r.randint(120, 180)}\nspeed_rpm = {r.randint(120, 220)}\n[drive]\n' \
        f"load_mass_kg = {r.randint(4, 12)}\nmotor_inertia_kg_m2 = 4e-4\ntransmission_mm_per_rev = 60\nviscous_n_s_m = 40\n[spline]\n" \
        f"segments = {r.choice((8, 12))}\n[objective]\n{r.choice(('motor_torque', 'motor_torque_rms'))} = 1\njerk = 0.1\n{limit}"


DRAWN = {"rise": rise, "rise and return": rise_and_return, "program": program, "valve": valve, "cam": cam, "servo": servo}
CLASSES = (*DRAWN, *varied_scenes.CLASSES)
ATTEMPTS = 6


def drawn(kind, seed, number, attempt=0):
    """{name: text}, the first is solved. Each attempt of a scene that is an example changed stays closer to this example."""
    if kind in DRAWN:
        return {"scene.toml": DRAWN[kind](random.Random(f"{seed} {kind} {number}"))}
    return varied_scenes.CLASSES[kind](random.Random(f"{seed} {kind} {number} {attempt}"), 0.5**attempt)
