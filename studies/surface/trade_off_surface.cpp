// SPDX-License-Identifier: MIT
#include "studies/surface/trade_off_surface.hpp"

#include "core/word_of.hpp"
#include "studies/least/least_value.hpp"
#include "studies/pareto/sweep_front.hpp"
#include "studies/sweep/row_chain.hpp"

#include <Eigen/LU>
#include <fmt/format.h>

#include <set>

namespace camopt {

namespace {

constexpr std::array<FrontFigure, 3> surface_terms = {FrontFigure::velocity, FrontFigure::acceleration,
                                                      FrontFigure::jerk};
// Sums of three products of numbers near 1.
constexpr double gap_rounding = 1e-12;
// A gap that a solve in its own place closes by less than this part stays open.
constexpr double worth_a_solve = 1e-3;

bool is_surface_term(FrontFigure figure) {
    return std::ranges::find(surface_terms, figure) != surface_terms.end();
}

PeakTriple triple_of(const Eigen::Vector3d& value) {
    return {value[0], value[1], value[2]};
}
Eigen::Vector3d vector_of(const PeakTriple& value) {
    return {value[0], value[1], value[2]};
}

Scene weighted(const Scene& scene, const Eigen::Vector3d& weights) {
    Scene one = scene;
    for (std::size_t k = 0; k < surface_terms.size(); ++k)
        set_weight(one, surface_terms[k], weights[static_cast<Eigen::Index>(k)]);
    return one;
}

void refuse_other_terms(const Scene& scene) {
    const auto refuse = [](const std::string& name) {
        throw InputError(
            fmt::format("--surface: found objective.{} > 0; allowed: velocity, acceleration and jerk, whose "
                        "weights it varies, and no other term",
                        name));
    };
    for (const CostTerm& term : cost_terms())
        if (!is_surface_term(term.figure) && term.weight_in(scene.objective) > 0.0) refuse(term.name());
    for (const ResponseTerm& term : response_terms())
        if (term.weight_in(scene.objective) > 0.0) refuse(term.name);
    for (int d = 0; d < dimension_count; ++d) {
        const auto dimension = static_cast<DimensionIndex>(d);
        if (weight_of(scene, dimension) > 0.0) refuse(name_of(dimension));
    }
    refuse_sought_number(scene, "--surface");
    if (!scene.own_terms.empty())
        throw InputError("--surface: found a user-defined cost term; allowed: velocity, acceleration, jerk");
}

/// Bounds from above and below, fed solve by solve.
class SurfaceSearch {
 public:
    SurfaceSearch(const Scene& scene, const SurfaceRequest& request, const RowRun& run)
        : scene_(scene), request_(request), run_(run) {}

    [[nodiscard]] TradeOffSurface run() {
        std::vector<std::string> keys;
        keys.reserve(std::size(surface_terms));
        for (const FrontFigure term : surface_terms)
            keys.push_back(fmt::format("objective.{}", name_of(FrontGoal(term))));
        const Scene within = weighted(scene_, Eigen::Vector3d::Constant(1.0 / 3.0));
        surface_.table.columns = columns_of(std::move(keys), std::span(&within, 1));
        for (std::size_t k = 0; k < 3; ++k) surface_.reference[k] = reference_of(scene_, surface_terms[k]);
        if (!begin()) return std::move(surface_);
        while (true) {
            HullTriangle* const triangle = widest();
            if (run_.row_done) {
                describe();
                run_.row_done(surface_.table, surface_.error);
            }
            if (triangle == nullptr) {
                describe();
                surface_.end = surface_.error <= request_.error ? SurfaceEnd::reached : SurfaceEnd::own_gaps;
                return std::move(surface_);
            }
            if (static_cast<int>(surface_.table.rows.size()) >= request_.most_solves) {
                surface_.end = SurfaceEnd::solves;
                break;
            }
            const Eigen::Vector3d weights = triangle->widest;
            const double gap = triangle->gap;
            const std::array<int, 3> corners = triangle->corners;
            if (!take(weights)) break;
            surface_.hull->add(weights, *surface_.table.rows.back().lower_bound);
            // The same triangle with the same gap: the solve's own gap is as wide.
            for (HullTriangle& same : surface_.hull->triangles()) {
                if (same.corners != corners) continue;
                measure(same);
                same.settled = same.gap > (1.0 - worth_a_solve) * gap;
            }
        }
        describe();
        return std::move(surface_);
    }

