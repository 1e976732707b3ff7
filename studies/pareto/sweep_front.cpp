// SPDX-License-Identifier: MIT
#include "studies/pareto/sweep_front.hpp"

#include "objectives/scene_model.hpp"
#include "studies/sweep/sweep_axis.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr double absent = std::numeric_limits<double>::quiet_NaN();  // no comparison with it is true

double criterion_of(const SweepRow& row, std::string_view name) {
    for (int i = 0; i < sweep_figure_count; ++i)
        if (name == name_of(static_cast<SweepFigure>(i)))
            return row.figures[static_cast<std::size_t>(i)].value_or(absent);
    if (name == "residual") return row.train.residual.value_or(absent);
    if (name == "dynamic_acceleration") return row.train.dynamic_acceleration.value_or(absent);
    if (name == "motor_torque") return row.drive.torque.value_or(absent);
    if (name == "motor_torque_rms") return row.drive.rms_torque.value_or(absent);
    for (int i = 0; i < dimension_count; ++i)
        if (name == name_of(static_cast<DimensionIndex>(i)))
            return std::abs(row.dimensions[static_cast<std::size_t>(i)].value_or(absent));
    return absent;
}

/// The settings that are no weights.
std::vector<double> question_of(const SweepColumns& columns, const SweepRow& row) {
    std::vector<double> question;
    for (std::size_t i = 0; i < columns.keys.size(); ++i)
        if (!is_weight_key(columns.keys[i])) question.push_back(row.settings[i]);
    return question;
}

struct Contender {
    SweepRow* row = nullptr;
    std::vector<double> criteria;
};

double front_width(double criterion) {
    return front_tolerance * std::abs(criterion);
}

bool dominates(const Contender& winner, const Contender& loser) {
    bool better = false;
    for (std::size_t i = 0; i < winner.criteria.size(); ++i) {
        const double width = front_width(loser.criteria[i]);
        if (winner.criteria[i] > loser.criteria[i] + width) return false;
        if (winner.criteria[i] < loser.criteria[i] - width) better = true;
    }
    return better;
}

/// Contenders in boxes within boxes, halved by one criterion after another: most boxes hold nobody who could
/// dominate, so a million rows are compared in seconds and not in the square of their number.
class FrontTree {
 public:
    explicit FrontTree(std::vector<Contender>& contenders) : contenders_(contenders) {
        if (!contenders.empty()) build(0, contenders.size(), 0);
    }

    [[nodiscard]] bool has_winner_over(const Contender& loser) const {
        return !boxes_.empty() && holds_winner(0, loser);
    }

 private:
    static constexpr std::size_t most_in_leaf = 8;

    struct Box {
        std::size_t begin = 0, end = 0;    ///< of the contenders
        std::size_t lower = 0, upper = 0;  ///< boxes of its halves; 0: none
        std::vector<double> least;         ///< by criterion
    };

    /// What is absent is never worse: it bounds nothing.
    static double bound(double criterion) {
        return !std::isnan(criterion) ? criterion : -std::numeric_limits<double>::infinity();
    }

    std::size_t build(std::size_t begin, std::size_t end, std::size_t criterion) {
        const std::size_t number = boxes_.size();
        Box box{begin, end, 0, 0, {}};
        for (const double value : contenders_[begin].criteria) box.least.push_back(bound(value));
        for (std::size_t k = begin + 1; k < end; ++k)
            for (std::size_t i = 0; i < box.least.size(); ++i)
                box.least[i] = std::min(box.least[i], bound(contenders_[k].criteria[i]));
        const std::size_t criteria = box.least.size();
        boxes_.push_back(std::move(box));
        if (end - begin <= most_in_leaf || criteria == 0) return number;
        const std::size_t middle = begin + (end - begin) / 2;
        const auto at = [&](std::size_t k) { return contenders_.begin() + static_cast<std::ptrdiff_t>(k); };
        std::nth_element(at(begin), at(middle), at(end), [&](const Contender& one, const Contender& other) {
            return bound(one.criteria[criterion]) < bound(other.criteria[criterion]);
        });
        const std::size_t next = (criterion + 1) % criteria;
        const std::size_t lower = build(begin, middle, next), upper = build(middle, end, next);
        boxes_[number].lower = lower;
        boxes_[number].upper = upper;
        return number;
    }

    /// False: whoever is in the box is worse in something, or nobody in it is better in anything.
    static bool may_hold_winner(const Box& box, const Contender& loser) {
        bool better = false;
        for (std::size_t i = 0; i < box.least.size(); ++i) {
            const double width = front_width(loser.criteria[i]);
            if (box.least[i] > loser.criteria[i] + width) return false;
            if (box.least[i] < loser.criteria[i] - width) better = true;
        }
        return better;
    }

    [[nodiscard]] bool holds_winner(std::size_t number, const Contender& loser) const {
        const Box& box = boxes_[number];
        if (!may_hold_winner(box, loser)) return false;
        if (box.upper != 0) return holds_winner(box.lower, loser) || holds_winner(box.upper, loser);
        for (std::size_t k = box.begin; k < box.end; ++k)
            if (dominates(contenders_[k], loser)) return true;
        return false;
    }

    std::vector<Contender>& contenders_;
    std::vector<Box> boxes_;
};

const FrontFigure* figure_of(const FrontGoal& goal) {
    return std::get_if<FrontFigure>(&goal);
}

/// A front divides a dimension by its range: one that passes zero trades by its magnitude, which is no goal.
bool is_goal(const Dimension& dimension) {
    return dimension.is_variable() && dimension.low >= 0.0;
}

