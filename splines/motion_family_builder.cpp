// SPDX-License-Identifier: MIT
// Builds a family from intervals: displacements at the joints, runs of splines, and the rows that connect
// them.
#include "core/errors.hpp"
#include "splines/motion_family.hpp"

#include <fmt/format.h>

#include <map>

namespace camopt {

namespace {

using Kind = StretchRequest::Kind;
constexpr double same_displacement = 1e-12;

AffineRow constant(double value) {
    return {value, {}, {}};
}

/// y, y', y'' at one end of a run, as rows of the joint entries (columns count from 0).
using EndState = std::array<AffineRow, 3>;

/// A run of spline intervals: first … first + count − 1, counted cyclically.
struct RunPlan {
    int first = 0, count = 0;
};

}  // namespace

struct MotionFamily::Builder {
    const FamilyRequest& request;
    MotionFamily family;
    int stretches;
    bool wraps;  ///< the first stretch follows the last one
    bool ring;   ///< nothing but splines, and wraps
    /// y', y'' where a relative motion goes on, between two runs of splines: entries of their own.
    std::optional<std::array<AffineRow, 2>> seam;
    std::vector<AffineRow> levels;  ///< displacement at joint j = begin of stretch j; one more for the end

    explicit Builder(const FamilyRequest& asked)
        : request(asked),
          stretches(static_cast<int>(asked.stretches.size())),
          wraps(asked.closed || asked.relative) {
        ring = wraps && std::ranges::all_of(request.stretches, [](const StretchRequest& stretch) {
                   return stretch.kind == Kind::spline;
               });
    }

    [[nodiscard]] const StretchRequest& stretch(int index) const {
        return request.stretches[static_cast<std::size_t>(index % stretches)];
    }
    [[nodiscard]] bool is_spline(int index) const { return stretch(index).kind == Kind::spline; }

    int add_joint_entry(const std::string& name, int order) {
        family.joints_.emplace_back(name, order);
        return static_cast<int>(family.joints_.size()) - 1;
    }

    MotionFamily build() {
        if (stretches == 0) throw InputError("a family of motions: found no stretch; allowed: one or more");
        find_levels();
        const std::vector<RunPlan> plans = plan_runs();
        std::vector<std::pair<EndState, EndState>> ends;
        ends.reserve(plans.size());
        for (const RunPlan& plan : plans) ends.push_back(ends_of(plan));
        for (std::size_t r = 0; r < plans.size(); ++r) add_run(plans[r], ends[r]);
        family.first_joint_ = family.size_;
        family.size_ += static_cast<int>(family.joints_.size());
        shift_joint_columns();
        for (int r = 0; r < family.runs(); ++r) add_rows_of(r);
        if (ring) close_ring();
        add_stretches(plans);
        family.add_pieces();
        find_levels_inside_runs();
        if (seam) join_higher_orders();
        add_copies();
        return std::move(family);
    }

    /// Of every stretch, shifted by the length of all: entries and runs stay.
    void add_copies() {
        if (request.repeat <= 1) return;
        const std::vector<Stretch> own = family.stretches_;
        for (int copy = 1; copy < request.repeat; ++copy) {
            const double shift = copy * length();
            for (Stretch stretch : own) {
                stretch.begin += shift;
                stretch.end += shift;
                stretch.shift -= shift;
                stretch.copy = true;
                family.stretches_.push_back(std::move(stretch));
            }
        }
        family.repeat_ = request.repeat;
        family.pieces_.clear();
        family.piece_begins_.clear();
        family.add_pieces();
    }

    /// Default for a free joint between two splines.
    void find_levels_inside_runs() {
        const auto row_at = [&](double x, Side side) {
            AffineRow all = family.functional(x, 0, side), row{all.offset, {}, {}};
            for (std::size_t k = 0; k < all.columns.size(); ++k) {
                if (all.weights[k] == 0.0) continue;
                row.columns.push_back(all.columns[k]);
                row.weights.push_back(all.weights[k]);
            }
            return row;
        };
        for (Stretch& own : family.stretches_) {
            if (std::isnan(own.from.offset)) own.from = row_at(own.begin, Side::right);
            if (std::isnan(own.to.offset)) own.to = row_at(own.end, Side::left);
        }
    }