 private:
    /// False: the search ends with it.
    bool take(const Eigen::Vector3d& weights) {
        const SweepRow* const row =
            chain_.solve(triple_of(weights), [&] { return weighted(scene_, weights); });
        if (row == nullptr || !has_motion_and_bound(*row)) {
            surface_.end = row == nullptr ? SurfaceEnd::interrupted : SurfaceEnd::no_motion;
            return false;
        }
        points_.push_back(vector_of(surface_.point(*row)));
        return true;
    }
    [[nodiscard]] bool has_motion_and_bound(const SweepRow& row) {
        const PeakTriple point = row.is_feasible() ? surface_.point(row) : PeakTriple{infinity, 0.0, 0.0};
        return row.lower_bound && std::ranges::all_of(point, [](double peak) { return std::isfinite(peak); });
    }
    /// The three corners.
    bool begin() {
        std::array<double, 3> heights{};
        for (int k = 0; k < 3; ++k) {
            if (!take(Eigen::Vector3d::Unit(k))) return false;
            heights[static_cast<std::size_t>(k)] = *surface_.table.rows.back().lower_bound;
        }
        surface_.hull.emplace(heights);
        return true;
    }
    /// How far the least of w · p lies above the triangle at most, and where.
    void measure(HullTriangle& triangle) const {
        Eigen::Matrix3d corners;
        for (std::size_t k = 0; k < 3; ++k)
            corners.row(static_cast<Eigen::Index>(k)) = surface_.hull->weights(triangle.corners[k]);
        std::vector<PeakTriple> rows;
        rows.reserve(points_.size());
        for (const Eigen::Vector3d& point : points_) {
            const Eigen::Vector3d values = corners * (point - triangle.plane);
            rows.push_back(triple_of(values));
        }
        const GameValue game = solve_game_by_cuts(rows);
        triangle.widest = corners.transpose() * vector_of(game.mix);
        double upper = infinity;
        for (const Eigen::Vector3d& point : points_) upper = std::min(upper, triangle.widest.dot(point));
        triangle.gap = game.bound / std::max(1.0, std::abs(upper));
    }
    /// The triangle of the widest gap that another solve may close; null: none is above the error asked for.
    /// Gaps only shrink as points are added, so that an old one that is small enough need not be measured
    /// again.
    [[nodiscard]] HullTriangle* widest() {
        std::vector<HullTriangle>& triangles = surface_.hull->triangles();
        for (HullTriangle& triangle : triangles)
            if (triangle.gap > 0.9 * request_.error) measure(triangle);
        HullTriangle* most = nullptr;
        for (HullTriangle& triangle : triangles)
            if (!triangle.settled && triangle.gap + gap_rounding > request_.error &&
                (most == nullptr || triangle.gap > most->gap))
                most = &triangle;
        return most;
    }
    void describe() {
        if (!surface_.hull) return;
        surface_.error = 0.0;
        surface_.triangles.clear();
        for (HullTriangle& triangle : surface_.hull->triangles()) {
            if (!std::isfinite(triangle.gap)) measure(triangle);
            surface_.error = std::max(surface_.error, triangle.gap + gap_rounding);
            surface_.triangles.push_back(triangle.corners);
        }
    }

