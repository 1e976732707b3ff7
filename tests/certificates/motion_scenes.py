# SPDX-License-Identifier: MIT
"""Scenes of every kind of end, bound and load of a motion, and changes of them that make what was claimed false."""
from pathlib import Path

OBJECTIVE = """[objective]
acceleration = 1
jerk = 0.2
[spline]
degree = 5
segments = 12
"""
SPLINE, DWELL, LAW = ('[[motion.segments]]\nkind = "spline"\n', '[[motion.segments]]\nkind = "dwell"\n',
                      '[[motion.segments]]\nkind = "law"\n')
KNIFE = '[motion]\ntype = "program"\nlift_deg = 360\nspeed_rpm = 250\nclosed = "relative"\n'
LINE = LAW + 'law = "constant_velocity"\nangle_deg = 30\n'
ROLLER = '[cam]\ntype = "disk"\nfollower = "translating_roller"\nbase_radius_mm = 40\nroller_radius_mm = 10\n'
SEARCHED = ROLLER.replace("= 40", "= { min = 10, max = 100 }")
FLAT = '[cam]\ntype = "disk"\nfollower = "translating_flat"\n'
FORCES = ("[forces]\nmass_kg = 0.8\nspring_rate_n_mm = 4\npreload_n = 120\ndamping_n_s_m = 30\ncontact_width_mm = 12\n"
          "load_n = [[0, 100], [60, -60], [150, -20], [220, 200]]\n")
PRESCRIBED = (
    '[motion]\ntype = "program"\nlift_mm = 20\nspeed_rpm = 300\n' + LAW + 'law = "cycloidal"\nangle_deg = 90\nto_mm = 20\n' +
    DWELL + "angle_deg = 60\n" + LAW + 'law = "polynomial_345"\nangle_deg = 120\nto_mm = 0\n' + DWELL + "angle_deg = 90\n")
LOADED = ('[motion]\ntype = "RR"\nlift_mm = 12\nrise_deg = 110\nspeed_rpm = 400\n[spline]\ndegree = 5\nsegments = 16\n'
          "[objective]\nacceleration = 1\n" + ROLLER + FORCES.replace("-60", "-160"))
LOBE = ('[motion]\ntype = "RR"\n[spline]\nsegments = 24\n[objective]\narea = 0.7\njerk = 0.3\n'
        "reference = { area = 0.5, jerk = 36.5 }\n[limits]\nacceleration = { min = -4.5, max = 9 }\njerk = 150\n")
RISE_AND_RETURN = ('[motion]\ntype = "program"\nlift_mm = 20\nspeed_rpm = 200\nwithin_lift = false\n' + SPLINE +
                   "angle_deg = 120\nto = 1\n" + DWELL + "angle_deg = 60\n" + SPLINE + "angle_deg = 180\n")
SLIDE = ('[motion]\ntype = "DRD"\nlift_mm = 100\nrise_deg = 144\nspeed_rpm = 200\n[drive]\nload_mass_kg = 8\n'
         "motor_inertia_kg_m2 = 4e-4\ntransmission_mm_per_rev = 60\nviscous_n_s_m = 40\nforce_n = 30\ncycle_deg = 300\n")
TURNTABLE = ("[drive]\nload_inertia_kg_m2 = 0.2\nmotor_inertia_kg_m2 = 1e-4\ntransmission_deg_per_rev = 36\nviscous_nm_s_rad = 0.3\n"
             "moment_nm = 1.5\n")



def lifts(count):
    """Of a lobe over one revolution, one every 360/count degrees from its middle on, with deviations of a few micrometres."""
    way = [max(0.0, 1 - abs(360 * k / count - 180) / 110) for k in range(count)]
    return [round(10 * u**3 * (10 - 15 * u + 6 * u * u) + (k * 7 % 5 - 2) / 500, 4) for k, u in enumerate(way)]


RISE_ROWS = ('[motion]\ntype = "DRD"\nlift_mm = 12\nrise_deg = 90\nspeed_rpm = 240\n[spline]\nsegments = 6\n[measured]\nuse = "nearest"\n'
             "theta_deg = [90, 80, 70, 60, 50, 40, 30, 20, 10, 0]\n"
             "s_mm = [12, 11.91, 11.22, 9.68, 7.31, 4.65, 2.38, 0.74, 0.12, 0]\n")
LOBE_ROWS = ('[motion]\ntype = "program"\nlift_mm = 10\nspeed_rpm = 100\n' + DWELL + "angle_deg = 60\n" + SPLINE + "angle_deg = 120\nto = 1\n" +
             LAW + 'law = "polynomial_345"\nangle_deg = 120\nto = 0\n' + DWELL + "angle_deg = 60\n[spline]\nsegments = 8\n[measured]\n"
             f'zero = {{ deg = 180 }}\nstep_deg = 7.5\ns_mm = {lifts(48)[24:] + lifts(48)[:24]}\n')
STROKE = SPLINE + "angle_deg = "
FREE = ('[motion]\ntype = "program"\nlift_mm = 14\nspeed_rpm = 100\n' + DWELL + "angle_deg = 20\n" + STROKE + "100\nto = 1\n" + STROKE +
        "30\n" + DWELL + "angle_deg = 10\n" + STROKE + "40\nto = 0.3\n" + STROKE + "60\n" + DWELL + "angle_deg = 40\n" + STROKE +
        "60\nto = 0\n" + OBJECTIVE)
