// SPDX-License-Identifier: MIT
#include "shop/nc/milling/plane_passes.hpp"

#include "shop/nc/milling/offset_line.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr int contour_samples = 1440;   // around the contour, for its extent
constexpr double same_knot = 1e-6;      // rad: two knots nearer than that are one
constexpr double beyond_safe = 1e-4;    // m: so that printed digits do not matter
constexpr double shortest_line = 1e-3;  // m, of the way in; under compensation beside the cutter's radius

Eigen::Vector2d left(const Eigen::Vector2d& v) {
    return {-v.y(), v.x()};
}

/// The contour as the tool runs along it: u = 0 where it is farthest from the cam's axis.
class Round {
 public:
    Round(const PlaneMilling& milling, bool tool_clockwise) : contour_(milling.contour) {
        const double begin = milling.knots.front(), end = milling.knots.back();
        period_ = end - begin;
        double area = 0.0, farthest = -1.0;
        Eigen::Vector2d before = contour_(begin).position;
        for (int k = 1; k <= contour_samples; ++k) {
            const double theta = begin + period_ * k / contour_samples;
            const Eigen::Vector2d here = contour_(theta).position;
            area += before.x() * here.y() - before.y() * here.x();
            if (here.norm() > farthest * (1.0 + 1e-12)) {
                farthest = here.norm();
                start_ = theta;
            }
            before = here;
        }
        begin_ = begin;
        sense_ = (area > 0.0) == tool_clockwise ? -1.0 : 1.0;
        set_knots(milling.knots);
    }

    [[nodiscard]] ContourPoint at(double u) const { return contour_(wrapped(start_ + sense_ * u)); }
    [[nodiscard]] const std::vector<double>& knots() const { return knots_; }

 private:
    [[nodiscard]] double wrapped(double theta) const {
        const double from = theta - begin_;
        return begin_ + std::clamp(from - period_ * std::floor(from / period_), 0.0, period_);
    }
    void set_knots(const std::vector<double>& thetas) {
        knots_ = {0.0, period_};
        for (const double theta : thetas) {
            double u = std::fmod(sense_ * (theta - start_), period_);
            if (u < 0.0) u += period_;
            knots_.push_back(u);
        }
        std::ranges::sort(knots_);
        const auto near = [](double a, double b) { return b - a < same_knot; };
        knots_.erase(std::unique(knots_.begin(), knots_.end(), near), knots_.end());
        if (period_ - knots_.back() < same_knot) knots_.back() = period_;
    }

    PlaneContour contour_;
    double begin_ = 0.0, period_ = 0.0, start_ = 0.0, sense_ = 1.0;
    std::vector<double> knots_;
};

class PlanePassMaker {
 public:
    explicit PlanePassMaker(const PlaneMilling& milling)
        : milling_(milling),
          clockwise_(milling.choice.climbs() == (milling.choice.spindle == SpindleSense::clockwise)),
          round_(milling, clockwise_),
          radius_(0.5 * milling.cutter.diameter),
          lead_(milling.choice.lead_radius.value_or(radius_)),
          allowance_(milling.choice.allowance(HUGE_VAL)) {}

    [[nodiscard]] MillingPasses made() {
        MillingPasses result;
        if (!milling_.choice.full_depth) add_roughing(result);
        CuttingPass finish = pass("around the cam", milling_.cutter.stock, milling_.cutter.bottom,
                                  milling_.choice.compensation == CompensationWords::control);
        if (milling_.choice.full_depth) finish.warning = full_depth_warning();
        result.passes.push_back(std::move(finish));
        describe(result.remarks);
        return result;
    }

 private:
    void describe(std::vector<std::string>& remarks) const {
        const MillingChoice& choice = milling_.choice;
        const bool right_handed = choice.spindle == SpindleSense::clockwise;
        remarks.push_back(fmt::format(
            "direction: {}, outside, the tool goes {}clockwise around the cam, spindle {}clockwise {}",
            choice.climbs() ? "climb" : "conventional", clockwise_ ? "" : "counter",
            right_handed ? "" : "counter", right_handed ? "M3" : "M4"));
        remarks.push_back(fmt::format("in and out: outside the blank, quarter circles of radius {:g} mm",
                                      lead_ / units::millimetre));
        if (choice.compensation == CompensationWords::none)
            remarks.emplace_back("compensation: none, the program is the path of the cutter's centre");
        else
            remarks.push_back(
                fmt::format("compensation: by the control in the finishing pass, which is the contour "
                            "itself; register D{} "
                            "holds the cutter's radius of {:g} mm, or its diameter, as the control requires",
                            choice.compensation_register.value_or(choice.tool_number.value_or(1)),
                            radius_ / units::millimetre));
    }