    const Scene& scene_;
    const SurfaceRequest& request_;
    const RowRun& run_;
    TradeOffSurface surface_;
    RowChain chain_{run_, surface_.table};
    std::vector<Eigen::Vector3d> points_;  ///< p of each row
};

// A point this far above a plane, relative to its height, sees the triangle from above.
constexpr double above = 1e-13;
// Triangles of less than this part of the whole have no inside: their corners lie on one line.
constexpr double least_area = 1e-14;

}  // namespace

void SurfaceRequest::validate(const Scene& scene) const {
    if (!(error > 0.0 && error < 1.0))
        throw InputError(
            fmt::format("--surface {:g}: allowed: an error between 0 and 1, for example 1e-4", error));
    if (most_solves < 3) throw InputError(fmt::format("--most {}: allowed: 3 solves or more", most_solves));
    refuse_other_terms(scene);
    for (const FrontFigure term : surface_terms) {
        const double reference = reference_of(scene, term);
        if (!std::isfinite(reference) || reference <= 0.0)
            throw InputError(fmt::format(
                "--surface: the reference of {} is {:g}; allowed: finite references > 0 of velocity, "
                "acceleration and jerk, as those of \"modified_sine\" are",
                name_of(FrontGoal(term)), reference));
    }
}

const char* name_of(SurfaceEnd value) {
    return word_of<SurfaceEnd::interrupted>(value,
                                            {"reached", "solves", "own_gaps", "no_motion", "interrupted"});
}

PeakTriple TradeOffSurface::point(const SweepRow& row) const {
    PeakTriple point{};
    for (std::size_t k = 0; k < 3; ++k)
        point[k] = row.figure(surface_terms[k]).value_or(infinity) / reference[k];
    return point;
}

SurfaceValue TradeOffSurface::at(const PeakTriple& weights) const {
    const double sum = weights[0] + weights[1] + weights[2];
    if (!(std::isfinite(sum) && sum > 0.0 && std::ranges::min(weights) >= 0.0))
        throw InputError(fmt::format("weights {:g}, {:g}, {:g}; allowed: numbers >= 0 with a positive sum",
                                     weights[0], weights[1], weights[2]));
    if (!hull) throw InputError("there is no surface: fewer than three motions were found");
    const Eigen::Vector3d share = vector_of(weights) / sum;
    SurfaceValue value;
    value.lower = hull->at(share);
    value.upper = infinity;
    for (const SweepRow& row : table.rows) {
        if (!row.is_feasible()) continue;
        const double here = share.dot(vector_of(point(row)));
        if (here >= value.upper) continue;
        value.upper = here;
        value.nearest = row.number;
    }
    return value;
}

TradeOffSurface trade_off_surface(const Scene& scene, const SurfaceRequest& request, const RowRun& run) {
    request.validate(scene);
    return SurfaceSearch(scene, request, run).run();
}

WeightHull::WeightHull(const std::array<double, 3>& heights) : heights_(heights.begin(), heights.end()) {
    for (int k = 0; k < 3; ++k) points_.emplace_back(Eigen::Vector3d::Unit(k));
    add_triangle(0, 1, 2);
}

void WeightHull::add_triangle(int a, int b, int c) {
    Eigen::Matrix3d corners;
    corners << weights(a).transpose(), weights(b).transpose(), weights(c).transpose();
    if (std::abs(corners.determinant()) < least_area) return;
    const Eigen::Vector3d lifted(height(a), height(b), height(c));
    triangles_.push_back({{a, b, c}, corners.partialPivLu().solve(lifted)});
}

int WeightHull::add(const Eigen::Vector3d& weights, double height) {
    const int added = static_cast<int>(points_.size());
    points_.push_back(weights);
    heights_.push_back(height);
    // Everything that the new point sees from above goes; its border is joined to the point.
    std::set<std::pair<int, int>> border;
    std::erase_if(triangles_, [&](const HullTriangle& triangle) {
        if (!(weights.dot(triangle.plane) < height - above * std::max(1.0, std::abs(height)))) return false;
        for (std::size_t k = 0; k < 3; ++k) {
            const int from = triangle.corners[k], to = triangle.corners[(k + 1) % 3];
            if (border.erase({to, from}) == 0) border.insert({from, to});
        }
        return true;
    });
    for (const auto& [from, to] : border) add_triangle(from, to, added);
    return added;
}

double WeightHull::at(const Eigen::Vector3d& weights) const {
    double least = std::numeric_limits<double>::infinity();
    for (const HullTriangle& triangle : triangles_) least = std::min(least, weights.dot(triangle.plane));
    return least;
}

}  // namespace camopt