FREE_LAW = ('[motion]\ntype = "program"\nlift_mm = 14\n' + DWELL + "angle_deg = 90\n" + STROKE + "10\n" + LAW +
            'law = "constant_velocity"\nangle_deg = 95\n' + STROKE + "10\nto_mm = 14\n" + STROKE + "155\n[spline]\nsegments = 8\n[objective]\n"
            "acceleration = 0.7\njerk = 0.3\n")
WITHIN, LEAVING = FREE, FREE.replace("lift_mm", "within_lift = false\nlift_mm")
FREE_DRIVE = ("[drive]\nload_mass_kg = 8\nmotor_inertia_kg_m2 = 4e-4\ntransmission_mm_per_rev = 60\nviscous_n_s_m = 40\nforce_n = 30\n"
              "[limits]\n")
FREE_LAW_BEYOND = FREE_LAW.replace("lift_mm = 14", "within_lift = false\nlift_mm = 14", 1)
FREE_LAW_AXIS = FREE_LAW.replace("lift_mm = 14", "lift_mm = 14\nspeed_rpm = 100", 1)
RANGE = "angle_deg = { min = 40, max = 150 }\n"
ANGLES = ('[motion]\ntype = "program"\nlift_mm = 14\nspeed_rpm = 100\n' + DWELL + "angle_deg = 60\n" + SPLINE + RANGE + "to = 1\n" + DWELL +
          "angle_deg = { min = 30, max = 50 }\n" + SPLINE + RANGE + "to = 0.05\n" + LAW + 'law = "cycloidal"\nangle_deg = 60\nto = 0\n'
          "[objective]\nacceleration = 1\nvelocity = 0.2\n[spline]\nsegments = 12\n[limits]\n")
CURVE = '[motion]\ntype = "DRD"\n[spline]\nknots = "free"\nsegments = 8\n[objective]\n'
SPRUNG = ('[motion]\ntype = "DRD"\nlift_mm = 20\nrise_deg = 60\nspeed_rpm = 400\n[spline]\nsegments = 12\n[objective]\nacceleration = 0.5\n'
          "jerk = 0.5\n" + ROLLER + "[forces]\nmass_kg = 1\nspring_rate_n_mm = 4\npreload_n = { min = 0, max = 1000 }\n")

SEPTIC = "[objective]\nvelocity = 0.4\nacceleration = 0.4\njerk = 0.2\n[spline]\ndegree = 7\nsegments = "

CASES = Path(__file__).resolve().parents[1] / "cases"

