// SPDX-License-Identifier: MIT
#include "shop/nc/nc_travel.hpp"

#include "core/errors.hpp"
#include "shop/nc/cutter_compensation.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr Eigen::Index travel_height_axis = 2;  // Z: X, Y, Z come first
constexpr double rounding = 1e-9;               // m: pieces this small are decided as their middle
constexpr int most_pieces = 1'000'000;          // of one move: what is not decided by then is not shown

class Travel {
 public:
    Travel(const Machine& machine, const NcTravelTask& task)
        : machine_(machine), task_(task), levers_(static_cast<Eigen::Index>(machine.axes().size())) {
        const double reach = task.blank.reach();
        for (std::size_t i = 0; i < machine.axes().size(); ++i)
            levers_(static_cast<Eigen::Index>(i)) = machine.axes()[i].kind == AxisKind::linear ? 1.0 : reach;
        const Eigen::VectorXd zero = Eigen::VectorXd::Zero(levers_.size());
        const ToolPose rest = machine.pose(zero);
        height_offset_ = -rest.axis.dot(rest.tip);
        any_height_ = greatest_height(task.blank, machine);
        check_.nearest = std::numeric_limits<double>::infinity();
        check_.deepest = -std::numeric_limits<double>::infinity();
    }

    void take(const Eigen::VectorXd& from, const NcMove& move) {
        pieces_ = 0;
        line_ = move.line;
        if (!move.rapid) {
            ++check_.feeds;
            if (!std::exchange(feeding_, true)) begin_pass();
            const Eigen::Index turning = levers_.size() - 3;
            const double turned = (move.values - from).tail(turning).cwiseAbs().dot(levers_.tail(turning));
            length_ = linear_length(from, move) + turned;
            feed(from, move, 0.0, 1.0);
            return;
        }
        feeding_ = false;
        ++check_.rapids;
        const bool above = above_everything(from, move.values);
        if (!above) rapid(from, move.values, task_.blank);
        if (!above && task_.rapids_above_as_it_stands) rapid_above_as_it_stands(from, move.values);
        if (task_.clamp && machine_.axes().size() == 3) rapid_past_clamp(from, move.values);
        if (task_.clamp && task_.rapids_above_as_it_stands) rapid_over_clamp(from, move.values);
    }
    [[nodiscard]] NcTravelCheck finish() && { return std::move(check_); }

 private:
    void refuse(const std::string& what) {
        if (check_.good()) check_.fault = fmt::format("line {}: {}", line_, what);
    }
    void begin_pass() {
        const auto pass = static_cast<std::size_t>(check_.passes++);
        if (task_.stocks.empty()) return;
        if (pass < task_.stocks.size())
            stock_ = task_.stocks[pass];
        else
            refuse(fmt::format("a pass more than the {} there are", task_.stocks.size()));
    }
    static std::string mm(double metres) { return fmt::format("{:.4g} mm", metres / units::millimetre); }

    /// Over the blank in whatever way the table stands: then no other axis matters.
    bool above_everything(const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
        const double begin = from(travel_height_axis), end = to(travel_height_axis);
        // The first move of a program, from wherever the machine stands: it may lift or lower the tool,
        // alone.
        const bool first = std::isnan(begin) && !std::isnan(end) && only_height_moves(from, to);
        const double lowest = first ? end : std::min(begin, end);
        if (std::isnan(begin) && !first) {
            refuse("a rapid across while the height of the tool is not known");
            return true;
        }
        const double distance = lowest + height_offset_ - any_height_;
        if (distance >= task_.least_distance) {
            check_.nearest = std::min(check_.nearest, distance);
            return true;
        }
        if (task_.rapids_above) {
            refuse(
                fmt::format("a rapid {} over the blank; {} is required, also next to the blank: "
                            "table and clamps are there",
                            mm(distance), mm(task_.least_distance)));
            return true;
        }
        if (from.allFinite() && to.allFinite()) return false;
        refuse(fmt::format("a rapid {} over the blank while not every axis has a value; {} is required",
                           mm(distance), mm(task_.least_distance)));
        return true;
    }
    [[nodiscard]] static bool only_height_moves(const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
        for (Eigen::Index i = 0; i < from.size(); ++i)
            if (i != travel_height_axis && !std::isnan(to(i)) && to(i) != from(i)) return false;
        return true;
    }

    /// Where the table tilts: down to the blank's height as it stands, beside it too.
    void rapid_above_as_it_stands(const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
        if (!from.allFinite() || !to.allFinite()) return;
        for (const Eigen::VectorXd& values : {from, to}) {
            const ToolPose pose = machine_.pose(values);
            const double over = -pose.axis.dot(pose.tip) - task_.blank.support(-pose.axis);
            if (over < task_.least_distance - rounding)
                return refuse(fmt::format(
                    "a rapid {} over the blank at this angle of the table; {} is required, also next to the "
                    "blank too: table and clamps are there",
                    mm(over), mm(task_.least_distance)));
        }
    }

    /// At any angle of the table, or as it stands where Z moves alone: the cutter has no upper end, so its
    /// lower place counts.
    void rapid_over_clamp(const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
        const double lowest =
            std::fmin(from(travel_height_axis), to(travel_height_axis));  // a NaN does not count
        if (lowest + height_offset_ >= task_.clamp->reach() + task_.least_distance - rounding) return;
        Eigen::VectorXd lower = to;
        lower(travel_height_axis) = lowest;
        if (!only_height_moves(from, to) || !lower.allFinite() ||
            distance_to_clamp(machine_.pose(lower), 0.0) < 0.0)
            refuse("a rapid that clamps may reach at some angle of the table");
    }