    /// What the blank has farthest from the contour.
    [[nodiscard]] double widest() const {
        double most = 0.0;
        for (int k = 0; k < contour_samples; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / contour_samples;
            most = std::max(most, -depth({milling_.blank.radius * std::cos(angle),
                                          milling_.blank.radius * std::sin(angle)},
                                         0.0));
        }
        return most;
    }
    /// Of a circle of this radius in the contour.
    [[nodiscard]] double depth(const Eigen::Vector2d& center, double radius) const {
        return depth_in_plane(*milling_.cam, center, radius);
    }

    [[nodiscard]] double height() const { return milling_.blank.upper - milling_.cutter.bottom; }
    [[nodiscard]] std::string full_depth_warning() const {
        const bool parts = widest() > milling_.cutter.stock + milling_.cutter.diameter;
        return fmt::format("the only pass {}{}", slot_words(height(), milling_.cutter.diameter),
                           parts ? ", the ring that it cuts off around the cam comes loose" : "");
    }

    void add_roughing(MillingPasses& result) {
        const MillingChoice& choice = milling_.choice;
        const double diameter = milling_.cutter.diameter, innermost = milling_.cutter.stock + allowance_;
        const double width = std::max(widest() - innermost, 0.0), height = this->height();
        const int rings =
            std::max(1, static_cast<int>(std::ceil(width / choice.step_over_of(diameter) - 1e-9)));
        const int layers = choice.layers(height, diameter);
        for (int layer = 1; layer <= layers; ++layer)
            for (int ring = rings - 1; ring >= 0; --ring) {
                const double stock = innermost + width * ring / rings;
                const double bottom = milling_.blank.upper - height * layer / layers;
                add_ring(result.passes, rough(fmt::format("roughing, layer {} of {}, ring {} of {}", layer,
                                                          layers, rings - ring, rings),
                                              stock, bottom));
            }
        result.remarks.push_back(words_of({layers, layers, height / layers, width / rings, allowance_}));
    }

    /// The runs of a ring that reach the blank. Each begins and ends where the cutter is clear of the blank,
    /// so the path itself leads in and out.
    void add_ring(std::vector<CuttingPass>& passes, const CuttingPass& ring) const {
        const std::vector<Run> runs = runs_in_blank(ring);
        if (runs.size() == 1 && runs[0].begin == 0.0 && runs[0].end == ring.knots.back())
            return passes.push_back(ring);
        for (std::size_t i = 0; i < runs.size(); ++i) {
            CuttingPass& part = passes.emplace_back(ring);
            if (runs.size() > 1) part.name += fmt::format(", part {} of {}", i + 1, runs.size());
            part.in = part.out = {};
            std::erase_if(part.knots, [&run = runs[i]](double u) {
                return u < run.begin + same_knot || u > run.end - same_knot;
            });
            part.knots.insert(part.knots.begin(), runs[i].begin);
            part.knots.push_back(runs[i].end);
        }
    }
    struct Run {
        double begin, end;
    };
    /// No part of a ring is farther from the axis than u = 0, so one that is not clear of the blank there is
    /// clear nowhere.
    [[nodiscard]] std::vector<Run> runs_in_blank(const CuttingPass& ring) const {
        const double period = ring.knots.back(), touching = milling_.blank.radius + radius_;
        Eigen::Vector3d before = ring.path(0.0).tip;
        if (before.head<2>().norm() < clear_radius()) return {{0.0, period}};
        // Up and down beside the blank is fed as well: a shorter way through air joins two runs.
        const double up_and_down = 2.0 * (milling_.blank.upper + milling_.safe_distance - before.z());
        std::vector<Run> runs;
        double clear_at = 0.0, in_air = HUGE_VAL;
        bool inside = false;
        for (int k = 0; k <= contour_samples; ++k) {
            const double u = period * k / contour_samples;
            if (!ring.keep(u)) continue;
            const Eigen::Vector3d tip = ring.path(u).tip;
            const double from_axis = tip.head<2>().norm();
            in_air += (tip - std::exchange(before, tip)).norm();
            if (from_axis < touching) {
                if (!std::exchange(inside, true) && in_air > up_and_down) runs.push_back({clear_at, period});
            } else if (from_axis >= clear_radius()) {
                clear_at = u;
                if (!std::exchange(inside, false)) continue;
                runs.back().end = u;
                in_air = 0.0;
            }
        }
        return runs;
    }
    /// The cutter's centre is so far from the axis where it keeps the safe distance from the blank.
    [[nodiscard]] double clear_radius() const {
        return milling_.blank.radius + radius_ + milling_.safe_distance + beyond_safe;
    }