    /// Displacements at joints: given, propagated along dwells, or an entry. Joints inside a run without a
    /// given displacement belong to the spline.
    void find_levels() {
        std::vector<std::optional<double>> known(static_cast<std::size_t>(stretches) + 1);
        const auto set = [&](int joint, double value) {
            std::optional<double>& level = known[static_cast<std::size_t>(joint)];
            if (level && std::abs(*level - value) > same_displacement) {
                throw InputError(fmt::format(
                    "displacements contradict each other: found {} and {} at the joint after {} stretches; "
                    "allowed: one displacement there (a dwell keeps it, a closed program ends at 0)",
                    *level, value, joint));
            }
            level = value;
        };
        set(0, 0.0);
        if (request.closed) set(stretches, 0.0);
        for (int i = 0; i < stretches; ++i) {
            if (stretch(i).to) set(i + 1, *stretch(i).to);
        }
        for (int i = 0; i < stretches; ++i) {
            if (stretch(i).kind == Kind::dwell && known[i]) set(i + 1, *known[i]);
        }
        for (int i = stretches - 1; i >= 0; --i) {
            if (stretch(i).kind == Kind::dwell && known[i + 1]) set(i, *known[i + 1]);
        }
        for (int j = 0; j <= stretches; ++j) {
            const bool after_dwell = j > 0 && stretch(j - 1).kind == Kind::dwell;
            const bool inside_run = j > 0 && j < stretches && is_spline(j - 1) && is_spline(j);
            if (known[j]) {
                levels.push_back(constant(*known[j]));
            } else if (after_dwell) {
                levels.push_back(levels.back());
            } else if (inside_run) {
                levels.push_back({std::nan(""), {}, {}});
            } else {
                const int entry =
                    add_joint_entry(fmt::format("displacement at x = {:.6g}", stretch(j - 1).end), 0);
                levels.push_back({0.0, {entry}, {1.0}});
            }
        }
    }

    [[nodiscard]] std::vector<RunPlan> plan_runs() const {
        std::vector<RunPlan> plans;
        for (int i = 0; i < stretches; ++i) {
            if (!is_spline(i)) continue;
            if (i > 0 && is_spline(i - 1)) {
                ++plans.back().count;
            } else {
                plans.push_back({i, 1});
            }
        }
        const bool across_end = request.closed && !ring && plans.size() > 1 && plans.front().first == 0 &&
                                plans.back().first + plans.back().count == stretches;
        if (across_end) {
            plans.back().count += plans.front().count;
            plans.erase(plans.begin());
        }
        return plans;
    }

    /// y' or y'' at x = 0 as an entry.
    AffineRow state_entry(int order) {
        return {0.0,
                {add_joint_entry(
                    fmt::format("{} at x = 0", derivative_names[static_cast<std::size_t>(order)]), order)},
                {1.0}};
    }

    /// Where the last spline goes on as the first: at x = 0 or at the end.
    [[nodiscard]] bool is_at_seam(const PointCondition& condition) const {
        const double x = condition.at, end = stretch(stretches - 1).end;
        return (ring || request.relative) && is_spline(0) && is_spline(stretches - 1) &&
               (x == stretch(0).begin || x == end);
    }
    /// y' or y'' there: what a condition gives, which the run would take for met by an entry, else an entry.
    AffineRow seam_state(int order) {
        for (const int index : {0, stretches - 1})
            for (const PointCondition& condition : stretch(index).conditions)
                if (condition.order == order && is_at_seam(condition)) return constant(condition.value);
        return state_entry(order);
    }

    /// The state next to an interval that is not a spline: at rest next to a dwell, as asked at an open end,
    /// the shape's next to a shape. `at_end`: of the neighbour.
    [[nodiscard]] EndState beside(int neighbour, bool at_end, const AffineRow& level) {
        EndState state{level, constant(0.0), constant(0.0)};
        if (is_open_end(neighbour)) {
            const std::array<double, 2>& given = at_end ? request.start : request.end;
            return {level, constant(given[0]), constant(given[1])};
        }
        if (is_spline(neighbour)) {  // a relative motion goes on with its own run
            if (!seam) seam = {seam_state(1), seam_state(2)};
            return {level, (*seam)[0], (*seam)[1]};
        }
        if (stretch(neighbour).kind != Kind::shape) return state;
        const int index = neighbour % stretches;
        const StretchRequest& own = stretch(index);
        const MotionPoint point = own.shape->at(at_end ? 1.0 : 0.0, at_end ? Side::left : Side::right);
        for (int order = 1; order < 3; ++order) {
            const double factor = point.derivative[order] / std::pow(own.end - own.begin, order);
            state[order] =
                combined(combined(constant(0.0), factor, levels[index + 1]), -factor, levels[index]);
        }
        return state;
    }

