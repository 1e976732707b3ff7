// SPDX-License-Identifier: MIT
#include "objectives/machine/machine_problem.hpp"

#include <iterator>
#include <numeric>

namespace camopt {

namespace {

// Of the first grid of a clearance, over a whole cycle.
constexpr int first_angles = 24;

double wrapped(double angle) {
    const double rest = std::fmod(angle, units::turn);
    return rest < 0.0 ? rest + units::turn : rest;
}

}  // namespace

/// The Nlp of the current rows.
class MachineProblem::Grid final : public Nlp {
 public:
    explicit Grid(const MachineProblem& machine)
        : machine_(machine),
          row_of_(machine.blocks_.size() + machine.clearances_.size()),
          clear_(machine.clearances_.size()) {
        const auto rows = static_cast<Eigen::Index>(machine.rows_.size());
        shape_.x_lower.resize(machine.variables_);
        shape_.x_upper.resize(machine.variables_);
        shape_.g_lower = Eigen::VectorXd::Constant(rows, -infinity);
        shape_.g_upper = Eigen::VectorXd::Zero(rows);
        shape_.rows.resize(machine.rows_.size());
        shape_.convex = shape_.linear_cost = shape_.quadratic_cost = true;
        for (std::size_t i = 0; i < machine.rows_.size(); ++i)
            row_of_[machine.rows_[i].part].push_back(static_cast<int>(i));
        for (int b = 0; b < machine.axes(); ++b) add_block_pattern(b);
        add_clearances();
    }

    [[nodiscard]] double cost(const ConstVectorRef& x) const override {
        double sum = 0.0;
        for (int b = 0; b < machine_.axes(); ++b)
            sum += machine_.blocks_[b].spec.weight * machine_.axis(b).grid().cost(machine_.axis_x(b, x));
        return sum;
    }
    void gradient(const ConstVectorRef& x, VectorRef out) const override {
        for (int b = 0; b < machine_.axes(); ++b) {
            const Block& block = machine_.blocks_[b];
            const Eigen::VectorXd own = machine_.axis_x(b, x);
            Eigen::VectorXd slope(own.size());
            block.problem->grid().gradient(own, slope);
            out(block.columns) = block.spec.weight * slope;
        }
    }
    void constraints(const ConstVectorRef& x, VectorRef out) const override {
        for (int b = 0; b < machine_.axes(); ++b) {
            const Nlp& grid = machine_.axis(b).grid();
            Eigen::VectorXd values(grid.shape().constraints());
            grid.constraints(machine_.axis_x(b, x), values);
            out(row_of_[b]) = values;
        }
        for (std::size_t k = 0; k < clear_.size(); ++k)
            for (std::size_t i = 0; i < clear_[k].size(); ++i) {
                const Row& row = clear_[k][i];
                double value = row.offset;
                for (std::size_t j = 0; j < row.columns.size(); ++j)
                    value += row.weights[j] * x[row.columns[j]];
                out[row_of_[machine_.blocks_.size() + k][i]] = value;
            }
    }
    void jacobian(const ConstVectorRef& x, std::span<double> out) const override {
        std::size_t next = 0;
        for (int b = 0; b < machine_.axes(); ++b) {
            const Nlp& grid = machine_.axis(b).grid();
            const auto count = static_cast<std::size_t>(grid.shape().jacobian.size());
            grid.jacobian(machine_.axis_x(b, x), out.subspan(next, count));
            next += count;
        }
        for (const std::vector<Row>& rows : clear_)
            for (const Row& row : rows)
                for (const double weight : row.weights) out[next++] = weight;
    }
    void hessian(const ConstVectorRef& x, double sigma, const ConstVectorRef& lambda,
                 std::span<double> out) const override {
        std::size_t next = 0;
        for (int b = 0; b < machine_.axes(); ++b) {
            const Block& block = machine_.blocks_[b];
            const Nlp& grid = block.problem->grid();
            const auto count = static_cast<std::size_t>(grid.shape().hessian.size());
            const Eigen::VectorXd own = lambda(row_of_[b]);
            grid.hessian(machine_.axis_x(b, x), sigma * block.spec.weight, own, out.subspan(next, count));
            next += count;
        }
    }
    [[nodiscard]] std::string variable_name(int index) const override {
        for (const Block& block : machine_.blocks_)
            if (const auto found = std::ranges::find(block.columns, index); found != block.columns.end())
                return block.spec.name + ": " +
                       block.problem->grid().variable_name(static_cast<int>(found - block.columns.begin()));
        return {};
    }
    [[nodiscard]] std::string row_name(int index) const override { return row_origin(index).text(); }
    [[nodiscard]] RowOrigin row_origin(int index) const override {
        const RowPlace& place = machine_.rows_[index];
        const int clearance = place.part - machine_.axes();
        if (clearance >= 0) {
            const Clear& clear = machine_.clearances_[clearance];
            RowOrigin origin;
            origin.rule = origin.fields.key = clear.rule.key;
            origin.at = clear.angles[place.row];
            origin.limit = true;
            origin.order = 0;
            return origin;
        }
        const Block& block = machine_.blocks_[place.part];
        RowOrigin origin = block.problem->grid().row_origin(place.row);
        origin.rule = block.spec.name + ": " + origin.rule;
        origin.fields.axis = block.spec.name;
        return origin;
    }