# Name: (scene, verdict).
TEXTS = {
    # Little freedom: that y'' = 0 where the velocity is 0 between two rises is met as an inequality, to its tolerance.
    "rest_between_rises": ((CASES / "weak_auto_6x_worse_than_ipopt.toml").read_text(), "optimal"),
    "ends_drd": ('[motion]\ntype = "DRD"\nlift_mm = 10\nrise_deg = 90\nspeed_rpm = 60\nstart = { velocity_mm_s = 20 }\n'
                 "end = { velocity = 0.5, acceleration = -1 }\n" + OBJECTIVE, "optimal"),
    "ends_rr": ('[motion]\ntype = "RR"\nstart = { velocity = -0.5 }\nend = { velocity = -0.5 }\n' + OBJECTIVE, "optimal"),
    "ends_open": ('[motion]\ntype = "program"\nlift_mm = 10\nclosed = false\nspeed_rpm = 60\nstart = { velocity = 0.4 }\n'
                  "end = { velocity_mm_s = -10, acceleration = 2 }\n" + SPLINE + "angle_deg = 90\nto = 1\n"
                  "via = [{ at = 0.4, displacement = 0.45 }]\n" + SPLINE + "angle_deg = 60\nto = 0.5\n"
                  "via = [{ at = 0.5, velocity = -1 }]\n" + OBJECTIVE, "optimal"),
    "regions": ('[motion]\ntype = "program"\nlift_deg = 360\nclosed = false\n' + SPLINE + "angle_deg = 360\nto_deg = 360\nvia = ["
                "{ from_deg = 0, to_deg = 10, velocity_deg_deg = 0.5 }, { from_deg = 350, to_deg = 360, velocity_deg_deg = 0.5 }]\n"
                "[spline]\ndegree = 5\nsegments = 24\n[objective]\nacceleration = 1\n", "optimal"),
    "septic_drd": ('[motion]\ntype = "DRD"\n' + SEPTIC + "14\nrest = 5\n", "optimal"),
    "septic_rr": ('[motion]\ntype = "RR"\nlift_mm = 10\nrise_deg = 90\nreturn_deg = 110\nvia = [{ from_deg = 30, to_deg = 40, '
                  'velocity_mm_deg = 0.18 }]\n' + SEPTIC + '16\ncontinuity = 4\nend_jerk = "zero"\n', "optimal"),
    "septic_program": ('[motion]\ntype = "program"\nlift_mm = 20\n' + DWELL + "angle_deg = 50\n" + SPLINE + "angle_deg = 120\nto = 1\n" +
                       LAW + 'law = "modified_sine"\nangle_deg = 100\nto = 0.3\n' + SPLINE + "angle_deg = 90\nto = 0\n" + SEPTIC +
                       "10\nrest = 4\n", "optimal"),
    "septic_cam": ('[motion]\ntype = "DRD"\nlift_mm = 20\nrise_deg = 60\n' + SEPTIC + "14\nrest = 4\n" + ROLLER.replace("= 40", "= 30") +
                   "[limits]\npressure_angle_deg = 31\n", "optimal"),
    "septic_drive": (SLIDE + "[spline]\ndegree = 7\nsegments = 10\nrest = 4\n[objective]\nmotor_torque_rms = 1\njerk = 0.2\n[limits]\n"
                     "motor_torque_nm = 6\n", "optimal"),
    "turning": ('[motion]\ntype = "program"\nlift_mm = 10\nclosed = false\nwithin_lift = false\n' + SPLINE + "angle_deg = 90\nto = 1\n"
                "end = { velocity = 0 }\n" + SPLINE + "angle_deg = 60\nto = -1\n" + OBJECTIVE, "optimal"),
    "ring": (KNIFE + SPLINE + "angle_deg = 200\nto = 0.8\nvia = [{ at = 0.5, velocity_deg_deg = 0.5 }]\n" + SPLINE +
             "angle_deg = 160\nto = 1\n" + OBJECTIVE, "optimal"),
    "seam": (KNIFE + SPLINE + "angle_deg = 150\nto = 0.5\n" + DWELL + "angle_deg = 60\n" + SPLINE + "angle_deg = 150\nto = 1\n"
             "[[motion.corridor]]\nfrom_deg = 300\nto_deg = 330\ndisplacement = { min = 0.66 }\n" + OBJECTIVE, "optimal"),
    "lines": (KNIFE + LINE + "to_deg = 40\n" + SPLINE + "angle_deg = 300\nto_deg = 320\n" + LINE + "to_deg = 360\n" + OBJECTIVE,
              "optimal"),
    "across": (RISE_AND_RETURN + "[spline]\ndegree = 5\nsegments = 16\n[objective]\njerk = 1\n[limits]\n"
               "acceleration_m_s2 = { min = -9, max = 14 }\n", "optimal"),
    "each": (RISE_AND_RETURN + "[spline]\ndegree = 5\nsegments = 16\n[objective]\njerk = 1\narea = 0.5\n[limits]\n"
             "acceleration = { min = -5, max = 8 }\n", "optimal"),
    "repeat": ('[motion]\ntype = "program"\nlift_mm = 10\nwithin_lift = false\nrepeat = 4\n' + SPLINE + "angle_deg = 40\nto = 1\n" +
               DWELL + "angle_deg = 10\n" + SPLINE + "angle_deg = 40\n[[motion.corridor]]\nfrom_deg = 100\nto_deg = 110\n"
               "displacement = { max = 0.2 }\n" + OBJECTIVE, "optimal"),
    "lobe": (LOBE, "optimal"),
    "area": ('[motion]\ntype = "DRD"\n[objective]\narea = 1\njerk = 1\n', "optimal"),
    "corridor": ('[motion]\ntype = "DRD"\nlift_mm = 10\nrise_deg = 120\nspeed_rpm = 300\n[[motion.corridor]]\nfrom_deg = 21\n'
                 "to_deg = 41\ndisplacement_mm = { max = 1 }\n[[motion.corridor]]\nfrom_deg = 61.5\nto_deg = 83.2\n"
                 "velocity_mm_s = { min = 60, max = 260 }\nacceleration_m_s2 = { max = 4 }\n[spline]\ndegree = 5\nsegments = 24\n"
                 "[objective]\nacceleration = 0.5\njerk = 0.5\n", "optimal"),
    "corridor_no": ('[motion]\ntype = "DRD"\nlift_mm = 10\nrise_deg = 100\n[[motion.corridor]]\nto_deg = 60\n'
                    "displacement_mm = { max = 0.5 }\n[objective]\njerk = 1\n[limits]\nacceleration = 8\n", "infeasible"),
    "monotone": ('[motion]\ntype = "DRD"\nmonotone = true\nvia = [{ at = 0.5, displacement = 0.2 }]\n[spline]\nsegments = 16\n'
                 "[objective]\njerk = 1\narea = 0.3\n", "optimal"),
    "prescribed": (PRESCRIBED + "[limits]\nvelocity = 2.1\n[objective]\nvelocity = 1\narea = 0.2\n[[motion.corridor]]\n"
                   "from_deg = 20\nto_deg = 40\ndisplacement_mm = { max = 9 }\nvelocity_mm_s = { max = 900 }\n", "optimal"),
    "prescribed_numbers": (PRESCRIBED.replace('"cycloidal"', '"scca(1, 2, 1.5, 0.5)"').replace('"polynomial_345"', '"s_curve(0.3, 0.4, 0.2)"') +
                           ROLLER + "[limits]\nvelocity = 2.1\npressure_angle_deg = 40\n[objective]\njerk = 1\n"
                           'reference = "modified_sine(Ta = 0.2)"\n', "optimal"),
    "prescribed_turn": (PRESCRIBED.replace('"cycloidal"', '"one_dwell_modified_sine(0.2)"').replace(DWELL + "angle_deg = 60\n", "")
                        .replace('"polynomial_345"', '"one_dwell_polynomial_345"').replace("= 90\n" + LAW, "= 110\n" + LAW)
                        .replace(DWELL + "angle_deg = 90", DWELL + "angle_deg = 150") + "[limits]\nvelocity = 1.9\n[objective]\n"
                        "acceleration = 1\n", "optimal"),
    "polynomials": ('[motion]\ntype = "program"\nlift_mm = 30\nspeed_rpm = 60\n' + LAW + 'law = "polynomial"\nangle_deg = 70\nto = 0.3\n' +
                    LINE.replace("30", "40") + "to = 0.7\n" + LAW + 'law = "polynomial"\nangle_deg = 60\nto = 1\n'
                    "end = { velocity_mm_s = -30 }\n" + SPLINE + "angle_deg = 120\nto = 0.2\n" + LAW + 'law = "polynomial"\nangle_deg = 70\n'
                    "to = 0\n" + OBJECTIVE, "optimal"),
    "prescribed_no": (PRESCRIBED + "[limits]\nvelocity = 1.9\n", "infeasible"),
    "prescribed_side": (PRESCRIBED + "[limits]\nacceleration_m_s2 = { min = -20 }\n", "infeasible"),
    "prescribed_cam": (PRESCRIBED + ROLLER + FORCES + "[limits]\npressure_angle_deg = 40\ncontact_force_min_n = 50\n"
                       "torque_max_nm = 12\nhertz_pressure_max_mpa = 700\n", "optimal"),
    "prescribed_steep": (PRESCRIBED + ROLLER + "[limits]\npressure_angle_deg = 10\n", "infeasible"),
    "prescribed_base": (PRESCRIBED + SEARCHED + "[objective]\nbase_radius = 1\n[limits]\npressure_angle_deg = 30\n", "optimal"),
    "prescribed_flat": (PRESCRIBED + FLAT + "base_radius_mm = { min = 5, max = 300 }\n[objective]\nacceleration = 1\n"
                        "base_radius = 1\n[limits]\ncam_radius_min_mm = 2\n", "optimal"),
    "load": (LOADED + "[limits]\ncontact_force_min_n = 20\n", "optimal"),
    "chosen_preload": (SPRUNG + "[limits]\ncontact_force_min_n = 10\ncontact_force_max_n = 260\n", "optimal"),
    "chosen_none": (SPRUNG.replace("max = 1000", "max = 5") + "[limits]\ncontact_force_min_n = 10\n", "infeasible"),
    "tappet": ('[motion]\ntype = "RR"\nlift_mm = 8\nrise_deg = 60\nspeed_rpm = 500\n[spline]\nsegments = 16\n[objective]\njerk = 1\n' +
               FLAT + "base_radius_mm = 30\nface_radius_mm = 15\n[forces]\ncontact_width_mm = 14\npreload_n = 100\n", "optimal"),
    "inch": ('[motion]\ntype = "RR"\nlift_in = 0.35\nrise_crank_deg = 120\nreturn_crank_deg = 130\nspeed_rpm = 2500\n'
             "start = { velocity_in_deg = 0.0005 }\n[spline]\nsegments = 24\n[objective]\njerk = 1\nacceleration = 1\n[limits]\n"
             "acceleration_in_s2 = { min = -120000, max = 240000 }\ncontact_force_min_lbf = 10\n" + FLAT + "base_radius_in = 0.7\n"
             "face_radius_in = 0.5\n[forces]\nmass_lb = 0.5\nspring_rate_lbf_in = 300\npreload_lbf = 60\ncontact_width_in = 0.4\n",
             "optimal"),
    "drive_rms_term": (SLIDE + "[spline]\nsegments = 16\n[objective]\nmotor_torque_rms = 1\njerk = 0.02\n[limits]\nmotor_torque_nm = 4.2\n",
                       "optimal"),
    "drive_friction": ('[motion]\ntype = "program"\nlift_deg = 30\nspeed_rpm = 60\nmonotone = true\n' + DWELL + "angle_deg = 40\n" + SPLINE +
                       "angle_deg = 120\nto = 1\n" + DWELL + "angle_deg = 50\n" + LAW + 'law = "modified_sine"\nangle_deg = 150\nto = 0\n' +
                       TURNTABLE + "friction_nm = 0.8\n[spline]\nsegments = 10\n[limits]\nmotor_torque_nm = { min = -0.4, max = 0.72 }\n"
                       '[objective]\njerk = 0.2\nmotor_torque_rms = 1\nreference = "cycloidal"\n', "optimal"),
    "drive_range": (SLIDE.replace("per_rev = 60", "per_rev = { min = 20, max = 120 }") + "[objective]\njerk = 1\n[spline]\nsegments = 16\n"
                    "[limits]\nmotor_torque_nm = 4.2\n", "local"),
    "drive_curve": (SLIDE + "[objective]\njerk = 1\n[spline]\ndegree = 5\nsegments = 16\n[limits]\n"
                    "motor_curve = [[0, 4.4], [900, 4.4], [2100, 1.2]]\nmotor_speed_rpm = 1500\n", "optimal"),
    "drive_rms_limit": (SLIDE + "[objective]\njerk = 1\nmotor_torque = 0.2\n[spline]\nsegments = 16\n[limits]\n"
                        "motor_torque_rms_nm = 2.2\n", "optimal"),
    "drive_rms_no": (SLIDE + "[objective]\njerk = 1\n[spline]\nsegments = 16\n[limits]\nmotor_torque_rms_nm = 2.2\n"
                     "motor_torque_nm = 4.0\n", "infeasible"),
    "drive_no": (SLIDE + "[objective]\nmotor_torque_rms = 1\n[spline]\nsegments = 16\n[limits]\nmotor_torque_nm = 3.6\n", "infeasible"),
    "drive_relative": (KNIFE + LINE + "to_deg = 40\n" + SPLINE + "angle_deg = 300\nto_deg = 320\n" + LINE + "to_deg = 360\n" + TURNTABLE +
                       "[spline]\ndegree = 5\nsegments = 12\n[objective]\nmotor_torque = 1\njerk = 0.1\n", "optimal"),
    "drive_repeat": ('[motion]\ntype = "program"\nlift_mm = 40\nspeed_rpm = 50\nmonotone = true\nrepeat = 3\n' + SPLINE +
                     "angle_deg = 50\nto = 1\n" + DWELL + "angle_deg = 20\n" + SPLINE + "angle_deg = 50\nto = 0\n[drive]\nload_mass_lb = 9\n"
                     "transmission_in_per_rev = 2\nfriction_lbf = 3\n[spline]\nsegments = 10\n[limits]\nmotor_torque_lbf_in = 3\n"
                     "[objective]\nmotor_torque_rms = 1\nacceleration = 0.1\n", "optimal"),
    "drive_prescribed": (PRESCRIBED + "[drive]\nload_mass_kg = 3\ntransmission_mm_per_rev = 20\nfriction_n = 12\n[limits]\n"
                         "motor_curve = [[0, 0.9], [2500, 0.5]]\nmotor_torque_rms_nm = 0.5\n[objective]\nmotor_torque = 1\n", "optimal"),
    "nearest": (RISE_ROWS + "[limits]\nacceleration_m_s2 = 18.6\n", "optimal"),
    "nearest_rms": (RISE_ROWS + 'norm = "rms"\n[limits]\nacceleration_m_s2 = 18.6\n', "optimal"),
    "nearest_lobe": (LOBE_ROWS + "[objective]\ndeviation = 0.2\njerk = 1\nreference = { deviation = 0.002, jerk = 60 }\n", "optimal"),
    "nearest_lobe_rms": (LOBE_ROWS + "[objective]\ndeviation_rms = 0.5\njerk = 1\n", "optimal"),
    "free": (FREE.replace("lift_mm", "within_lift = false\nlift_mm"), "optimal"),
    "free_law": (FREE_LAW, "optimal"),
    "free_cases": (FREE.replace("lift_mm", "monotone = true\nlift_mm") + "[limits]\nacceleration_m_s2 = 8\n", "optimal"),
    "free_within": (FREE.replace("30\n", "30\nvia = [{ at = 0.5, acceleration = 10 }]\n", 1), "optimal"),
    "free_drive": (LEAVING + FREE_DRIVE + "motor_torque_nm = 0.55\n", "optimal"),
    "free_drive_cases": (WITHIN + FREE_DRIVE + "motor_curve = [[0, 0.6], [80, 0.58], [300, 0.4]]\n", "optimal"),
    "free_drive_peak": (LEAVING.replace("jerk = 0.2", "jerk = 0.2\nmotor_torque = 0.3") + FREE_DRIVE, "optimal"),
    "free_drive_rms": (FREE_LAW_AXIS.replace("jerk = 0.3", "jerk = 0.3\nmotor_torque_rms = 0.3") + FREE_DRIVE + "motor_torque_nm = 1\n",
                       "optimal"),
    "free_drive_no": (WITHIN + FREE_DRIVE + "motor_torque_nm = 0.3\n", "infeasible"),
    "free_drive_rms_no": (FREE_LAW_AXIS + FREE_DRIVE + "motor_torque_rms_nm = 0.2\nmotor_speed_rpm = 100\n", "infeasible"),
    "free_drive_sine_no": (FREE_LAW_AXIS.replace("constant_velocity", "modified_sine") + FREE_DRIVE + "motor_torque_rms_nm = 0.32\n", "infeasible"),
    "free_area": (WITHIN.replace("jerk = 0.2", "jerk = 0.2\narea = 0.3"), "optimal"),
    "free_area_law": (FREE_LAW.replace("jerk = 0.3", 'area = 0.3\nreference = "asymmetric_parabolic"'), "optimal"),
    "free_corridor": (LEAVING + "[[motion.corridor]]\nfrom_deg = 150\nto_deg = 160\ndisplacement_mm = { max = 12 }\n", "optimal"),
    "free_corridor_law": (FREE_LAW_BEYOND + "[[motion.corridor]]\nfrom_deg = 110\nto_deg = 115\ndisplacement_mm = { min = 20 }\n", "optimal"),
    "free_velocity_law": (FREE_LAW_BEYOND + "[[motion.corridor]]\nfrom_deg = 100\nto_deg = 195\nvelocity_mm_deg = { max = -0.1 }\n",
                          "optimal"),
    "free_cam": (WITHIN.replace("[spline]", "base_radius = 0.1\n[spline]") + SEARCHED.replace("= 10\n", "= 6\n") +
                 "[limits]\npressure_angle_deg = 17\n", "optimal"),
    "angles_side": (ANGLES + "acceleration = { min = -4.6, max = 9 }\njerk_m_s3 = 150\n", "optimal"),
    "angles_side_no": (ANGLES + "acceleration_m_s2 = { min = -1, max = 2.5 }\n", "infeasible"),
    "angles": (ANGLES + "jerk_m_s3 = 150\n", "optimal"),
    "angles_one": (ANGLES + "acceleration = 8\n", "optimal"),
    "angles_no": (ANGLES + "jerk_m_s3 = 60\n", "infeasible"),
    "curve": (CURVE + "velocity = 0.5\nacceleration = 0.5\n[limits]\njerk = 80\n", "optimal"),
    "curve_jerk": (CURVE + "jerk = 1\n[limits]\nvelocity = 1.8\n", "optimal"),
    "curve_no": (CURVE + "jerk = 1\n[limits]\nvelocity = 1.5\nacceleration = 6\njerk = 60\n", "infeasible"),
    "free_no": (FREE + "[limits]\nacceleration_m_s2 = 1\n", "infeasible"),
    "drive_prescribed_no": (PRESCRIBED + "[drive]\nload_mass_kg = 3\ntransmission_mm_per_rev = 20\n[limits]\nmotor_torque_nm = 0.3\n",
                            "infeasible"),
}

