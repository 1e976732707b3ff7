// SPDX-License-Identifier: MIT
#include "objectives/scene_model.hpp"
#include "scene/part_names.hpp"
#include "studies/delivered/delivered_audit.hpp"
#include "studies/delivered/scene_limits.hpp"
#include "studies/delivered/solution_parts.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// At so many places between its ends a stroke is looked at.
constexpr int places_of_stroke = 200;
constexpr std::array<const char*, 4> derivative = {"y", "y'", "y''", "y'''"};

class Audit {
 public:
    Audit(const Solution& solution, double tolerance)
        : solution_(solution),
          scene_(solution.scene),
          motion_(solution.output_motion()),
          tolerance_(tolerance) {
        const Peaks& peaks = solution.motion_peaks;
        size_ = {1.0, peaks.velocity.value, peaks.acceleration.value, peaks.jerk.value};
        for (const SegmentReport& segment : solution.segments)  // where a law has an impulse
            if (segment.curve && !std::isfinite(size_[3])) size_[3] = peaks_of(*segment.curve).jerk.value;
        for (double& size : size_)  // a motion that stands still
            if (!(size > 0.0 && std::isfinite(size))) size = 1.0;
    }

    void look_at_ends() {
        const MotionType type = scene_.motion.type;
        ends(false, 0.0);
        ends(true, type == MotionType::drd ? 1.0 : 0.0);
        if (type == MotionType::rr) {
            wants({1.0, Side::right}, 0, 1.0, "top of the rise");
            wants({1.0, Side::right}, 1, 0.0, "top of the rise");
        }
    }

    void look_at_program() {
        const std::vector<ProgramSegment>& segments = scene_.motion.segments;
        const std::size_t count = segments.size();
        wants({motion_.begin(), Side::right}, 0, 0.0, "start");
        for (std::size_t i = 0; i < count; ++i) {
            const ChainPart& part = motion_.parts()[i];
            const std::string name = segment_key(i);
            if (segments[i].to) wants({part.end, Side::left}, 0, *segments[i].to, name + ".to");
            const bool last = i + 1 == count;
            if (!last || scene_.motion.periodic())
                joins(name, {part.end, last ? motion_.begin() : part.end},
                      continuity(segments[i], segments[last ? 0 : i + 1]));
        }
        if (scene_.motion.periodic()) return;
        if (segments.front().kind == SegmentKind::spline) ends(false, 0.0);
        if (segments.back().kind == SegmentKind::spline)
            ends(true, motion_.at(motion_.end(), Side::left).derivative[0]);
    }

    void look_at_set_points() {
        for (const SetPointReport& report : set_point_reports(scene_.motion, scene_.spline.degree, motion_)) {
            const auto order = static_cast<std::size_t>(report.order);
            const double size = std::max(size_[order], report.size);
            if (report.distance <= tolerance(order) * size) continue;
            keep({fmt::format("{}: it is {:.9g} {} at x = {:.6g}",
                              words_of(scene_.motion, report.point, report.order), report.found, report.unit,
                              report.at),
                  report.distance / size, report.at},
                 order);
        }
    }

    /// Each stroke in the range of motion.within_lift; one whose displacement is free between its own ends.
    void look_at_strokes() {
        const bool held = scene_.motion.within_lift || scene_.motion.monotone;
        if (!held || !missed_.empty()) return;  // of a motion that is none of the scene's there is no stroke
        for (const StrokeRange& stroke : strokes_of(scene_, *family_of(solution_))) {
            const bool open = stroke.is_free();
            if (open && stroke.has_points) continue;
            const double from = motion_.at(stroke.begin, Side::right).derivative[0];
            const double to = motion_.at(stroke.end, Side::left).derivative[0];
            const double least = open ? std::min(from, to) : stroke.least;
            const double most = open ? std::max(from, to) : stroke.most;
            for (int k = 0; k <= places_of_stroke; ++k) {
                const double x = stroke.begin + (stroke.end - stroke.begin) * k / places_of_stroke;
                const double y = motion_.at(x, k < places_of_stroke ? Side::right : Side::left).derivative[0];
                const double outside = std::max({0.0, least - y, y - most});
                if (outside <= tolerance(0)) continue;
                keep({fmt::format("motion.within_lift: y = {:.9g} at x = {:.6g}", y, x), outside, x});
            }
        }
    }

