// SPDX-License-Identifier: MIT
#include "objectives/machine/machine_problem.hpp"

#include "core/errors.hpp"
#include "objectives/machine/machine_grid.hpp"
#include "objectives/nlp_parts.hpp"

#include <iterator>
#include <numeric>

namespace camopt {

namespace {

// Of the first grid of a clearance, over a whole cycle.
constexpr int first_angles = 24;
// Master angles closer than this are one, rad.
constexpr double same_angle = 1e-9;

double wrapped(double angle) {
    const double rest = std::fmod(angle, units::turn);
    return rest < 0.0 ? rest + units::turn : rest;
}

}  // namespace

MachineProblem::MachineProblem(std::vector<MachineBlock> blocks, std::vector<ClearanceRule> clearances) {
    for (MachineBlock& given : blocks) {
        Block block;
        block.problem = std::make_unique<CamProblem>(std::move(given.model), given.samples);
        const CamModel& model = block.problem->model();
        block.first_rule = first_clearance_;
        first_clearance_ +=
            static_cast<int>(model.rules.size() + model.parameter_rows.size() + model.design_rows.size());
        block.spec = std::move(given.place);
        blocks_.push_back(std::move(block));
    }
    number_columns();
    for (ClearanceRule& rule : clearances) {
        Clear clear;
        clear.rule = std::move(rule);
        clear.length = clear.rule.to - clear.rule.from;
        if (clear.length <= 0.0) clear.length += units::turn;
        merge_breaks(clear);
        const int count = std::max(2, static_cast<int>(first_angles * clear.length / units::turn));
        for (int k = 0; k <= count; ++k) add_angle(clear, clear.rule.from + clear.length * k / count);
        for (const double angle : clear.rule.samples) add_angle(clear, angle);
        clearances_.push_back(std::move(clear));
    }
    part_rows_.assign(blocks_.size() + clearances_.size(), 0);
    follow();
}

MachineProblem::~MachineProblem() = default;

/// Design entries by the master angle of their breakpoint, entries without one at the start of their axis;
/// parameters, which appear everywhere, last.
void MachineProblem::number_columns() {
    struct Entry {
        double angle;
        int block, variable;
    };
    std::vector<Entry> entries;
    for (int b = 0; b < axes(); ++b) {
        Block& block = blocks_[static_cast<std::size_t>(b)];
        const int size = block.problem->grid().shape().variables();
        const MotionFamily& design = block.problem->model().design;
        block.columns.resize(static_cast<std::size_t>(size));
        for (int j = 0; j < size; ++j) {
            const bool of_design = j < design.size();
            const std::optional<double> place = of_design ? design.place(j) : std::nullopt;
            double angle = infinity;
            if (of_design) angle = wrapped(block.spec.phase + place.value_or(0.0) * block.spec.unit_angle);
            entries.push_back({angle, b, j});
        }
    }
    std::ranges::stable_sort(entries, {}, &Entry::angle);
    for (const Entry& entry : entries)
        blocks_[static_cast<std::size_t>(entry.block)].columns[static_cast<std::size_t>(entry.variable)] =
            variables_++;
}

double MachineProblem::axis_place(int index, double angle) const {
    const Block& block = blocks_[static_cast<std::size_t>(index)];
    const MotionFamily& design = block.problem->model().design;
    const double x = wrapped(angle - block.spec.phase) / block.spec.unit_angle;
    return std::clamp(design.begin() + x, design.begin(), design.end());
}

/// Takes the new rows of every part and makes the grid of them; returns their number.
int MachineProblem::follow() {
    int added = 0;
    for (std::size_t part = 0; part < part_rows_.size(); ++part) {
        const int rows = part < blocks_.size()
                             ? blocks_[part].problem->grid().shape().constraints()
                             : static_cast<int>(clearances_[part - blocks_.size()].angles.size());
        for (int& known = part_rows_[part]; known < rows; ++known, ++added)
            rows_.push_back({static_cast<int>(part), known});
    }
    if (added > 0 || !grid_) grid_ = std::make_unique<Grid>(*this);
    return added;
}

const Nlp& MachineProblem::grid() const {
    return *grid_;
}

void MachineProblem::relax_only(std::string rule) {
    relaxed_ = std::move(rule);
    grid_ = std::make_unique<Grid>(*this);
}

Eigen::VectorXd MachineProblem::axis_x(int index, const Eigen::VectorXd& x) const {
    return x(blocks_[static_cast<std::size_t>(index)].columns);
}

std::vector<MotionChain> MachineProblem::motions(const Eigen::VectorXd& x) const {
    std::vector<MotionChain> all;
    all.reserve(blocks_.size());
    for (int b = 0; b < axes(); ++b) all.push_back(axis(b).motion(axis_x(b, x)));
    return all;
}

Eigen::VectorXd MachineProblem::start() const {
    if (start_.size() == variables_) return completed(start_);
    Eigen::VectorXd x(variables_);
    for (const Block& block : blocks_) x(block.columns) = block.problem->start();
    return x;
}

Eigen::VectorXd MachineProblem::completed(const Eigen::VectorXd& x) const {
    Eigen::VectorXd full(variables_);
    for (int b = 0; b < axes(); ++b)
        full(blocks_[static_cast<std::size_t>(b)].columns) = axis(b).completed(axis_x(b, x));
    return full;
}

double MachineProblem::objective(const Eigen::VectorXd& x) const {
    return grid_->cost(completed(x));
}

double MachineProblem::displacement(int index, const MotionChain& motion, double angle) const {
    const double x = axis_place(index, angle);
    return blocks_[static_cast<std::size_t>(index)].spec.lift * motion.at(x).derivative[0];
}

std::string MachineProblem::rule_name(int block, int rule) const {
    const Block& own = blocks_[static_cast<std::size_t>(block)];
    const CamModel& model = own.problem->model();
    auto index = static_cast<std::size_t>(rule);
    std::string name;
    if (index < model.rules.size()) {
        name = model.rules[index]->origin().rule;
    } else if ((index -= model.rules.size()) < model.parameter_rows.size()) {
        name = model.parameter_rows[index].name;
    } else {
        name = model.design_rows[index - model.parameter_rows.size()].name;
    }
    return own.spec.name + ": " + name;
}

std::vector<Violation> MachineProblem::violations(const Eigen::VectorXd& x, double slack) const {
    std::vector<Violation> found;
    for (int b = 0; b < axes(); ++b)
        for (Violation& violation : axis(b).violations(axis_x(b, x), slack)) {
            if (violation.limit && !relaxed_.empty())
                violation.limit = is_limit(rule_name(b, violation.rule));
            violation.rule += blocks_[static_cast<std::size_t>(b)].first_rule;
            found.push_back(std::move(violation));
        }
    if (!clearances_.empty()) {
        const std::vector<MotionChain> curves = motions(x);
        for (std::size_t k = 0; k < clearances_.size(); ++k)
            for (const Extremum& maximum : maxima_of(clearances_[k], curves, -slack))
                found.push_back({first_clearance_ + static_cast<int>(k), maximum, maximum.value,
                                 is_limit(clearances_[k].rule.name)});
    }
    std::ranges::stable_sort(found, std::greater{}, &Violation::amount);
    return found;
}

double MachineProblem::worst_of_limits(const Eigen::VectorXd& x) const {
    if (!relaxed_.empty()) return ContinuousProblem::worst_of_limits(x);
    double worst = -1.0;
    for (int b = 0; b < axes(); ++b) worst = std::max(worst, axis(b).worst_of_limits(axis_x(b, x)));
    if (clearances_.empty()) return worst;
    const std::vector<MotionChain> curves = motions(x);
    for (const Clear& clear : clearances_)
        for (const Extremum& maximum : maxima_of(clear, curves, worst))
            worst = std::max(worst, maximum.value);
    return worst;
}

Extremum MachineProblem::worst_of_clearance(int clearance, const Eigen::VectorXd& x) const {
    Extremum worst{-infinity, 0.0};
    for (const Extremum& maximum :
         maxima_of(clearances_[static_cast<std::size_t>(clearance)], motions(x), -infinity))
        if (maximum.value > worst.value) worst = maximum;
    worst.at = wrapped(worst.at);
    return worst;
}

int MachineProblem::refine(std::span<const Violation> worst) {
    return refined(worst, nullptr);
}

int MachineProblem::refine_pressed(std::span<const Violation> worst, const Eigen::VectorXd& row_multipliers) {
    return refined(worst, &row_multipliers);
}

int MachineProblem::refined(std::span<const Violation> worst, const Eigen::VectorXd* row_multipliers) {
    std::vector<std::vector<Violation>> own(blocks_.size());
    for (const Violation& violation : worst) {
        if (violation.rule >= first_clearance_) {
            Clear& clear = clearances_[static_cast<std::size_t>(violation.rule - first_clearance_)];
            const int part = axes() + violation.rule - first_clearance_;
            if (row_multipliers) add_pressed(clear, part, violation.where.at, *row_multipliers);
            add_around(clear, violation.where.at);
            continue;
        }
        std::size_t block = blocks_.size() - 1;
        while (violation.rule < blocks_[block].first_rule) --block;
        own[block].push_back(violation);
        own[block].back().rule -= blocks_[block].first_rule;
    }
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
        if (own[b].empty()) continue;
        CamProblem& problem = *blocks_[b].problem;
        if (!row_multipliers) {
            problem.refine(own[b]);
            continue;
        }
        Eigen::VectorXd multipliers(problem.grid().shape().constraints());
        for (std::size_t i = 0; i < rows_.size(); ++i)
            if (rows_[i].part == static_cast<int>(b))
                multipliers[rows_[i].row] = (*row_multipliers)[static_cast<Eigen::Index>(i)];
        problem.refine_pressed(own[b], multipliers);
    }
    return follow();
}

