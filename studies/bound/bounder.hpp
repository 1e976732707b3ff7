// SPDX-License-Identifier: MIT
// Private to studies/bound/: what bounds over boxes. Its parts by subject: bounder_places.cpp the cam angles,
// bounder_rows.cpp rows, planes and the steps of the proof, bounder_boxes.cpp the boxes, bounder.cpp the
// order of all of it.
#pragma once

#include "objectives/boxes/rule_over_box.hpp"
#include "solvers/vertex/vertex_program.hpp"
#include "studies/bound/box_bound.hpp"

namespace camopt::box_bound {

// A part of all motions: boxes of their states at finitely many cam angles and of the parameters, and the
// linear program that lies under the problem over these boxes.

/// (order 0 … 3 of y at a cam angle) = weights · x + offset.
struct StateRow {
    Eigen::VectorXd weights;
    double offset = 0.0;
};

/// A cam angle at which rules that are not linear are kept.
struct Place {
    double at = 0.0;
    Side side = Side::right;
    std::array<StateRow, 4> state;
    std::vector<int> rules;  ///< of the model
    bool of_cam = false;     ///< the state is that of the cam's motion, where the output's is prescribed

    [[nodiscard]] Eigen::VectorXd point(const Eigen::VectorXd& x) const;
};

/// What a box of one place has of one rule.
struct Bent {
    int rule = 0;
    std::optional<RuleOverBox> over;
};

struct PlaceBox {
    std::array<Interval, 4> state{Interval::everything(), Interval::everything(), Interval::everything(),
                                  Interval::everything()};
    std::array<std::array<int, 2>, 4> steps{{{-1, -1}, {-1, -1}, {-1, -1}, {-1, -1}}};  ///< of its ends
    std::vector<Bent> bent;  ///< one a rule of the place
    bool bites = true;       ///< some rule may be broken in it
};

struct Node {
    VertexProgram program;
    std::vector<char> may_go{};  ///< of each row of the program: a plane or a side of a box
    std::vector<int> steps{};    ///< of each row of the program: its step of the proof
    /// The steps that bound a variable now, its lower and upper bound; −1: as at the beginning.
    std::vector<std::array<int, 2>> bound_steps{};
    std::vector<int> splits{};      ///< steps that this part assumes
    std::vector<PlaceBox> boxes{};  ///< one a place
    int linear_rows = 0;            ///< of the grid of linear rules, how many are in the program
    double bound = -infinity;
    bool empty = false;  ///< proved: nothing lies in it
    /// What the bound, or that it is empty, follows from: steps and multipliers.
    std::vector<std::pair<int, double>> multipliers{};
    std::vector<int> bounds_used{};
    Eigen::VectorXd x{};  ///< where the bound is taken
    int depth = 0;
};

/// A number whose interval may be halved: a parameter, or a derivative of y at a place.
struct Halved {
    int variable = -1;  ///< −1: a derivative
    int order = 0;
    std::size_t place = 0;
    double error = 0.0;
};

/// Not linear, of one place, and with an enclosure over boxes.
[[nodiscard]] bool can_be_bounded(const PointRule& rule);

/// The least and the greatest y, y', y'' at every place that the corners of one pass had. An end of a box
/// that one of them comes near cannot shrink: the linear program that would say so is left out. Source: A.
/// Gleixner et al., Three enhancements for optimization-based bound tightening, J. Glob. Optim. 67 (2017).
class SeenStates {
 public:
    explicit SeenStates(const std::vector<Place>& places);
    void add(const Eigen::VectorXd& x);
    [[nodiscard]] const Interval& at(std::size_t place, int order) const {
        return seen_[3 * place + static_cast<std::size_t>(order)];
    }

 private:
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> weights_;
    Eigen::VectorXd offsets_;
    std::vector<Interval> seen_;
};

class Bounder {
 public:
    Bounder(const CamModel& model, double incumbent, const BoxBoundOptions& options,
            const SolveControl& control);

    std::optional<BoxBound> run();

 private:
    [[nodiscard]] int design_size() const { return whole_.model().design.size(); }
    [[nodiscard]] double goal() const {
        return incumbent_ - options_.gap * std::max(1.0, std::abs(incumbent_));
    }
    [[nodiscard]] bool bounded() const { return std::isfinite(incumbent_); }
    [[nodiscard]] bool is_done(const Node& node) const {
        return node.empty || (bounded() && node.bound >= goal());
    }

    void add_places();
    void add_place(double at, Side side);
    void add_place(double at, Side side, bool of_cam);
    void sync_linear(Node& node);
    void sync_places(Node& node);
    int log(BoxStep step);
    void add_row(Node& node, int step, bool may_go = false);
    /// Multipliers of rows as those of steps.
    [[nodiscard]] std::vector<std::pair<int, double>> named(const Node& node, const VertexBound& found) const;
    [[nodiscard]] std::vector<int> bounds_of(const Node& node) const;
    void keep_bound(Node& node, const VertexBound& found);
    void end_part(const Node& node);
    int add_box_rows_at(Node& node, std::size_t place, const Eigen::VectorXd& state);
    VertexBound solve(Node& node, const Eigen::VectorXd& cost);
    /// Cuts until the bound no longer moves. False: nothing is in the node.
    bool settle(Node& node);
    int add_planes_at(Node& node, const Eigen::VectorXd& x);
    bool add_plane(Node& node, std::size_t place, const Bent& bent, const Eigen::VectorXd& at, bool always);
    [[nodiscard]] std::vector<Interval> rule_box(const Node& node, std::size_t place, int rule) const;
    void rebuild(Node& node, std::size_t place);
    void rebuild_all(Node& node);
    /// One pass over the boxes. False: the node is empty.
    bool tighten(Node& node);
    bool tighten_end(Node& node, const StateRow& number, Interval& box, std::array<int, 2>& ends, bool upper);
    bool tighten_place(Node& node, std::size_t place, int order, bool upper, SeenStates& seen);
    [[nodiscard]] bool is_read(const PlaceBox& box, int order) const;
    int linear_step(int row, int side, const BoxStep& step);
    bool tighten_variable(Node& node, int variable);
    bool exchange_places(Node& node);
    void close(Node& node);
    [[nodiscard]] std::vector<double> violations_at_places(const Node& node) const;
    void add_numbers_of(const Node& node, std::size_t place, std::vector<Halved>& numbers) const;
    [[nodiscard]] std::vector<Halved> worth_halving(const Node& node) const;
    [[nodiscard]] Node half(const Node& node, const Halved& number, bool upper);
    [[nodiscard]] std::vector<Node> halves(const Node& node);

    CamProblem whole_, linear_;
    double incumbent_;
    BoxBoundOptions options_;
    SolveControl control_;
    std::vector<Place> places_;
    std::vector<char> moves_rule_;  ///< variables that are parameters of rules that are not linear
    Eigen::VectorXd cost_;
    double constant_ = 0.0;
    Eigen::VectorXd corner_;  ///< of the last linear program; empty where it has none
    BoxBound result_;
    BoxProof proof_;
    std::map<std::pair<int, int>, int> linear_steps_;
};

}  // namespace camopt::box_bound