    /// Polynomials on mirrored segments: where they agree at degree + 1 places, they are the same.
    void look_at_symmetry() {
        if (!scene_.motion.symmetric) return;
        const bool rise = scene_.motion.type == MotionType::drd;
        const std::vector<double> points = motion_.breakpoints();
        const int places = scene_.spline.degree + 1;
        for (std::size_t i = 0; 2 * i + 1 < points.size(); ++i) {
            for (int k = 0; k < places; ++k) {
                const double x = points[i] + (points[i + 1] - points[i]) * k / places;
                const double here = motion_.at(x).derivative[0];
                const double there = motion_.at(motion_.end() - x).derivative[0];
                keep({"motion.symmetric", rise ? here + there - 1.0 : here - there, x});
            }
        }
    }

    void look_at_rest() {
        const char* const key = scene_.rest_order() == 3 ? "spline.end_jerk" : "spline.rest";
        for (const RestFigure& rest : rest_figures(scene_, motion_))
            keep({fmt::format("derivative {} = 0 at x = {:.6g} ({}): it is {:.9g}", rest.order, rest.at, key,
                              rest.worst),
                  rest.worst / rest.size, rest.at},
                 3);
    }

    [[nodiscard]] std::vector<ConditionMiss> missed() && {
        std::ranges::stable_sort(missed_, std::greater{}, &ConditionMiss::relative);
        return std::move(missed_);
    }

 private:
    const Solution& solution_;
    const Scene& scene_;
    const MotionChain& motion_;
    double tolerance_;
    std::array<double, 4> size_{};
    std::vector<ConditionMiss> missed_;

    struct Place {
        double x = 0.0;
        Side side = Side::right;
    };

    /// y''' is a difference over the cube of the segments' width: judged as the joints inside the spline are.
    [[nodiscard]] double tolerance(std::size_t order) const {
        return order < 3 ? tolerance_ : std::max(tolerance_, largest_joint_jump);
    }

    void keep(ConditionMiss miss, std::size_t order = 0) {
        miss.relative = std::abs(miss.relative);
        if (!(miss.relative <= tolerance(order))) missed_.push_back(std::move(miss));  // NaN is missed
    }

    void wants(const Place& place, std::size_t order, double value, const std::string& name) {
        const double found = motion_.at(place.x, place.side).derivative[order];
        const double size = std::max(size_[order], std::abs(value));
        if (std::abs(found - value) <= tolerance(order) * size) return;
        keep({fmt::format("{} = {:.6g} at x = {:.6g} ({}): it is {:.9g}", derivative[order], value, place.x,
                          name, found),
              (found - value) / size, place.x},
             order);
    }

    /// At rest, or with the state the scene gives.
    void ends(bool at_end, double displacement) {
        const Place place = at_end ? Place{motion_.end(), Side::left} : Place{motion_.begin(), Side::right};
        const char* const name = at_end ? "end" : "beginning";
        const std::array<double, 2> state = end_velocities(scene_.motion, at_end);
        wants(place, 0, displacement, name);
        wants(place, 1, state[0], name);
        wants(place, 2, state[1], name);
    }

    /// The highest derivative that two neighbours share; laws promise their displacement.
    [[nodiscard]] int continuity(const ProgramSegment& one, const ProgramSegment& next) const {
        const bool spline = one.kind == SegmentKind::spline, more = next.kind == SegmentKind::spline;
        if (spline && more) return std::min(scene_.spline.smoothness(), 3);
        return spline || more ? 2 : 0;
    }

    void joins(const std::string& name, const std::array<double, 2>& x, int highest) {
        const MotionPoint before = motion_.at(x[0], Side::left), after = motion_.at(x[1], Side::right);
        const bool goes_on = scene_.motion.relative && x[1] < x[0];  // from the displacement it has reached
        for (std::size_t order = goes_on ? 1 : 0; static_cast<int>(order) <= highest; ++order)
            keep({fmt::format("{} continuous at the end of {}", derivative[order], name),
                  (before.derivative[order] - after.derivative[order]) / size_[order], x[0]},
                 order);
    }
};

}  // namespace

std::vector<ConditionMiss> missed_conditions(const Solution& solution, double tolerance) {
    if (!solution.motion) return {};
    Audit audit(solution, tolerance);
    if (solution.scene.motion.type == MotionType::program)
        audit.look_at_program();
    else
        audit.look_at_ends();
    audit.look_at_set_points();
    audit.look_at_symmetry();
    audit.look_at_rest();
    audit.look_at_strokes();
    return std::move(audit).missed();
}

}  // namespace camopt