/// False: a row is there already.
bool MachineProblem::add_angle(Clear& clear, double angle) {
    const auto next = clear.places.lower_bound(angle - same_angle);
    if (next != clear.places.end() && next->first <= angle + same_angle) return false;
    clear.places.emplace(angle, static_cast<int>(clear.angles.size()));
    clear.angles.push_back(angle);
    return true;
}

/// A row at a maximum, and one on either side towards the nearest row or breakpoint.
void MachineProblem::add_around(Clear& clear, double angle) {
    const auto after_break = std::ranges::upper_bound(clear.breaks, angle);
    double right = after_break == clear.breaks.end() ? clear.breaks.back() : *after_break;
    double left = after_break == clear.breaks.begin() ? clear.breaks.front() : *std::prev(after_break);
    const auto after = clear.places.upper_bound(angle + same_angle);
    const auto before = clear.places.lower_bound(angle - same_angle);
    if (after != clear.places.end()) right = std::min(right, after->first);
    if (before != clear.places.begin()) left = std::max(left, std::prev(before)->first);
    if (!add_angle(clear, angle)) return;
    if (angle - left > same_angle) add_angle(clear, angle - bracket * (angle - left));
    if (right - angle > same_angle) add_angle(clear, angle + bracket * (right - angle));
}

/// Between active rows on both sides of a maximum their weighted mean locates it to second order.
void MachineProblem::add_pressed(Clear& clear, int part, double angle,
                                 const Eigen::VectorXd& row_multipliers) {
    const auto after = clear.places.lower_bound(angle);
    if (after == clear.places.end() || after == clear.places.begin()) return;
    const auto before = std::prev(after);
    double left = 0.0, right = 0.0, largest = 0.0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (rows_[i].part != part) continue;
        const double multiplier = std::max(0.0, row_multipliers[static_cast<Eigen::Index>(i)]);
        largest = std::max(largest, multiplier);
        if (rows_[i].row == before->second) left = multiplier;
        if (rows_[i].row == after->second) right = multiplier;
    }
    if (!(std::min(left, right) > idle_row * std::max(largest, 1e-300))) return;
    const double width = after->first - before->first;
    const double at = (left * before->first + right * after->first) / (left + right);
    const double reach = std::max(closest_pair, pair_reach * width) * width;
    for (const double place : {at, at - reach, at + reach})
        if (place > before->first + too_close * width && place < after->first - too_close * width)
            add_angle(clear, place);
}