    [[nodiscard]] CuttingPass rough(const std::string& name, double stock, double bottom) const {
        const double tolerance = std::max(MillingChoice::coarse_chords(allowance_), milling_.chord_tolerance);
        const double offset = stock + (allowance_ > 0.0 ? tolerance : 0.0);
        CuttingPass cut = pass(name, offset, bottom, false);
        cut.roughs = true;
        cut.stock = milling_.cutter.stock + allowance_;
        cut.chord_tolerance = tolerance;
        cut.keep = ends_of_offset([round = round_](double u) { return round.at(u); }, radius_ + offset,
                                  cut.knots.back(), milling_.cam);
        return cut;
    }

    /// edge: the program is the way of the cutter's edge.
    [[nodiscard]] CuttingPass pass(const std::string& name, double stock, double bottom, bool edge) const {
        const double offset = stock + (edge ? 0.0 : radius_);
        CuttingPass cut;
        cut.name = name;
        cut.path = [round = round_, offset, bottom](double u) {
            const ContourPoint point = round.at(u);
            const Eigen::Vector2d tip = point.position + offset * point.normal;
            return ToolPose{{tip.x(), tip.y(), bottom}, -Eigen::Vector3d::UnitZ()};
        };
        cut.knots = round_.knots();
        cut.climbs = milling_.choice.climbs();
        if (edge) cut.compensation = clockwise_ ? CompensationSide::left : CompensationSide::right;
        add_ways(cut, bottom, edge);
        return cut;
    }

    void add_ways(CuttingPass& cut, double bottom, bool edge) const {
        const Eigen::Vector2d touch = cut.path(0.0).tip.head<2>(), normal = round_.at(0.0).normal;
        const Eigen::Vector2d travel = clockwise_ ? Eigen::Vector2d(-left(normal)) : left(normal);
        const double arc = lead_ + (edge ? radius_ : 0.0);
        const MoveArc round{touch + arc * normal, !clockwise_};
        const auto pose = [bottom](const Eigen::Vector2d& tip) {
            return ToolPose{{tip.x(), tip.y(), bottom}, -Eigen::Vector3d::UnitZ()};
        };
        const auto outside = [&](const Eigen::Vector2d& from) {
            const double along = from.dot(normal);
            const double square = from.squaredNorm() - clear_radius() * clear_radius();
            const double line = square < 0.0 ? std::sqrt(along * along - square) - along : 0.0;
            return Eigen::Vector2d(from +
                                   std::max(line, shortest_line + (edge ? 2.0 * radius_ : 0.0)) * normal);
        };
        const Eigen::Vector2d begin = round.center - arc * travel, end = round.center + arc * travel;
        cut.in = {{pose(outside(begin)), pose(begin)}, round};
        cut.out = {{pose(end), pose(outside(end))}, round};
    }

    const PlaneMilling& milling_;
    bool clockwise_;
    Round round_;
    double radius_, lead_, allowance_;
};

}  // namespace

MillingPasses plane_passes(const PlaneMilling& milling) {
    milling.cutter.validate();
    milling.choice.validate(milling.cutter.diameter);
    return PlanePassMaker(milling).made();
}

}  // namespace camopt