# (scene, what stands in its scene.toml, what it is replaced by): the files then claim what is not so.
CHANGES = [
    ("ends_drd", "velocity_mm_s = 20", "velocity_mm_s = 21"), ("ends_drd", "acceleration = -1 }", "acceleration = -1.1 }"),
    ("ends_rr", "start = { velocity = -0.5 }", ""), ("ends_open", "velocity_mm_s = -10", "velocity_mm_s = -11"),
    ("regions", "to_deg = 10, velocity_deg_deg = 0.5", "to_deg = 10, velocity_deg_deg = 0.51"),
    ("septic_drd", "rest = 5", "rest = 4"), ("septic_drd", "rest = 5", "rest = 6"), ("septic_drd", "degree = 7\n", "degree = 7\ncontinuity = 5\n"),
    ("septic_rr", "continuity = 4", "continuity = 3"), ("septic_rr", "end_jerk = \"zero\"", "rest = 4"), ("septic_rr", "= 0.18", "= 0.181"),
    ("septic_program", "rest = 4", "rest = 3"), ("septic_program", "rest = 4", "rest = 5"), ("septic_cam", "angle_deg = 31", "angle_deg = 30.9"),
    ("septic_cam", "rest = 4", "rest = 3"), ("septic_drive", "load_mass_kg = 8", "load_mass_kg = 8.01"), ("septic_drive", "rest = 4", "rest = 5"),
    ("turning", "end = { velocity = 0 }", "end = { velocity = 0.1 }"), ("turning", "end = { velocity = 0 }", ""),
    ("ring", "to = 1\n", "to = 1.01\n"), ("ring", 'closed = "relative"', "closed = false"),
    ("seam", 'closed = "relative"', "closed = false"), ("seam", "min = 0.66", "min = 0.67"),
    ("lines", "to_deg = 320", "to_deg = 321"), ("across", "max = 14", "max = 9"), ("across", "min = -9", "min = -8.9"),
    ("each", "min = -5", "min = -4.9"), ("repeat", "repeat = 4", "repeat = 3"), ("repeat", "max = 0.2", "max = 0.19"),
    ("repeat", "to_deg = 110", "to_deg = 111"), ("lobe", "min = -4.5", "min = -4.4"), ("lobe", "min = -4.5", "min = -4.6"),
    ("lobe", "area = 0.7", "area = 0.71"), ("lobe", "area = 0.5", "area = 0.49"), ("area", "area = 1", "area = 0.9"),
    ("corridor", "max = 1 }", "max = 0.99 }"), ("corridor", "max = 1 }", "max = 1.01 }"), ("corridor", "max = 260", "max = 250"),
    ("corridor", "to_deg = 41", "to_deg = 42"), ("corridor", "to_deg = 41", "to_deg = 40"),
    ("corridor_no", "max = 0.5", "max = 5"), ("corridor_no", "to_deg = 60", "to_deg = 30"),
    ("monotone", "displacement = 0.2", "displacement = 0.25"),
    ("prescribed", "velocity = 2.1", "velocity = 1.9"), ("prescribed", "max = 900", "max = 300"),
    ("prescribed", "max = 9 }", "max = 3 }"), ("prescribed", "area = 0.2", "area = 0.3"), ("prescribed", "cycloidal", "modified_sine"),
    ("prescribed_no", "velocity = 1.9", "velocity = 2.1"), ("prescribed_side", "min = -20", "min = -80"),
    ("prescribed_cam", "pressure_angle_deg = 40", "pressure_angle_deg = 20"),
    ("prescribed_cam", "contact_force_min_n = 50", "contact_force_min_n = 150"),
    ("prescribed_cam", "torque_max_nm = 12", "torque_max_nm = 3"), ("prescribed_cam", "damping_n_s_m = 30", "damping_n_s_m = 3000"),
    ("prescribed_cam", "hertz_pressure_max_mpa = 700", "hertz_pressure_max_mpa = 300"),
    ("prescribed_steep", "pressure_angle_deg = 10", "pressure_angle_deg = 40"),
    ("prescribed_base", "pressure_angle_deg = 30", "pressure_angle_deg = 29"),
    ("prescribed_base", "pressure_angle_deg = 30", "pressure_angle_deg = 31"),
    ("prescribed_flat", "cam_radius_min_mm = 2", "cam_radius_min_mm = 3"),
    ("prescribed_flat", "cam_radius_min_mm = 2", "cam_radius_min_mm = 1"),
    ("load", "-160]", "-170]"), ("load", "[150, -20]", "[150, -40]"), ("load", "damping_n_s_m = 30", "damping_n_s_m = 300"),
    ("load", "contact_force_min_n = 20", "contact_force_min_n = 21"),
    ("rest_between_rises", "velocity = 0.6174", "velocity = 0.6175"), ("rest_between_rises", "to = 0.57", "to = 0.571"),
    ("chosen_preload", "max = 1000", "max = 90"), ("chosen_preload", "contact_force_max_n = 260", "contact_force_max_n = 259"),
    ("chosen_preload", "contact_force_min_n = 10", "contact_force_min_n = 11"), ("chosen_preload", "mass_kg = 1", "mass_kg = 1.01"),
    ("chosen_none", "max = 5", "max = 50"),
    ("tappet", "face_radius_mm = 15", "face_radius_mm = 14.9"), ("tappet", "contact_width_mm = 14", "contact_width_mm = 15"),
    ("tappet", "face_radius_mm = 15", "face_radius_mm = 15.1"), ("inch", "velocity_in_deg = 0.0005", "velocity_in_deg = 0.0006"),
    ("inch", "contact_force_min_lbf = 10", "contact_force_min_lbf = 60"),
    ("drive_rms_term", "load_mass_kg = 8", "load_mass_kg = 8.01"), ("drive_rms_term", "cycle_deg = 300", "cycle_deg = 310"),
    ("drive_rms_term", "motor_torque_nm = 4.2", "motor_torque_nm = 4.19"),
    ("drive_rms_term", "motor_torque_nm = 4.2", "motor_torque_nm = 4.21"),
    ("polynomials", "velocity_mm_s = -30", "velocity_mm_s = -31"), ("polynomials", "to = 0.3\n", "to = 0.31\n"),
    ("prescribed_numbers", "Ta = 0.2", "Ta = 0.21"), ("prescribed_numbers", "1.5, 0.5", "1.5, 0.6"),
    ("prescribed_turn", "modified_sine(0.2)", "modified_sine(0.21)"),
    ("drive_friction", "friction_nm = 0.8", "friction_nm = 0.81"), ("drive_friction", "min = -0.4", "min = -0.39"),
    ("drive_friction", "moment_nm = 1.5", "moment_nm = 1.6"), ("drive_friction", "max = 0.72", "max = 0.73"),
    ("drive_friction", "reference = \"cycloidal\"", "reference = \"polynomial_345\""),
    ("drive_curve", "[900, 4.4]", "[910, 4.4]"), ("drive_curve", "1.2]]", "1.1]]"), ("drive_curve", "_rpm = 1500", "_rpm = 1400"),
    ("drive_curve", "_rpm = 1500", "_rpm = 1600"), ("drive_curve", "4e-4", "4.1e-4"),
    ("drive_rms_limit", "rms_nm = 2.2", "rms_nm = 2.19"), ("drive_rms_limit", "rms_nm = 2.2", "rms_nm = 2.21"),
    ("drive_rms_limit", "viscous_n_s_m = 40", "viscous_n_s_m = 41"),
    ("drive_rms_no", "rms_nm = 2.2", "rms_nm = 2.5"), ("drive_rms_no", "torque_nm = 4.0", "torque_nm = 4.4"),
    ("drive_no", "torque_nm = 3.6", "torque_nm = 4.4"), ("drive_no", "load_mass_kg = 8", "load_mass_kg = 5"),
    ("drive_relative", "deg_per_rev = 36", "deg_per_rev = 36.1"), ("drive_repeat", "repeat = 3", "repeat = 2"),
    ("drive_repeat", "friction_lbf = 3", "friction_lbf = 3.1"), ("drive_repeat", "lbf_in = 3", "lbf_in = 2.9"),
    ("drive_prescribed", "[2500, 0.5]", "[2500, 0.1]"), ("drive_prescribed", "rms_nm = 0.5", "rms_nm = 0.2"),
    ("drive_prescribed", "friction_n = 12", "friction_n = 13"),
    ("drive_prescribed_no", "torque_nm = 0.3", "torque_nm = 3"),
    ("free", "to = 0.3", "to = 0.31"), ("free", "to = 1\n", "to = 1.01\n"), ("free_law", "to_mm = 14", "to_mm = 13.9"),
    ("free_law", "angle_deg = 155\n", "angle_deg = 155\nto = 0.1\n"), ("free_cases", "to = 0.3", "to = 0.31"),
    ("free_cases", "m_s2 = 8", "m_s2 = 8.1"), ("free_within", "acceleration = 10", "acceleration = 9.9"), ("free_no", "m_s2 = 1\n", "m_s2 = 8\n"),
    ("free_drive", "torque_nm = 0.55", "torque_nm = 0.54"), ("free_drive", "torque_nm = 0.55", "torque_nm = 0.56"),
    ("free_drive", "mass_kg = 8", "mass_kg = 8.1"), ("free_drive_cases", "0.58]", "0.57]"), ("free_drive_cases", "0.58]", "0.585]"),
    ("free_drive_peak", "motor_torque = 0.3", "motor_torque = 0.31"), ("free_drive_peak", "force_n = 30", "force_n = 31"),
    ("free_drive_peak", "to = 0.3", "to = 0.31"), ("free_drive_rms", "rms = 0.3", "rms = 0.31"), ("free_drive_rms", "s_m = 40", "s_m = 41"),
    ("free_drive_rms", "nm = 1\n", "nm = 0.99\n"), ("free_drive_no", "nm = 0.3", "nm = 0.5"), ("free_drive_rms_no", "nm = 0.2", "nm = 0.5"),
    ("free_drive_sine_no", "nm = 0.32", "nm = 0.34"), ("free_drive_sine_no", "load_mass_kg = 8", "load_mass_kg = 7.5"),
    ("free_area", "area = 0.3", "area = 0.31"), ("free_area", "to = 0.3", "to = 0.31"), ("free_area_law", "area = 0.3", "area = 0.29"),
    ("free_area_law", "asymmetric_parabolic", "parabolic"), ("free_area_law", "to_mm = 14", "to_mm = 13.9"),
    ("free_corridor", "max = 12", "max = 11.9"), ("free_corridor", "max = 12", "max = 12.1"),
    ("free_corridor_law", "min = 20", "min = 20.1"), ("free_corridor_law", "min = 20", "min = 19.9"),
    ("free_velocity_law", "max = -0.1", "max = -0.11"), ("free_velocity_law", "max = -0.1", "max = -0.09"),
    ("free_cam", "angle_deg = 17", "angle_deg = 16.9"),
    ("free_cam", "radius = 0.1", "radius = 0.11"), ("angles_side", "min = -4.6", "min = -4.5"), ("angles_side", "min = -4.6", "min = -4.7"),
    ("angles_side_no", "min = -1", "min = -3"),
    ("angles", "max = 50", "max = 30"), ("angles", "to = 0.05", "to = 0.06"), ("angles", "jerk_m_s3 = 150", "jerk_m_s3 = 140"),
    ("angles", "angle_deg = 60\nto = 0\n", "angle_deg = 59\nto = 0\n"), ("angles_one", "velocity = 0.2", "velocity = 0.21"),
    ("angles_no", "jerk_m_s3 = 60", "jerk_m_s3 = 100"), ("angles_no", "max = 150", "max = 152"),
    ("curve", "jerk = 80", "jerk = 81"), ("curve", "velocity = 0.5", "velocity = 0.51"), ("curve_jerk", "velocity = 1.8", "velocity = 1.81"),
    ("curve_no", "jerk = 60", "jerk = 90"), ("curve_no", "velocity = 1.5", "velocity = 1.7"),
    ("nearest", "4.65,", "4.652,"), ("nearest", "50, 40, 30", "50, 40.01, 30"), ("nearest", "m_s2 = 18.6", "m_s2 = 18.5"),
    ("nearest", "use = \"nearest\"", "use = \"nearest\"\nnorm = \"rms\""), ("nearest_rms", "4.65,", "4.652,"),
    ("nearest_rms", "12, 11.91", "12.1, 11.91"),
    ("nearest_rms", "m_s2 = 18.6", "m_s2 = 18.5"), ("nearest_lobe", "deg = 180 }", "deg = 180.1 }"), ("nearest_lobe", "= 0.002", "= 0.0021"),
    ("nearest_lobe", "step_deg = 7.5", "step_deg = 7.51"), ("nearest_lobe_rms", "rms = 0.5", "rms = 0.51"),
    ("nearest_lobe_rms", "deg = 180 }", "deg = 179.9 }"),
]

# (scene, what stands in its scene.toml, what it is replaced by, what the checker names): it says nothing of what it does not know.
UNKNOWN = [
    ("drive_no", "[drive]\n", "[drive]\nbacklash_deg = 1\n", "drive.backlash_deg"), ("drive_no", "[drive]\n", "[brake]\n[drive]\n", "[brake]"),
    ("drive_no", "motor_torque_nm", "motor_power_w", "limits.motor_power_w"), ("drive_no", "motor_torque_rms", "motor_heat", "motor_heat"),
    ("drive_no", "[limits]\n", "[limits]\npressure_angle_deg = 30\n", "limits.pressure_angle_deg"),
    ("drive_no", "[limits]\n", "[limits]\nspring_harmonic_um = 20\n", "limits.spring_harmonic_um"),
    ("drive_no", "[spline]\n", "[spline]\ntension = 1\n", "spline.tension"),
    ("nearest", 'use = "nearest"', 'use = "nearest"\noutliers = "exclude"', "rows are left out"),
]
