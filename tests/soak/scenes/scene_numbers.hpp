// SPDX-License-Identifier: MIT
// What a scene text says, in SI units and radians, read by the table of docs/scene_file.md and not by the
// library.
#pragma once

#include "tests/soak/scenes/scene_text.hpp"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace camopt::soak {

enum class Kind { motion, cam };

/// Keys of the peaks, by order of derivative.
inline constexpr const char* peak_names[] = {"", "velocity", "acceleration", "jerk"};

struct Range {
    double low = 0.0, high = 0.0;
    [[nodiscard]] bool is_variable() const { return high > low; }
    [[nodiscard]] double middle() const { return (low + high) / 2; }
};

struct Segment {
    std::string kind, law;
    double angle = 0.0;
    std::optional<double> to;  ///< in lifts
};

struct ViaPoint {
    double at = 0.0;
    std::array<std::optional<double>, 3> value;  ///< y, y', y''
};

/// An elastic follower: one mass on its spring and damper, SI.
struct Train {
    double mass = 0.0, stiffness = 0.0, damping = 0.0, preload = 0.0;
};

/// A cap on a peak: on the normalised one, or in time (SI).
struct Cap {
    double value = 0.0;
    bool in_time = false;
};

struct SceneNumbers {
    std::string type;  ///< "DRD", "RR", "program"
    double lift = 1e-3;
    bool swings = false;
    double rise = 3.14159265358979323846, back = 0.0, speed = 0.0;  ///< rad, rad, rad/s; 0: none
    bool symmetric = false, closed = true;
    std::vector<ViaPoint> via;
    std::vector<Segment> segments;

    int degree = 3, continuity = 2, spline_segments = 12;
    std::vector<double> breakpoints;
    bool free_knots = false, end_jerk_zero = false;
    std::string design;

    std::map<std::string, double> weights;  ///< every weight above 0
    std::string reference_law;              ///< empty: numbers
    std::map<std::string, double> references;

    std::string follower;  ///< empty: no cam
    double sense = 1.0;    ///< +1 counterclockwise
    std::map<std::string, Range> dimensions;
    std::optional<double> face_half_width;
    std::optional<Train> train;
    std::map<std::string, double> forces;  ///< mass, spring_rate, preload, contact_width, compliance

    std::array<std::optional<Cap>, 4> caps;  ///< by order of derivative
    std::map<std::string, double> limits;    ///< those of the cam and of the train
    double tolerance = 1e-9, max_seconds = 60.0;
    std::optional<double> gap;  ///< as written

    [[nodiscard]] bool is_program() const { return type == "program"; }
    [[nodiscard]] double length() const { return type == "RR" ? 1.0 + back / rise : 1.0; }
    [[nodiscard]] bool rolls() const { return follower.ends_with("roller"); }
    [[nodiscard]] bool is_flat() const { return follower.ends_with("flat"); }
    [[nodiscard]] double weight(const std::string& term) const;
};

[[nodiscard]] SceneNumbers numbers_of(const SceneText& text);

/// The unit that ends a key ("_mm", "_deg", …) in SI; 1 where none does.
[[nodiscard]] double unit_of(std::string_view key);
/// The key of a quantity as this table spells it ("lift_mm" for "lift"); empty: it does not have it.
[[nodiscard]] std::string spelled(const SceneTable& table, std::string_view quantity);

}  // namespace camopt::soak