 private:
    /// A clearance at one angle, affine in the designs.
    struct Row {
        std::vector<int> columns;
        std::vector<double> weights;
        double offset = 0.0;
    };
    [[nodiscard]] Row clearance_row(const Clear& clear, double angle) const {
        Row row;
        row.offset = -clear.rule.bound / clear.rule.scale;
        for (std::size_t k = 0; k < clear.rule.axes.size(); ++k) {
            const Block& block = machine_.blocks_[clear.rule.axes[k]];
            const CamModel& model = block.problem->model();
            const double size = clear.rule.weight(k, block.spec.lift);
            const OwnPlace place = machine_.axis_place(clear.rule.axes[k], angle);
            const AffineRow y = model.design.functional(place.x, 0);
            row.offset += size * (y.offset + place.advanced);
            for (std::size_t j = 0; j < y.columns.size(); ++j) {
                if (y.weights[j] == 0.0) continue;
                row.columns.push_back(block.columns[y.columns[j]]);
                row.weights.push_back(size * y.weights[j] * variable_scale(model, y.columns[j]));
            }
        }
        return row;
    }
    void add_block_pattern(int block) {
        const Block& own = machine_.blocks_[block];
        const NlpShape& shape = own.problem->grid().shape();
        const std::vector<int>& rows = row_of_[block];
        shape_.x_lower(own.columns) = shape.x_lower;
        shape_.x_upper(own.columns) = shape.x_upper;
        shape_.g_lower(rows) = shape.g_lower;
        shape_.g_upper(rows) = shape.g_upper;
        shape_.convex = shape_.convex && shape.convex;
        shape_.linear_cost = shape_.linear_cost && shape.linear_cost;
        shape_.quadratic_cost = shape_.quadratic_cost && shape.quadratic_cost;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            RowKind& kind = shape_.rows[rows[i]] = shape.rows[i];
            if (kind.limit && !machine_.relaxed_.empty())
                kind.limit = machine_.is_limit(own.spec.name + ": " +
                                               own.problem->grid().row_origin(static_cast<int>(i)).rule);
        }
        for (const int row : shape.jacobian.rows) shape_.jacobian.rows.push_back(rows[row]);
        for (const int column : shape.jacobian.columns)
            shape_.jacobian.columns.push_back(own.columns[column]);
        for (int k = 0; k < shape.hessian.size(); ++k) {
            const auto entry = static_cast<std::size_t>(k);
            const int row = own.columns[shape.hessian.rows[entry]];
            const int column = own.columns[shape.hessian.columns[entry]];
            shape_.hessian.rows.push_back(std::max(row, column));
            shape_.hessian.columns.push_back(std::min(row, column));
        }
    }
    void add_clearances() {
        for (std::size_t k = 0; k < machine_.clearances_.size(); ++k) {
            const Clear& clear = machine_.clearances_[k];
            const std::vector<int>& rows = row_of_[machine_.blocks_.size() + k];
            for (std::size_t i = 0; i < rows.size(); ++i) {
                Row row = clearance_row(clear, clear.angles[i]);
                shape_.rows[rows[i]] = {true, machine_.is_limit(clear.rule.key), 1.0};
                shape_.jacobian.rows.insert(shape_.jacobian.rows.end(), row.columns.size(), rows[i]);
                shape_.jacobian.columns.insert(shape_.jacobian.columns.end(), row.columns.begin(),
                                               row.columns.end());
                clear_[k].push_back(std::move(row));
            }
        }
    }

    const MachineProblem& machine_;
    std::vector<std::vector<int>> row_of_;  ///< of each part's row, the machine's
    std::vector<std::vector<Row>> clear_;   ///< of each clearance
};

