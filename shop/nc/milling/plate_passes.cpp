// SPDX-License-Identifier: MIT
#include "shop/nc/milling/plate_passes.hpp"

#include "shop/nc/milling/offset_line.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr int surface_samples = 1440;   // along the surface, for its extent and for runs
constexpr double beside_safe = 1e-4;    // m: so that printed digits do not matter
constexpr double switching_way = 1e-3;  // m: of the block that switches compensation, beside the cutter
constexpr double one_knot = 1e-6;       // of the path: two knots nearer than that are one

/// The surface as the tool runs along it, and on along its end tangents: v ascends, in the units of the
/// knots.
class LongSurface {
 public:
    LongSurface(const PlateMilling& milling, bool tool_to_plus_x, double beyond)
        : surface_(milling.surface), begin_(milling.knots.front()), end_(milling.knots.back()) {
        const double across = surface_(end_).position.x() - surface_(begin_).position.x();
        sense_ = (across > 0.0) == tool_to_plus_x ? 1.0 : -1.0;
        speed_ = std::abs(across) / (end_ - begin_);
        ahead_ = across > 0.0 ? 1.0 : -1.0;
        // Along a tangent that leans the cutter gets clear of the side later.
        const auto length = [&](double theta) {
            return beyond / std::max(0.1, std::abs(surface_(theta).normal.y())) / speed_;
        };
        knots_ = {begin_ - length(begin_)};
        knots_.insert(knots_.end(), milling.knots.begin(), milling.knots.end());
        knots_.push_back(end_ + length(end_));
        if (sense_ < 0.0) {
            std::ranges::reverse(knots_);
            for (double& knot : knots_) knot = -knot;
        }
    }

    [[nodiscard]] ContourPoint at(double v) const {
        const double theta = sense_ * v, inside = std::clamp(theta, begin_, end_);
        ContourPoint point = surface_(inside);
        const Eigen::Vector2d tangent(point.normal.y(), -point.normal.x());  // towards +x
        point.position += ahead_ * speed_ * (theta - inside) * tangent;
        return point;
    }
    [[nodiscard]] const std::vector<double>& knots() const { return knots_; }
    /// m of a way of this length in v.
    [[nodiscard]] double speed() const { return speed_; }

 private:
    PlaneContour surface_;
    double begin_, end_, sense_ = 1.0, ahead_ = 1.0, speed_ = 1.0;
    std::vector<double> knots_;
};

class PlatePassMaker {
 public:
    explicit PlatePassMaker(const PlateMilling& milling)
        : milling_(milling),
          // With the plate on its right the tool climbs where the spindle turns clockwise.
          to_plus_x_(milling.choice.climbs() == (milling.choice.spindle == SpindleSense::clockwise)),
          radius_(0.5 * milling.cutter.diameter),
          allowance_(milling.choice.allowance(HUGE_VAL)),
          surface_(milling, to_plus_x_, clear_distance() + 2.0 * switching_way) {}

    [[nodiscard]] MillingPasses made() {
        MillingPasses result;
        if (!milling_.choice.full_depth) add_roughing(result);
        CuttingPass finish = pass("along the surface", milling_.cutter.stock, milling_.cutter.bottom,
                                  milling_.choice.compensation == CompensationWords::control);
        if (milling_.choice.full_depth)
            finish.warning = fmt::format("the only pass {}", slot_words(height(), milling_.cutter.diameter));
        result.passes.push_back(std::move(finish));
        describe(result.remarks);
        return result;
    }

 private:
    [[nodiscard]] double height() const { return milling_.blank.upper - milling_.cutter.bottom; }
    /// From the cutter's centre to the blank, where it keeps the safe distance.
    [[nodiscard]] double clear_distance() const { return radius_ + milling_.safe_distance + beside_safe; }

    void describe(std::vector<std::string>& remarks) const {
        const MillingChoice& choice = milling_.choice;
        const bool right_handed = choice.spindle == SpindleSense::clockwise;
        remarks.push_back(
            fmt::format("direction: {}, the tool goes towards {}x along the surface, spindle "
                        "{}clockwise {}",
                        choice.climbs() ? "climb" : "conventional", to_plus_x_ ? "+" : "-",
                        right_handed ? "" : "counter", right_handed ? "M3" : "M4"));
        remarks.emplace_back("in and out: next to the blank, along the tangents at the ends of the surface");
        if (choice.compensation == CompensationWords::none)
            remarks.emplace_back("compensation: none, the program is the path of the cutter's centre");
        else
            remarks.push_back(
                fmt::format("compensation: by the control in the finishing pass, which is the surface "
                            "itself; register D{} "
                            "holds the cutter's radius of {:g} mm, or its diameter, as the control requires",
                            choice.compensation_register.value_or(choice.tool_number.value_or(1)),
                            radius_ / units::millimetre));
    }

    /// How far the blank's upper side stands off the surface, at most.
    [[nodiscard]] double widest() const {
        const Eigen::AlignedBox2d& block = milling_.blank.block.value();
        double most = 0.0;
        for (int k = 0; k <= surface_samples; ++k) {
            const double x = block.min().x() + block.sizes().x() * k / surface_samples;
            most = std::max(most, -depth_in_plane(*milling_.cam, {x, block.max().y()}, 0.0));
        }
        return most;
    }

