// SPDX-License-Identifier: MIT
#include "output/words/cam_words.hpp"

#include "core/units.hpp"
#include "output/words/angle_words.hpp"
#include "output/words/number_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

namespace camopt {

namespace {

using units::degree, units::millimetre;

constexpr double no_radius = 1e9;  // m: what is straighter than this is straight

double millimetres(double metres) {
    return metres / millimetre;
}

std::optional<double> delivered(const Solution& solution, DimensionIndex which) {
    if (solution.cam) return millimetres(solution.cam->cam[which]);
    const Dimension& dimension = (*solution.scene.cam)[which];
    if (dimension.is_variable()) return {};
    return millimetres(dimension.low);
}

std::optional<double> prime_radius(const Solution& solution) {
    const std::optional<double> base = delivered(solution, DimensionIndex::base_radius);
    const std::optional<double> roller = delivered(solution, DimensionIndex::roller_radius);
    if (!base || !roller) return {};
    return *base + *roller;
}

/// Collects figures of one solution.
class Figures {
 public:
    explicit Figures(const Solution& solution)
        : degrees_per_x_(solution.scene.motion.unit_angle() / degree) {}

    void add(std::string name, const CamExtreme& extreme, double unit, std::string_view unit_name) {
        if (std::isinf(extreme.value)) {
            all_.push_back(
                {std::move(name), no_contact_words, short_text(degrees_per_x_ * extreme.at, angle_digits)});
            return;
        }
        all_.push_back(
            {std::move(name),
             fmt::format("{}{}{}", short_text(extreme.value / unit), unit_name.empty() ? "" : " ", unit_name),
             short_text(degrees_per_x_ * extreme.at, angle_digits)});
    }
    [[nodiscard]] std::vector<CamFigure> take() { return std::move(all_); }

 private:
    double degrees_per_x_;
    std::vector<CamFigure> all_;
};

void add_geometry(Figures& figures, const CamReport& cam, bool returns) {
    const CamSummary& summary = cam.summary;
    figures.add("largest pressure angle", summary.pressure_angle, degree, "deg");
    if (returns) {
        figures.add("on the rise", summary.rise_pressure_angle, degree, "deg");
        figures.add("on the return", summary.return_pressure_angle, degree, "deg");
    }
    if (const auto radius = convex_radius(summary))
        figures.add("least convex radius of the cam", *radius, millimetre, "mm");
    if (summary.concave_radius)
        figures.add("least concave radius of the cam", *summary.concave_radius, millimetre, "mm");
    if (has_flat_face(cam.cam.follower))
        figures.add("largest contact offset on the face", summary.contact_offset, millimetre, "mm");
    if (!has_edge(cam.cam.follower))
        figures.add("least regularity (0: undercut)", summary.regularity, 1.0, "");
}

void add_forces(Figures& figures, const CamReport& cam) {
    if (!cam.summary.forces) return;
    const ForceSummary& forces = *cam.summary.forces;
    const bool swings = is_oscillating(cam.cam.follower);
    const char* const what = swings ? "moment on the follower" : "force on the follower";
    const char* const unit = swings ? "N m" : "N";
    figures.add(fmt::format("least {}", what), forces.least_force, 1.0, unit);
    figures.add(fmt::format("largest {}", what), forces.largest_force, 1.0, unit);
    figures.add("largest camshaft torque", forces.torque, 1.0, "N m");
    if (forces.normal_force) figures.add("largest force along the normal", *forces.normal_force, 1.0, "N");
    if (forces.hertz_pressure)
        figures.add("largest Hertz pressure", *forces.hertz_pressure, units::megapascal, "MPa");
}

}  // namespace

std::vector<DimensionValue> cam_dimensions(const Solution& solution) {
    const auto follower = solution.scene.cam->follower;
    std::vector<DimensionValue> all;
    for (int i = 0; i < dimension_count; ++i) {
        const auto which = static_cast<DimensionIndex>(i);
        if (has_dimension(follower, which)) all.push_back({name_of(which), delivered(solution, which)});
    }
    all.push_back({"prime_radius", prime_radius(solution)});
    return all;
}

std::string dimensions_text(const Solution& solution) {
    std::string text;
    for (const DimensionValue& dimension : cam_dimensions(solution))
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", words_of(dimension.name),
                            dimension.millimetres ? short_text(*dimension.millimetres) + " mm" : "free");
    return text;
}

std::string follower_text(const CamSpec& cam) {
    return fmt::format("{}, the cam turning {}", words_of(name_of(cam.follower)), name_of(cam.rotation));
}

std::optional<CamExtreme> convex_radius(const CamSummary& summary) {
    if (std::abs(summary.convex_radius.value) < no_radius) return summary.convex_radius;
    return {};
}

std::vector<CamFigure> cam_figures(const Solution& solution) {
    Figures figures(solution);
    add_geometry(figures, *solution.cam, solution.cam->summary.return_pressure_angle.value > 0.0);
    add_forces(figures, *solution.cam);
    return figures.take();
}

}  // namespace camopt