MachineProblem::MachineProblem(std::vector<MachineBlock> blocks, std::vector<ClearanceRule> clearances) {
    for (MachineBlock& given : blocks) {
        Block block;
        block.problem = std::make_unique<CamProblem>(std::move(given.model), given.samples);
        const CamModel& model = block.problem->model();
        block.first_rule = first_clearance_;
        first_clearance_ += static_cast<int>(model.rules.size() + model.parameter_rows.size());
        block.spec = std::move(given.place);
        blocks_.push_back(std::move(block));
    }
    number_columns();
    for (ClearanceRule& rule : clearances) {
        Clear clear{std::move(rule)};
        if (clear.rule.from >= units::turn) clear.rule.from -= units::turn;
        clear.length = clear.rule.until - clear.rule.from;
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
        Block& block = blocks_[b];
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
    for (const Entry& entry : entries) blocks_[entry.block].columns[entry.variable] = variables_++;
}

MachineProblem::OwnPlace MachineProblem::axis_place(int index, double angle) const {
    const AxisPlace& spec = blocks_[index].spec;
    const MotionFamily& design = blocks_[index].problem->model().design;
    double master = angle <= units::turn + same_angle ? angle : angle - units::turn;
    if (angle > units::turn && master <= after_fall + same_angle) master = 0.0;  // 2π + after_fall is rounded
    const double cycles = std::floor((master - spec.phase) / units::turn);
    const double x = (master - spec.phase - units::turn * cycles) / spec.unit_angle;
    return {std::clamp(design.begin() + x, design.begin(), design.end()),
            spec.advance * (cycles - (spec.phase < 0.0 ? 1.0 : 0.0))};
}

bool MachineProblem::falls_back(const Clear& clear) const {
    return std::ranges::any_of(clear.rule.axes,
                               [&](int index) { return blocks_[index].spec.advance != 0.0; });
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
    return x(blocks_[index].columns);
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
    for (int b = 0; b < axes(); ++b) full(blocks_[b].columns) = axis(b).completed(axis_x(b, x));
    return full;
}

double MachineProblem::objective(const Eigen::VectorXd& x) const {
    return grid_->cost(completed(x));
}

double MachineProblem::displacement(int index, const MotionChain& motion, double angle) const {
    const OwnPlace place = axis_place(index, angle);
    return blocks_[index].spec.lift * (motion.at(place.x).derivative[0] + place.advanced);
}

std::string MachineProblem::rule_name(int block, int rule) const {
    const Block& own = blocks_[block];
    const CamModel& model = own.problem->model();
    const auto index = static_cast<std::size_t>(rule);
    const std::size_t rules = model.rules.size();
    return own.spec.name + ": " +
           (index < rules ? model.rules[index]->origin().rule : model.parameter_rows[index - rules].name);
}

std::vector<Violation> MachineProblem::violations(const Eigen::VectorXd& x, double slack) const {
    std::vector<Violation> found;
    for (int b = 0; b < axes(); ++b)
        for (Violation& violation : axis(b).violations(axis_x(b, x), slack)) {
            if (violation.limit && !relaxed_.empty())
                violation.limit = is_limit(rule_name(b, violation.rule));
            violation.rule += blocks_[b].first_rule;
            found.push_back(std::move(violation));
        }
    if (!clearances_.empty()) {
        const std::vector<MotionChain> curves = motions(x);
        for (std::size_t k = 0; k < clearances_.size(); ++k)
            for (const Extremum& maximum : maxima_of(clearances_[k], curves, -slack))
                found.push_back({first_clearance_ + static_cast<int>(k), maximum, maximum.value,
                                 is_limit(clearances_[k].rule.key)});
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
    for (const Extremum& maximum : maxima_of(clearances_[clearance], motions(x), -infinity))
        raise_to(worst, maximum);
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
            Clear& clear = clearances_[violation.rule - first_clearance_];
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
    const auto least = [&](const Block& block) {
        return block.spec.weight * block.problem->least_cost(incumbent / block.spec.weight);
    };
    double rest = incumbent;  // what the total leaves each, where every other one is at its least
    for (const Block& block : blocks_) rest -= least(block);
    for (const Block& block : blocks_) {
        const Box own = block.problem->box((rest + least(block)) / block.spec.weight, relaxation);
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
    return clearances_[clearance].angles;
}

MachineOrigin MachineProblem::place(const RowOrigin& origin) const {
    MachineOrigin place;
    for (std::size_t k = 0; k < clearances_.size(); ++k)
        if (clearances_[k].rule.key == origin.rule) {
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
