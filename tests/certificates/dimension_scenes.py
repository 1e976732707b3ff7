# SPDX-License-Identifier: MIT
"""Scenes of cams and linkages with dimensions that are searched, and changes that make what was claimed false."""
from pathlib import Path

from motion_scenes import FLAT, ROLLER

OBJECTIVE = "[spline]\nsegments = 10\n[objective]\nvelocity = 0.4\nacceleration = 0.4\njerk = 0.2\n"
PUSHED = '[motion]\ntype = "DRD"\nlift_mm = 20\nrise_deg = 80\n' + OBJECTIVE + "base_radius = 0.3\n"
BASE = ROLLER.replace("= 40", "= { min = 15, max = 80 }")
NARROW = ('[cam]\ntype = "disk"\nfollower = "translating_roller"\nbase_radius_mm = { min = 24, max = 30 }\nroller_radius_mm = 8\n'
          "offset_mm = { min = -4, max = 6 }\n")
FACE_ARM = ('[motion]\ntype = "DRD"\nlift_deg = 14\nrise_deg = 70\n' + OBJECTIVE + 'base_radius = 0.3\n[cam]\ntype = "disk"\n'
            'follower = "oscillating_flat"\nbase_radius_mm = { min = 20, max = 40 }\ncenter_distance_mm = 70\nface_offset_mm = 6\n')
SWING = '[motion]\ntype = "DRD"\nlift_deg = 20\nrise_deg = 40\n' + OBJECTIVE
LEVER = ('[cam]\ntype = "remote"\nroller_radius_mm = 10\nroller_arm_mm = 45\nlever_pivot_x_mm = 80\nlever_pivot_y_mm = 0\n[linkage]\n'
         'type = "lever"\noutput_angle_deg = 114\n')
SHAPE = "[limits]\npressure_angle_deg = 30\ncam_radius_min_mm = 10\n"
CONTACT = (SWING.replace("= 40", "= 45") + "roller_radius = 0.2\n" +
           LEVER.replace("= 10\n", "= { min = 5, max = 8 }\n", 1).replace("114", "118")
           .replace("[linkage]", 'pressure_angle_at = "contact_point"\n[linkage]') + "[limits]\npressure_angle_deg = 34\n")
FEEDER = (Path(__file__).resolve().parents[2] / "scenes" / "inverse_feeder.toml").read_text().replace(
    "radius_in = 0.5", "radius_in = { min = 0.4, max = 0.6 }").replace("distance_in = 15", "distance_in = { min = 14.9, max = 15.1 }")

# Name: (scene, verdict).
TEXTS = {
    "offset_searched": (PUSHED + BASE + "offset_mm = { min = -10, max = 12 }\n[limits]\npressure_angle_deg = 20\n", "optimal"),
    "offset_weighed": (PUSHED + "offset = 0.05\n" + BASE + "offset_mm = { min = -12, max = 12 }\n[limits]\npressure_angle_deg = 30\n",
                       "optimal"),
    "offset_margin": (PUSHED.replace("80", "55") + "offset = 0.1\n" + NARROW + "[limits]\nundercut_margin = 0.5\npressure_angle_deg = 40\n",
                      "optimal"),
    "offset_no": (PUSHED.replace("80", "50") + NARROW + "[limits]\nundercut_margin = 0.5\npressure_angle_deg = 27\n", "infeasible"),
    "face_margin": ('[motion]\ntype = "RR"\nlift_mm = 8\nrise_deg = 60\n' + OBJECTIVE + "base_radius = 0.1\n" + FLAT +
                    "base_radius_mm = { min = 10, max = 60 }\n[limits]\nundercut_margin = 0.2\n", "optimal"),
    "face_arm": (FACE_ARM + "[limits]\nundercut_margin = 0.45\n", "optimal"),
    "face_arm_offset": (FACE_ARM.replace("offset_mm = 6", "offset_mm = { min = 0, max = 5 }") + "[limits]\ncam_radius_min_mm = 12\n",
                        "optimal"),
    "lever_searched": (SWING + "roller_radius = 0.05\n" + LEVER.replace("= 45", "= { min = 45, max = 46 }")
                       .replace("= 10\n", "= { min = 8, max = 12 }\n", 1) + SHAPE, "optimal"),
    "lever_turned": (SWING + LEVER.replace("= 114", "= { min = 114, max = 115 }") + SHAPE, "optimal"),
    "lever_rest": (SWING + LEVER.replace("= 45", "= 60").replace("114", "155") + SHAPE, "infeasible"),
    "contact_point": (CONTACT, "optimal"),
    "feeder_searched": (FEEDER, "optimal"),
}

# (scene, what is in its scene.toml, what it is replaced by): the files then claim what is not so.
CHANGES = [
    ("offset_searched", "angle_deg = 20", "angle_deg = 19.9"), ("offset_searched", "angle_deg = 20", "angle_deg = 20.1"),
    ("offset_searched", "max = 12", "max = 2"), ("offset_searched", "rise_deg = 80", "rise_deg = 80.1"),
    ("offset_searched", "base_radius = 0.3", "base_radius = 0.31"), ("offset_weighed", "offset = 0.05", "offset = 0.051"),
    ("offset_weighed", "offset = 0.05", "offset = 0.049"), ("offset_weighed", "radius_mm = 10", "radius_mm = 9.9"),
    ("offset_margin", "margin = 0.5", "margin = 0.52"), ("offset_margin", "angle_deg = 40", "angle_deg = 41"),
    ("offset_margin", "offset = 0.1", "offset = 0.09"), ("offset_no", "angle_deg = 27", "angle_deg = 40"), ("offset_no", "max = 6", "max = 16"),
    ("face_margin", "margin = 0.2", "margin = 0.19"), ("face_margin", "margin = 0.2", "margin = 0.21"),
    ("face_arm", "margin = 0.45", "margin = 0.46"), ("face_arm", "margin = 0.45", "margin = 0.42"),
    ("face_arm", "base_radius = 0.3", "base_radius = 0.29"), ("face_arm_offset", "max = 5", "max = 7"),
    ("face_arm_offset", "min_mm = 12", "min_mm = 12.1"), ("face_arm_offset", "min_mm = 12", "min_mm = 11.5"),
    ("lever_searched", "max = 46", "max = 45.9"), ("lever_searched", "radius = 0.05", "radius = 0.04"), ("lever_searched", "angle_deg = 30", "angle_deg = 29.9"),
    ("lever_searched", "angle_deg = 30", "angle_deg = 31"), ("lever_turned", "angle_deg = 30", "angle_deg = 31"),
    ("lever_turned", "min = 114", "min = 114.1"), ("lever_rest", "output_angle_deg = 155", "output_angle_deg = 114"),
    ("contact_point", '"contact_point"', '"roller_center"'), ("contact_point", "angle_deg = 34", "angle_deg = 33.9"),
    ("contact_point", "angle_deg = 34", "angle_deg = 34.5"), ("contact_point", "radius = 0.2", "radius = 0.19"),
    ("feeder_searched", "max = 15.1", "max = 15.05"), ("feeder_searched", "angle_deg = 10", "angle_deg = 9.9"),
    ("feeder_searched", "angle_deg = 10", "angle_deg = 10.5"),
]