Box MachineProblem::box(double incumbent, double relaxation) const {
    Box box{Eigen::VectorXd(variables_), Eigen::VectorXd(variables_)};
    for (const Block& block : blocks_) {
        // No objective is negative: each is at most the total.
        const Box own = block.problem->box(incumbent / block.spec.weight, relaxation);
        box.lower(block.columns) = own.lower;
        box.upper(block.columns) = own.upper;
    }
    return box;
}

bool MachineProblem::convex(double incumbent) const {
    return std::ranges::all_of(
        blocks_, [&](const Block& block) { return block.problem->convex(incumbent / block.spec.weight); });
}

std::vector<double> MachineProblem::samples(int clearance) const {
    return clearances_[static_cast<std::size_t>(clearance)].angles;
}

MachineOrigin MachineProblem::place(const RowOrigin& origin) const {
    MachineOrigin place;
    for (std::size_t k = 0; k < clearances_.size(); ++k)
        if (clearances_[k].rule.name == origin.rule) {
            place.clearance = static_cast<int>(k);
            place.angle = wrapped(origin.at.value_or(0.0));
            return place;
        }
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
        const AxisPlace& spec = blocks_[b].spec;
        if (!origin.rule.starts_with(spec.name + ": ")) continue;
        place.axis = static_cast<int>(b);
        place.rule = origin.rule.substr(spec.name.size() + 2);
        place.angle = wrapped(spec.phase + origin.at.value_or(0.0) * spec.unit_angle);
    }
    return place;
}

}  // namespace camopt