    /// Before and after a run; −1: there is none before.
    [[nodiscard]] std::array<int, 2> neighbours_of(const RunPlan& plan) const {
        return {plan.first > 0 ? plan.first - 1 : wraps ? stretches - 1 : -1, plan.first + plan.count};
    }
    [[nodiscard]] bool is_open_end(int neighbour) const {
        return neighbour < 0 || (!wraps && neighbour >= stretches);
    }

    std::pair<EndState, EndState> ends_of(const RunPlan& plan) {
        if (ring) {
            const AffineRow velocity = seam_state(1), acceleration = seam_state(2);
            return {{constant(0.0), velocity, acceleration}, {levels.back(), velocity, acceleration}};
        }
        const auto [before, after] = neighbours_of(plan);
        const int last_joint = after <= stretches ? after : after - stretches;
        return {beside(before, true, levels[plan.first]), beside(after, false, levels[last_joint])};
    }

    [[nodiscard]] double length() const { return stretch(stretches - 1).end - stretch(0).begin; }
    /// The shift from an interval's x to the run's x.
    [[nodiscard]] double shift_of(int index) const { return index >= stretches ? length() : 0.0; }

    [[nodiscard]] DesignRequest design_request(const RunPlan& plan) const {
        std::vector<double> breakpoints;
        std::vector<PointCondition> conditions;
        for (int i = plan.first; i < plan.first + plan.count; ++i) {
            const StretchRequest& own = stretch(i);
            for (std::size_t k = breakpoints.empty() ? 0 : 1; k < own.breakpoints.size(); ++k) {
                breakpoints.push_back(own.breakpoints[k] + shift_of(i));
            }
            for (PointCondition condition : own.conditions) {
                condition.asked = condition.asked && !is_at_seam(condition);
                condition.at += shift_of(i);
                conditions.push_back(std::move(condition));
            }
            const bool inside = i + 1 < plan.first + plan.count;
            const AffineRow& level = levels[static_cast<std::size_t>(i % stretches) + 1];
            if (inside && !std::isnan(level.offset)) {
                const double x = own.end + shift_of(i);
                conditions.push_back({x, 0, Side::right, level.offset,
                                      fmt::format("displacement {:.6g} at x = {:.6g}", level.offset, own.end),
                                      true});
            }
        }
        const auto [before, after] = neighbours_of(plan);
        const auto add_rest = [&](int neighbour, double x, Side side) {
            if (!is_open_end(neighbour) && stretch(neighbour).kind != Kind::dwell) return;
            for (PointCondition& condition : rest_conditions(x, side, request.rest))
                conditions.push_back(std::move(condition));
        };
        add_rest(before, breakpoints.front(), Side::right);
        add_rest(after, breakpoints.back(), Side::left);
        return {SplineSpace(request.degree, request.continuity, std::move(breakpoints)),
                request.kind,
                {},
                {},
                std::move(conditions),
                Symmetry::none};
    }