    /// Above it, or beside it.
    void rapid_past_clamp(const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
        const double lowest =
            std::fmin(from(travel_height_axis), to(travel_height_axis));  // a NaN does not count
        if (lowest + height_offset_ >= task_.clamp->upper + task_.least_distance) return;
        if (!from.allFinite())
            return refuse("a rapid below the upper end of the clamps while not every axis has a value");
        rapid(from, to, *task_.clamp);
    }

    /// Every value of every axis between the two. body: the blank or the clamp.
    void rapid(const Eigen::VectorXd& from, const Eigen::VectorXd& to, const Blank& body) {
        if (!check_.good()) return;
        const Eigen::VectorXd half = 0.5 * (to - from).cwiseAbs().cwiseProduct(levers_);
        const double distance =
            distance_to_blank(body, machine_.pose(0.5 * (from + to)), task_.cutter_radius);
        const char* const name = &body == &task_.blank ? "blank" : "clamp";
        if (&body == &task_.blank) check_.nearest = std::min(check_.nearest, distance);
        const double around = half.head<3>().norm() + half.tail(half.size() - 3).sum();
        if (distance < task_.least_distance) {
            refuse(distance > 0.0 ? fmt::format("a rapid may come within {} of the {}; {} is required",
                                                mm(distance), name, mm(task_.least_distance))
                                  : fmt::format("a rapid may touch the {}", name));
            return;
        }
        if (distance - around >= task_.least_distance - rounding) return;
        if (++pieces_ > most_pieces)
            return refuse(fmt::format("a rapid that could not be proved to stay off the {}", name));
        Eigen::Index widest = 0;
        half.maxCoeff(&widest);
        Eigen::VectorXd middle = to, other = from;
        middle(widest) = other(widest) = 0.5 * (from(widest) + to(widest));
        rapid(from, middle, body);
        rapid(other, to, body);
    }

    /// From below. The plane that faces the cutter's axis is enough as a rule.
    [[nodiscard]] double distance_to_clamp(const ToolPose& pose, double enough) const {
        if (task_.clamp->block) return distance_to_blank(*task_.clamp, pose, task_.cutter_radius);
        const Eigen::Vector2d tip = pose.tip.head<2>(), up = -pose.axis.head<2>();
        const double across = up.norm(), along = pose.axis.z();
        const double side = across > 0.5 ? tip.dot(up) / across - task_.cutter_radius * std::abs(along)
                                         : tip.norm() - task_.cutter_radius;
        const double apart = side - task_.clamp->radius;
        if (apart >= enough && (across > 0.5 || across == 0.0)) return apart;
        return distance_to_blank(*task_.clamp, pose, task_.cutter_radius);
    }

    void feed(const Eigen::VectorXd& from, const NcMove& move, double begin, double end) {
        if (!check_.good()) return;
        const double around = 0.5 * (end - begin) * length_;
        const ToolPose pose = machine_.pose(values_along(from, move, 0.5 * (begin + end)));
        const double depth = task_.cam->depth(pose, task_.cutter_radius + stock_);
        check_.deepest = std::max(check_.deepest, depth - stock_);
        if (depth > task_.most_depth)
            return refuse(stock_ > 0.0 ? fmt::format("roughing must leave {}; the cutter is {} too deep",
                                                     mm(stock_), mm(depth))
                                       : fmt::format("the cutter enters the finished cam by {}; {} are "
                                                     "allowed",
                                                     mm(depth), mm(task_.most_depth)));
        const double apart = task_.clamp ? distance_to_clamp(pose, around) : HUGE_VAL;
        if (apart < 0.0)
            return refuse(fmt::format("the cutter comes {}, where clamps lie", clamp_words(*task_.clamp)));
        if (around <= task_.cutter_radius && depth + around <= task_.most_depth + rounding &&
            around <= apart + rounding)
            return;
        if (++pieces_ > most_pieces)
            return refuse("a feed that could not be proved to stay out of the finished cam");
        const double middle = 0.5 * (begin + end);
        feed(from, move, begin, middle);
        feed(from, move, middle, end);
    }

    const Machine& machine_;
    const NcTravelTask& task_;
    Eigen::VectorXd levers_;  // of each axis: how far it moves a point of the blank past the cutter
    NcTravelCheck check_;
    double height_offset_ = 0.0, any_height_ = 0.0;
    double stock_ = 0.0, length_ = 0.0;  // of this pass; of this move
    bool feeding_ = false;
    int line_ = 0, pieces_ = 0;
};

}  // namespace

void NcTravelTask::validate() const {
    blank.validate();
    const auto require = [](bool holds, const char* what, double found) {
        if (!holds) throw InputError(fmt::format("NC check: {}, found {:g} m", what, found));
    };
    require(std::isfinite(cutter_radius) && cutter_radius > 0.0, "the cutter's radius must be > 0",
            cutter_radius);
    require(std::isfinite(least_distance) && least_distance > 0.0,
            "the distance of rapids from the blank must be > 0", least_distance);
    require(std::isfinite(most_depth) && most_depth > 0.0, "the allowed depth must be > 0", most_depth);
    for (const double stock : stocks)
        require(std::isfinite(stock) && stock >= 0.0, "the stock of a pass must be >= 0", stock);
    if (cam == nullptr) throw InputError("NC check: the finished cam is missing");
}

NcTravelCheck check_travel(std::span<const NcMove> moves, const Machine& machine, const NcTravelTask& task) {
    task.validate();
    if (moves.empty()) throw InputError("NC check: the program does not move");
    Travel travel(machine, task);
    const auto axes = static_cast<Eigen::Index>(machine.axes().size());
    Eigen::VectorXd from = Eigen::VectorXd::Constant(axes, std::numeric_limits<double>::quiet_NaN());
    for (const NcMove& move : moves) {
        travel.take(from, move);
        from = move.values;
    }
    return std::move(travel).finish();
}

}  // namespace camopt