    void add_roughing(MillingPasses& result) {
        const MillingChoice& choice = milling_.choice;
        const double diameter = milling_.cutter.diameter, innermost = milling_.cutter.stock + allowance_;
        const double width = std::max(widest() - innermost, 0.0);
        const int lines =
            std::max(1, static_cast<int>(std::ceil(width / choice.step_over_of(diameter) - 1e-9)));
        const int layers = choice.layers(height(), diameter);
        for (int layer = 1; layer <= layers; ++layer)
            for (int line = lines - 1; line >= 0; --line)
                add_line(result.passes, rough(fmt::format("roughing, layer {} of {}, line {} of {}", layer,
                                                          layers, lines - line, lines),
                                              innermost + width * line / lines,
                                              milling_.blank.upper - height() * layer / layers));
        result.remarks.push_back(words_of({layers, layers, height() / layers, width / lines, allowance_}));
    }

    /// The runs of a line that reach the blank; each begins and ends where the cutter is clear of it.
    void add_line(std::vector<CuttingPass>& passes, const CuttingPass& line) const {
        const double begin = line.knots.front(), length = line.knots.back() - begin;
        const double up_and_down =
            2.0 * (milling_.blank.upper + milling_.safe_distance - milling_.cutter.bottom);
        struct Run {
            double begin, end;
        };
        std::vector<Run> runs;
        double clear_at = begin;
        bool inside = false;
        for (int k = 0; k <= surface_samples; ++k) {
            const double v = begin + length * k / surface_samples;
            if (!line.keep(v)) continue;
            const Eigen::Vector3d tip = line.path(v).tip;
            if ((milling_.blank.nearest(tip) - tip).head<2>().norm() < clear_distance()) {
                if (std::exchange(inside, true)) continue;
                const bool near =
                    !runs.empty() && (clear_at - runs.back().end) * surface_.speed() < up_and_down;
                if (!near) runs.push_back({clear_at, line.knots.back()});
            } else {
                clear_at = v;
                if (std::exchange(inside, false)) runs.back().end = v;
            }
        }
        if (inside) runs.back().end = line.knots.back();
        for (std::size_t i = 0; i < runs.size(); ++i) {
            CuttingPass& part = passes.emplace_back(line);
            if (runs.size() > 1) part.name += fmt::format(", part {} of {}", i + 1, runs.size());
            std::erase_if(part.knots, [&run = runs[i]](double v) {
                return v < run.begin + one_knot || v > run.end - one_knot;
            });
            part.knots.insert(part.knots.begin(), runs[i].begin);
            part.knots.push_back(runs[i].end);
        }
    }

    [[nodiscard]] CuttingPass rough(const std::string& name, double stock, double bottom) const {
        const double tolerance = std::max(MillingChoice::coarse_chords(allowance_), milling_.chord_tolerance);
        const double offset = stock + (allowance_ > 0.0 ? tolerance : 0.0);
        CuttingPass cut = pass(name, offset, bottom, false);
        cut.roughs = true;
        cut.stock = milling_.cutter.stock + allowance_;
        cut.chord_tolerance = tolerance;
        cut.keep = ends_of_offset([surface = surface_](double v) { return surface.at(v); }, radius_ + offset,
                                  cut.knots.back() - cut.knots.front(), milling_.cam);
        return cut;
    }

    /// edge: the program is the way of the cutter's edge.
    [[nodiscard]] CuttingPass pass(const std::string& name, double stock, double bottom, bool edge) const {
        const double offset = stock + (edge ? 0.0 : radius_);
        CuttingPass cut;
        cut.name = name;
        cut.path = [surface = surface_, offset, bottom](double v) {
            const ContourPoint point = surface.at(v);
            const Eigen::Vector2d tip = point.position + offset * point.normal;
            return ToolPose{{tip.x(), tip.y(), bottom}, -Eigen::Vector3d::UnitZ()};
        };
        cut.knots = surface_.knots();
        cut.climbs = milling_.choice.climbs();
        if (!edge) return cut;
        // The body is on the right of a tool that goes towards +x: the cutter stands on the left.
        cut.compensation = to_plus_x_ ? CompensationSide::left : CompensationSide::right;
        const double way = (2.0 * radius_ + switching_way) / surface_.speed();
        cut.in.poses = {cut.path(cut.knots.front() - way)};
        cut.out.poses = {cut.path(cut.knots.back() + way)};
        return cut;
    }

    const PlateMilling& milling_;
    bool to_plus_x_;
    double radius_, allowance_;
    LongSurface surface_;
};

}  // namespace

MillingPasses plate_passes(const PlateMilling& milling) {
    milling.cutter.validate();
    milling.choice.validate(milling.cutter.diameter);
    if (!milling.blank.block) throw InputError("plate: its blank must be a block");
    return PlatePassMaker(milling).made();
}

}  // namespace camopt