    /// A design vector is affine in its end states, which affect only its offsets, so the column of a joint
    /// entry is the difference of two end states.
    void add_run(const RunPlan& plan, const std::pair<EndState, EndState>& ends) {
        DesignRequest asked = design_request(plan);
        const auto with = [&](int joint) {
            DesignRequest moved = asked;
            for (int order = 0; order < 3; ++order) {
                moved.begin_state[order] = value_at(ends.first[order], joint);
                moved.end_state[order] = value_at(ends.second[order], joint);
            }
            return DesignVector::make(moved);
        };
        Run run{with(-1), family.size_, {}};
        std::map<int, DesignVector> moved;
        for (const EndState* end : {&ends.first, &ends.second}) {
            for (const AffineRow& row : *end) {
                for (const int joint : row.columns) moved.try_emplace(joint, with(joint));
            }
        }
        for (int i = 0; i < run.design.space().segments(); ++i) {
            LocalMap map = run.design.local_map(i);
            for (int& column : map.columns) column += run.first;
            for (const auto& [joint, design] : moved) {
                // Joint columns are negative until the number of run entries is known.
                map.columns.push_back(-1 - joint);
                map.matrix.conservativeResize(Eigen::NoChange, map.matrix.cols() + 1);
                map.matrix.rightCols(1) = design.local_map(i).offset - map.offset;
            }
            run.maps.push_back(std::move(map));
        }
        family.size_ += run.design.size();
        moved_.push_back(std::move(moved));
        family.runs_.push_back(std::move(run));
    }

    static double value_at(const AffineRow& row, int joint) {
        double value = row.offset;
        for (std::size_t k = 0; k < row.columns.size(); ++k)
            value += row.columns[k] == joint ? row.weights[k] : 0.0;
        return value;
    }

    void shift_joint_columns() {
        for (Run& run : family.runs_) {
            for (LocalMap& map : run.maps) {
                for (int& column : map.columns)
                    column = column < 0 ? family.first_joint_ - 1 - column : column;
            }
        }
        for (AffineRow& level : levels) {
            for (int& column : level.columns) column += family.first_joint_;
        }
    }

    void add_rows_of(int index) {
        const Run& run = family.runs_[index];
        for (std::size_t i = 0; i < run.design.equalities().size(); ++i) {
            Equality equality = run.design.equalities()[i];
            const double offset = equality.row.offset;
            for (int& column : equality.row.columns) column += run.first;
            for (const auto& [joint, design] : moved_[index]) {
                const double weight = design.equalities()[i].row.offset - offset;
                if (weight == 0.0) continue;
                equality.row.columns.push_back(family.first_joint_ + joint);
                equality.row.weights.push_back(weight);
            }
            family.equalities_.push_back(std::move(equality));
        }
    }

    /// y', y'' agree at the seam through its entries; higher continuity adds rows.
    void join_higher_orders() {
        const double begin = family.begin(), end = family.end();
        for (int order = 3; order <= request.continuity; ++order)
            family.equalities_.push_back({combined(family.functional(end, order, Side::left), -1.0,
                                                   family.functional(begin, order, Side::right)),
                                          fmt::format("relative: derivative {} at x = 0", order)});
    }

    /// y, y', y'' agree through the joint entries; higher continuity adds rows.
    void close_ring() {
        const Run& run = family.runs_.front();
        const SplineSpace& space = run.design.space();
        Stretch whole{Kind::spline, space.begin(), space.end(), 0, 0.0, nullptr, {}, {}};
        family.stretches_ = {whole};
        family.add_pieces();
        for (int order = 3; order <= request.continuity; ++order) {
            const AffineRow begin = family.functional(space.begin(), order, Side::right);
            family.equalities_.push_back(
                {combined(family.functional(space.end(), order, Side::left), -1.0, begin),
                 fmt::format("closed: derivative {} at x = 0", order)});
        }
        family.stretches_.clear();
        family.pieces_.clear();
        family.piece_begins_.clear();
    }

    void add_stretches(const std::vector<RunPlan>& plans) {
        for (int i = 0; i < stretches; ++i) {
            const StretchRequest& asked = stretch(i);
            Stretch own{asked.kind, asked.begin, asked.end, -1, 0.0, asked.shape, levels[i], levels[i + 1]};
            for (int r = 0; r < static_cast<int>(plans.size()); ++r) {
                const RunPlan& plan = plans[r];
                for (const int index : {i, i + stretches}) {
                    if (asked.kind != Kind::spline || index < plan.first || index >= plan.first + plan.count)
                        continue;
                    own.run = r;
                    own.shift = shift_of(index);
                }
            }
            family.stretches_.push_back(std::move(own));
        }
    }

    std::vector<std::map<int, DesignVector>> moved_;
};

MotionFamily MotionFamily::make(const FamilyRequest& request) {
    return Builder(request).build();
}

}  // namespace camopt
