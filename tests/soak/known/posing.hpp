// SPDX-License-Identifier: MIT
// A motion of a draft, the rows that are active at it, and the scene that they make with their multipliers.
#pragma once

#include "tests/soak/known/balance.hpp"
#include "tests/soak/known/draft.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace camopt::soak {

/// What is asked of rows: an optimum, or a contradiction.
struct Question {
    bool feasible = true;
    double shift = 0.0;  ///< of one bound, in its scale; below 0: motions exist after all
};
[[nodiscard]] Question drawn_question(Draw& draw, bool feasible, bool edges);

class Posing {
 public:
    Posing(Draw& draw, Draft draft, bool edges) : draw_(draw), draft_(std::move(draft)), edges_(edges) {}

    /// Draws the motion, and bounds that it satisfies with equality. False: these draws give no scene.
    [[nodiscard]] bool draw_rows(bool feasible);
    void add_to(Balance& balance);
    /// After their multipliers are found: which bounds are written, and references.
    void choose();
    /// What the costs come to by their multipliers.
    [[nodiscard]] double total() const;
    /// Of two set points, x; 1: no two are close together.
    [[nodiscard]] double closest() const { return closest_; }
    /// Moves the bound of one of its own rows towards the motion. False: the bound cannot be written then.
    [[nodiscard]] bool tighten(const ActiveRow& row, double by);
    [[nodiscard]] bool owns(const ActiveRow& row) const {
        return std::ranges::any_of(rows_, [&](const ActiveRow& own) { return &own == &row; });
    }
    [[nodiscard]] SceneText written();
    [[nodiscard]] const Draft& draft() const { return draft_; }
    [[nodiscard]] const Eigen::VectorXd& motion() const { return motion_; }
    /// Of the numbers of a row: |constant| + Σ of the values of its derivatives, and of x times their slopes.
    [[nodiscard]] double size_of(const Combination& weights, const Extreme& at, double constant) const;

 private:
    struct Corridor {
        double from = 0.0, to = 0.0;  ///< x
        int order = 0;
        bool above = true;  ///< an upper bound
        double bound = 0.0;
    };
    struct Point {
        struct Value {
            int order = 0;
            double value = 0.0;
            bool used = false;
        };
        std::size_t run = 0;
        double x = 0.0, until = 0.0;  ///< `until`: of a region
        std::vector<Value> values;
        double twin_distance = 0.0;  ///< from the point before it; 0: it is no twin
    };

    [[nodiscard]] std::vector<Extreme> extremes_of(const Quantity& quantity) const;
    [[nodiscard]] std::size_t run_of(int piece) const;  // its place in the draft
    void add(ActiveRow row) { rows_.push_back(std::move(row)); }
    void add_terms();
    void add_area();
    void add_root_mean_squares();
    void add_limits();
    void add_corridors();
    void add_points();
    [[nodiscard]] bool add_regions();
    void add_value(Point& point, int piece, int order, double preference);
    void add_twin(Point point, int piece);
    [[nodiscard]] std::optional<Corridor> corridor_at(const Extreme& at, int order, bool above);
    [[nodiscard]] bool stays_within_strokes() const;
    [[nodiscard]] bool can_be_built() const;
    [[nodiscard]] bool is_monotone() const;
    void write_objective(SceneText& text) const;
    void write_limits(SceneText& text) const;
    void write_corridors(SceneText& text) const;
    void write_points(SceneText& text) const;
    [[nodiscard]] double multiplier_sum(ActiveRow::Of of, std::size_t owner) const;

    Draw& draw_;
    Draft draft_;
    bool edges_;            ///< set points close together
    bool narrow_ = false;   ///< narrow corridors
    double closest_ = 1.0;  ///< distance of two set points, x
    Eigen::VectorXd motion_;
    std::vector<ActiveRow> rows_;
    std::vector<double> peaks_;                  ///< of each term
    std::vector<std::optional<double>> bounds_;  ///< of each limit; none: it cannot be written
    std::vector<double> loosened_;  ///< of limits and corridors whose rows have no multiplier; 0: left out
    std::vector<Corridor> corridors_;
    std::vector<double> corridor_loosened_;
    std::vector<Point> points_;
    std::vector<double> rms_;            ///< of each root mean square
    std::vector<double> rms_reference_;  ///< the same
    std::vector<double> rms_bounds_;     ///< the same
    double lost_area_ = 0.0, area_reference_ = 0.5;
    bool feasible_ = true, within_lift_ = true;
    std::vector<double> drawn_weights_;  ///< of the terms of a scene without a motion
    mutable Draw spelling_draw_{0};
};

/// Tightens the bound of a row by so much: Posing::tighten of the motion whose it is, or a clearance.
using Tightening = std::function<bool(const ActiveRow& row, double by)>;
/// The answer of motions whose multipliers are found. Nullopt: rounding hides it.
[[nodiscard]] std::optional<KnownAnswer> answer_of(Draw& draw, const Question& question, Balance& balance,
                                                   std::span<const Posing* const> posings,
                                                   const Tightening& tighten);

}  // namespace camopt::soak
