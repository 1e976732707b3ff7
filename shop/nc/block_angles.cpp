// SPDX-License-Identifier: MIT
#include "shop/nc/block_angles.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr int most_halvings = 16;      // of the pieces a section begins with
constexpr int first_pieces = 8;        // so that no wave of the path hides between the quarters
constexpr double longest_step = 0.1;   // rad: beyond, half a turn of an axis is no longer certain
constexpr int arc_samples = 32;        // of a path that may be a circle
constexpr double same_radius = 1e-9;   // m: far below a printed digit
constexpr double shortest_arc = 1e-5;  // m: below, printed digits would decide where it turns
constexpr double longest_arc = 0.5 * std::numbers::pi;  // rad

class Subdivision {
 public:
    Subdivision(const ToolPath& path, const Machine& machine, const BlockOptions& options)
        : path_(path), machine_(machine), options_(options) {}

    void add_even(double begin, double end, int count) {
        for (int i = 0; i < count; ++i)
            add(begin + (end - begin) * i / count, begin + (end - begin) * (i + 1) / count, 0);
    }
    void add_within_tolerance(double begin, double end) {
        if (options_.arcs && add_arcs(begin, end)) return;
        const int pieces = std::max(first_pieces, static_cast<int>(std::ceil((end - begin) / longest_step)));
        for (int i = 0; i < pieces; ++i)
            add(begin + (end - begin) * i / pieces, begin + (end - begin) * (i + 1) / pieces, most_halvings);
    }
    [[nodiscard]] BlockAngles finish() && { return std::move(result_); }

 private:
    /// False: the path is no circle about the cam's axis, or goes along it to and fro.
    bool add_arcs(double begin, double end) {
        const Eigen::Vector3d first = path_(begin).tip;
        Eigen::Vector3d before = first;
        double turn = 0.0;
        for (int k = 0; k <= arc_samples; ++k) {
            const double theta = begin + (end - begin) * k / arc_samples;
            const Eigen::Vector3d tip = path_(theta).tip;
            const double step =
                std::atan2(before.x() * tip.y() - before.y() * tip.x(), before.head<2>().dot(tip.head<2>()));
            const bool same = std::abs(tip.head<2>().norm() - first.head<2>().norm()) <= same_radius &&
                              std::abs(tip.z() - first.z()) <= same_radius;
            if (!same || step * turn < 0.0 || !options_.arcs(theta)) return false;
            turn += step;
            before = tip;
        }
        if (std::abs(turn) * first.head<2>().norm() < shortest_arc) return false;
        const int pieces = static_cast<int>(std::ceil(std::abs(turn) / longest_arc - 1e-9));
        if (result_.theta.empty()) result_.theta.push_back(begin);
        for (int i = 1; i <= pieces; ++i) {
            // The tool looks down on the plane.
            result_.arcs.push_back({result_.theta.size(), turn < 0.0});
            result_.theta.push_back(begin + (end - begin) * i / pieces);
        }
        return true;
    }
    void add(double begin, double end, int halvings) {
        const double deviation = chord_deviation(begin, end);
        if (deviation > options_.chord_tolerance && halvings > 0) {
            const double middle = 0.5 * (begin + end);
            add(begin, middle, halvings - 1);
            add(middle, end, halvings - 1);
            return;
        }
        if (result_.theta.empty()) result_.theta.push_back(begin);
        result_.theta.push_back(end);
        result_.chord_deviation = std::max(result_.chord_deviation, deviation);
    }

    [[nodiscard]] double chord_deviation(double begin, double end) const {
        const Eigen::VectorXd first = machine_.values(path_(begin));
        const Eigen::VectorXd last = nearest_turn(machine_, machine_.values(path_(end)), first);
        double worst = 0.0;
        for (const double share : {0.25, 0.5, 0.75}) {
            const ToolPose wanted = path_(begin + share * (end - begin));
            const ToolPose found = machine_.pose(first + share * (last - first));
            const Eigen::Vector3d tip = found.tip - wanted.tip;
            const Eigen::Vector3d back = tip - options_.working_length * (found.axis - wanted.axis);
            worst = std::max({worst, tip.norm(), back.norm()});
        }
        return worst;
    }

    const ToolPath& path_;
    const Machine& machine_;
    const BlockOptions& options_;
    BlockAngles result_;
};

void check_knots(std::span<const double> knots) {
    if (knots.size() < 2) throw InputError("blocks need at least two knots: begin and end");
    for (std::size_t i = 1; i < knots.size(); ++i)
        if (!(knots[i] > knots[i - 1]) || !std::isfinite(knots[i] - knots[i - 1]))
            throw InputError(fmt::format("the knots of a cutter path must ascend; found {} after {}",
                                         knots[i], knots[i - 1]));
}

}  // namespace

void BlockOptions::validate() const {
    if (count && *count < 1) throw InputError(fmt::format("blocks: must be >= 1, found {}", *count));
    if (!(std::isfinite(chord_tolerance) && chord_tolerance > 0.0))
        throw InputError(fmt::format("chord tolerance: must be > 0 m, found {:g}", chord_tolerance));
    if (!(std::isfinite(working_length) && working_length >= 0.0))
        throw InputError(fmt::format("working length: must be >= 0 m, found {:g}", working_length));
}

BlockAngles block_angles(const ToolPath& path, const Machine& machine, std::span<const double> knots,
                         const BlockOptions& options) {
    options.validate();
    check_knots(knots);
    Subdivision subdivision(path, machine, options);
    if (options.count) {
        subdivision.add_even(knots.front(), knots.back(), *options.count);
    } else {
        for (std::size_t i = 1; i < knots.size(); ++i)
            subdivision.add_within_tolerance(knots[i - 1], knots[i]);
    }
    return std::move(subdivision).finish();
}

}  // namespace camopt
