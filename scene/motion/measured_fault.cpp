// SPDX-License-Identifier: MIT
// Validation of a measured motion: enough rows, ascending angles over the whole motion, the displacements of
// the scene.
#include "scene/cost_table.hpp"
#include "scene/faults/scene_faults.hpp"
#include "scene/part_names.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

// Fewer rows are not a measurement.
constexpr std::size_t least_rows = 8, most_rows = 1000000;
// Of the lift: tolerance between a table and the displacements of the scene.
constexpr double wrong_lift = 0.05;
// Of the motion's angle: tolerance at the ends of the table.
constexpr double missing_end = 0.01;

/// Displacements in lifts given by the scene, at angles in rad from the start.
std::vector<std::pair<double, double>> given_displacements(const MotionSpec& motion) {
    if (motion.type == MotionType::drd) return {{0.0, 0.0}, {motion.rise, 1.0}};
    if (motion.type == MotionType::rr)
        return {{0.0, 0.0}, {motion.rise, 1.0}, {motion.length() * motion.rise, 0.0}};
    std::vector<std::pair<double, double>> all = {{0.0, 0.0}};
    double angle = 0.0;
    for (const ProgramSegment& segment : motion.segments) {
        angle += segment.angle;
        if (segment.to) all.emplace_back(angle, *segment.to);
    }
    return all;
}

class MeasuredCheck {
 public:
    explicit MeasuredCheck(const Scene& scene)
        : motion_(scene.motion),
          table_(*scene.measured),
          lengths_(scene.length_unit),
          whole_(motion_.length() * motion_.unit_angle()) {}

    [[nodiscard]] Fault fault() const {
        if (Fault fault = rows_fault()) return fault;
        if (Fault fault = ends_fault()) return fault;
        return table_.given ? std::nullopt : lift_fault();
    }

 private:
    const MotionSpec& motion_;
    const MeasuredMotion& table_;
    LengthUnit lengths_;
    double whole_;  ///< rad

    [[nodiscard]] std::string shown(double displacement) const {
        return motion_.lift_is_angle ? angle_text(displacement) : length_text(displacement, lengths_);
    }
    [[nodiscard]] static std::string member(const char* column, std::size_t row) {
        return entry_key(joined_key("measured", column), row);
    }

    [[nodiscard]] Fault rows_fault() const {
        const std::size_t rows = table_.angle.size();
        if (rows != table_.displacement.size())
            return SceneFault{"measured.s",
                              fmt::format("{} displacements for {} angles", table_.displacement.size(), rows),
                              "as many displacements as angles"};
        if (rows < least_rows || rows > most_rows)
            return SceneFault{"measured.theta", fmt::format("{} rows", rows),
                              fmt::format("{} to {} rows", least_rows, most_rows)};
        for (std::size_t i = 0; i < rows; ++i) {
            if (!std::isfinite(table_.angle[i]))
                return SceneFault{member("theta", i), fmt::format("{}", table_.angle[i]), "a finite number"};
            if (!std::isfinite(table_.displacement[i]))
                return SceneFault{member("s", i), fmt::format("{}", table_.displacement[i]),
                                  "a finite number"};
            if (i > 0 && !(table_.angle[i] > table_.angle[i - 1]))
                return SceneFault{
                    member("theta", i),
                    fmt::format("{} after {}", angle_text(table_.angle[i]), angle_text(table_.angle[i - 1])),
                    "ascending angles"};
        }
        return std::nullopt;
    }

    /// Rows beyond the motion are allowed. A periodic motion goes on after its last row: to its first.
    [[nodiscard]] Fault ends_fault() const {
        const std::vector<double>& angle = table_.angle;
        double slack = missing_end * whole_;
        if (motion_.periodic())
            for (std::size_t i = 1; i < angle.size(); ++i)
                slack = std::max(slack, (1.0 + missing_end) * (angle[i] - angle[i - 1]));
        if (angle.front() > slack)
            return SceneFault{member("theta", 0), angle_text(angle.front()),
                              "0 deg, the start of the motion"};
        if (angle.back() < whole_ - slack)
            return SceneFault{member("theta", angle.size() - 1), angle_text(angle.back()),
                              fmt::format("{}, the end of the motion", angle_text(whole_))};
        return std::nullopt;
    }

    /// Against the scene's displacements, at the row nearest to each.
    [[nodiscard]] Fault lift_fault() const {
        const auto given = given_displacements(motion_);
        double largest = 0.0;
        for (const auto& [angle, lifts] : given) largest = std::max(largest, std::abs(lifts));
        const double slack = wrong_lift * largest * motion_.lift;
        for (const auto& [place, lifts] : given) {
            // The first row of a closed motion is its end, too.
            const bool closes = motion_.periodic() && !motion_.relative && place > table_.angle.back();
            const double angle = closes ? place - whole_ : place;
            const auto after = std::ranges::lower_bound(table_.angle, angle);
            auto row = static_cast<std::size_t>(after - table_.angle.begin());
            row = std::min(row, table_.angle.size() - 1);
            if (row > 0 && angle - table_.angle[row - 1] < table_.angle[row] - angle) --row;
            const double wanted = lifts * motion_.lift;
            if (std::abs(table_.displacement[row] - wanted) > slack)
                return SceneFault{
                    member("s", row),
                    fmt::format("{} at {}", shown(table_.displacement[row]), angle_text(table_.angle[row])),
                    fmt::format("{}, to {}: what the scene requires at {}", shown(wanted), shown(slack),
                                angle_text(place))};
        }
        return std::nullopt;
    }
};

/// A given cam leaves nothing to choose.
Fault choice_fault(const Scene& scene) {
    const auto refuse = [](const std::string& member, const std::string& found) {
        return SceneFault{member, found + " with measured.use = \"given\"",
                          "a number: nothing of a given cam is searched"};
    };
    if (searches_angles(scene)) return refuse("motion.segments", "angles that are ranges");
    if (scene.objective.sought) return refuse(scene.objective.sought->member(), "a number that is sought");
    if (scene.forces && scene.forces->is_chosen()) return refuse("forces", "a spring that is a range");
    if (scene.cam)
        for (const CamDimension& dimension : scene.cam->dimensions)
            if (dimension.value.is_variable()) return refuse("cam." + dimension.name, "a range");
    return std::nullopt;
}

}  // namespace

Fault measured_fault(const Scene& scene) {
    if (scene.is_given())
        if (Fault fault = choice_fault(scene)) return fault;
    if (scene.cam && !scene.cam->pieces.empty() && !scene.is_given())
        return SceneFault{"cam.piece", "pieces of a cam without a given motion",
                          "only with [measured] use = \"given\""};
    if (scene.measured && scene.motion.prescribed() && !scene.is_given())
        return SceneFault{"measured", "a measured motion in a prescribed program",
                          "a program with at least one segment of kind \"spline\", which is fitted to it"};
    for (const ResponseTerm& term : response_terms())
        if (!scene.measured && term.needs_measured() && term.weight_in(scene.objective) > 0.0)
            return SceneFault{fmt::format("objective.{}", term.name), "a weight > 0 without [measured]",
                              "0, or a table [measured] to deviate from"};
    if (!scene.measured) return std::nullopt;
    return MeasuredCheck(scene).fault();
}

}  // namespace camopt