std::vector<FrontGoal> goals_of(const Scene& scene) {
    std::vector<FrontGoal> goals;
    for (const CostTerm& term : cost_terms())
        if (term.traded) goals.emplace_back(term.figure);
    for (int d = 0; scene.cam && d < dimension_count; ++d) {
        const auto which = static_cast<DimensionIndex>(d);
        const Dimension* const own = scene.cam->find(which);
        if (own != nullptr && is_goal(*own)) goals.emplace_back(which);
    }
    return goals;
}

const std::optional<PeakLimit>& peak_limit(const Scene& scene, FrontFigure figure) {
    static const std::optional<PeakLimit> none;
    const auto member = cost_term(figure).limit;
    return member != nullptr ? scene.limits.*member : none;
}

}  // namespace

void mark_front(SweepTable& table) {
    std::map<std::vector<double>, std::vector<Contender>> questions;
    for (SweepRow& row : table.rows) {
        row.on_front = false;
        if (!row.is_feasible()) continue;
        Contender contender{&row, {}};
        for (const std::string& name : table.columns.criteria)
            contender.criteria.push_back(criterion_of(row, name));
        questions[question_of(table.columns, row)].push_back(std::move(contender));
    }
    for (auto& [question, contenders] : questions) {
        const FrontTree tree(contenders);
        for (const Contender& one : contenders) one.row->on_front = !tree.has_winner_over(one);
    }
}

std::string name_of(const FrontGoal& goal) {
    if (const FrontFigure* figure = figure_of(goal)) return name_of(*figure);
    return name_of(std::get<DimensionIndex>(goal));
}

FrontGoal front_goal(std::string_view name, const Scene& scene) {
    std::vector<std::string> names;
    for (const FrontGoal& goal : goals_of(scene)) {
        names.push_back(name_of(goal));
        if (names.back() == name) return goal;
    }
    throw InputError(fmt::format("a front of \"{}\": this scene has {}{}", name, fmt::join(names, ", "),
                                 scene.cam ? " (dimensions need a range { min, max } from 0 upwards)" : ""));
}

bool can_be_capped(const Scene& scene, const FrontGoal& goal) {
    const FrontFigure* const figure = figure_of(goal);
    if (figure == nullptr) return true;
    if (cost_term(*figure).limit == nullptr) return false;
    const std::optional<PeakLimit>& own = peak_limit(scene, *figure);
    // Such a limit holds for the motion, not for the peak normalised by segment; there is room for one only.
    return !(own && own->physical() && scene.motion.type == MotionType::program);
}

std::optional<double> limit_on(const Scene& scene, const FrontGoal& goal) {
    if (const FrontFigure* figure = figure_of(goal)) {
        const std::optional<PeakLimit>& own = peak_limit(scene, *figure);
        return own && can_be_capped(scene, goal) ? std::optional(own->normalised) : std::nullopt;
    }
    return scene.cam->find(std::get<DimensionIndex>(goal))->high;
}

void set_cap(Scene& scene, const FrontGoal& goal, double value) {
    if (const FrontFigure* figure = figure_of(goal)) {
        std::optional<PeakLimit>& limit = scene.limits.*cost_term(*figure).limit;
        const double unit = limit ? limit->unit_per_normalised() : 1.0;
        if (!limit) limit = PeakLimit{value, "limits." + name_of(goal), value, ""};
        limit->normalised = value;
        limit->given = value * unit;
        return;
    }
    const auto which = std::get<DimensionIndex>(goal);
    const double low = scene.cam->find(which)->low;
    scene.cam->set(which, {low, std::max(value, low)});
}

CapSetting cap_setting(const Scene& scene, const FrontGoal& goal, double value) {
    if (const FrontFigure* figure = figure_of(goal)) {
        const std::optional<PeakLimit>& limit = peak_limit(scene, *figure);
        if (!limit) return {"limits." + name_of(goal), value};
        return {limit->key, value * limit->unit_per_normalised()};
    }
    const Dimension& dimension = *scene.cam->find(std::get<DimensionIndex>(goal));
    return {dimension.key + ".max", std::max(value, dimension.low) / dimension.unit};
}

double weight_of(const Scene& scene, const FrontGoal& goal) {
    if (const FrontFigure* figure = figure_of(goal)) return scene.objective.*cost_term(*figure).weight;
    return scene.objective.dimensions[static_cast<std::size_t>(std::get<DimensionIndex>(goal))];
}

void set_weight(Scene& scene, const FrontGoal& goal, double weight) {
    if (const FrontFigure* figure = figure_of(goal)) {
        scene.objective.*cost_term(*figure).weight = weight;
        return;
    }
    scene.objective.dimensions[static_cast<std::size_t>(std::get<DimensionIndex>(goal))] = weight;
}

void scale_weights(Scene& scene, double factor) {
    for (const ObjectiveWeight& weight : objective_weights()) weight.in(scene.objective) *= factor;
}

double value_of(const SweepRow& row, const FrontGoal& goal) {
    const FrontFigure* const figure = figure_of(goal);
    const std::optional<double>& value =
        figure != nullptr ? row.figure(*figure) : row.dimension(std::get<DimensionIndex>(goal));
    return value.value_or(absent);
}

double reference_of(const Scene& scene, const FrontGoal& goal) {
    const FrontFigure* const figure = figure_of(goal);
    if (figure == nullptr) return dimension_unit(scene);
    return cost_term(*figure).measured.of(reference_peaks(scene));
}

}  // namespace camopt
