// SPDX-License-Identifier: MIT
#include "studies/pareto/pareto_front.hpp"

#include "core/word_of.hpp"
#include "scene/written_limits.hpp"
#include "studies/least/least_value.hpp"
#include "studies/pareto/front_chain.hpp"
#include "studies/sweep/row_chain.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// Rounds of correction: each moves every point by Newton-like interpolation, a handful is enough.
constexpr int most_front_rounds = 12;
// A front that is not connected, or badly solved, must end too: solves a spaced point.
constexpr int most_solves_per_point = 20;
// Corrected points aim at this part of what they may be off, so that the next round's lengths still fit.
constexpr double aim = 0.9;

class Tracer {
 public:
    Tracer(const Scene& scene, const FrontRequest& request, const RowRun& run)
        : scene_(scene), request_(request), run_(run) {
        std::array<Scene, 2> posed{scene_with(0, {}), scene_with(1, {})};
        ObjectiveSpec own = scene.objective;
        for (const ObjectiveWeight& weight : objective_weights())
            for (Scene& one : posed)
                if (weight.in(own) != weight.in(one.objective) &&
                    (weights_.empty() || weights_.back() != &weight))
                    weights_.push_back(&weight);
        table_.columns = columns_of(keys(), posed);
        table_.columns.front = true;
    }

    [[nodiscard]] ParetoFront trace() {
        const bool ends = find_ends();
        if (ends) {
            FrontChain chain(node(ends_[0]), node(ends_[1]));
            if (chain.has_extent()) {
                resolve_shape(chain);
                space(chain);
            }
            place_points(chain);
            judge_spacing(chain);
            sort_points(chain);
        }
        front_.request = request_;
        front_.columns = table_.columns;
        front_.complete = ends && !stopped_;
        std::ranges::stable_sort(points_, [](const FrontPoint& one, const FrontPoint& other) {
            if (one.is_feasible() != other.is_feasible()) return one.is_feasible();
            return one.is_feasible() && one.value[0] < other.value[0];
        });
        front_.points = std::move(points_);
        return std::move(front_);
    }

 private:
    [[nodiscard]] bool can_cap(int goal) const {
        if (goal == 0 && request_.keep_weights) return false;
        return can_be_capped(scene_, request_.goals[static_cast<std::size_t>(goal)]);
    }
    [[nodiscard]] Scene scene_with(int minimized, const std::optional<double>& cap) const {
        Scene scene = scene_;
        const auto& [first, second] = request_.goals;
        const double kept = weight_of(scene_, first);
        if (!request_.keep_weights) scale_weights(scene, 0.0);
        set_weight(scene, first, request_.keep_weights && kept > 0.0 ? kept : 1.0);
        if (minimized == 1) scale_weights(scene, lexicographic_weight);
        set_weight(scene, second, minimized == 1 ? 1.0 : lexicographic_weight);
        if (cap) set_cap(scene, request_.goals[static_cast<std::size_t>(1 - minimized)], *cap);
        return scene;
    }
    /// Every weight that some solve does not take from the scene as it is, and the caps.
    [[nodiscard]] std::vector<std::string> keys() const {
        std::vector<std::string> keys;
        for (const ObjectiveWeight* const weight : weights_) keys.push_back(weight->key);
        for (const int goal : {0, 1})
            if (can_cap(goal)) keys.push_back(cap_setting(scene_, request_.goals[goal], 0.0).key);
        return keys;
    }
    [[nodiscard]] std::vector<double> settings(Scene& posed, int minimized,
                                               const std::optional<double>& cap) const {
        std::vector<double> values;
        for (const ObjectiveWeight* const weight : weights_) values.push_back(weight->in(posed.objective));
        for (const int goal : {0, 1})
            if (can_cap(goal))
                values.push_back(cap && goal != minimized
                                     ? cap_setting(scene_, request_.goals[goal], *cap).value
                                     : std::numeric_limits<double>::quiet_NaN());
        return values;
    }
    [[nodiscard]] std::array<double, 2> values_of(const SweepRow& row, const Scene& posed,
                                                  int minimized) const {
        const auto& [first, second] = request_.goals;
        std::array<double, 2> value{value_of(row, first), value_of(row, second)};
        if (request_.keep_weights) {
            const double of_second = weight_of(posed, second) * value[1] / reference_of(scene_, second);
            value[0] = (*row.objective - of_second) / (minimized == 1 ? lexicographic_weight : 1.0);
        }
        return value;
    }
    /// What no curve can pass, for both goals; none where it is not known or not finite.
    void note_limit(SweepRow& row, const Solution& solution) const {
        if (!solution.any_curve_limit || request_.keep_weights) return;
        const LimitCurve& limit = *solution.any_curve_limit;
        std::array<std::optional<double>, 2> values;
        for (std::size_t i = 0; i < 2; ++i) {
            const auto* figure = std::get_if<FrontFigure>(&request_.goals[i]);
            if (figure == nullptr) continue;
            if (*figure == FrontFigure::velocity) values[i] = limit.velocity;
            if (*figure == FrontFigure::acceleration) values[i] = limit.acceleration;
            if (*figure == FrontFigure::jerk) values[i] = limit.jerk;
        }
        if (!values[0] || !values[1]) return;
        row.front.limit_first = values[0];
        row.front.limit_second = values[1];
    }
    [[nodiscard]] FrontNode node(int point) const {
        return {point, points_[static_cast<std::size_t>(point)].value};
    }
    /// The number of the new point; none where the control stopped it.
    std::optional<int> solve(int minimized, const std::optional<double>& cap) {
        if (stopped_) return {};
        Scene posed = scene_with(minimized, cap);
        const SweepRow* const row = chain_.solve(
            settings(posed, minimized, cap), [&] { return posed; },
            [this](SweepRow& solved, const Solution& solution) { note_limit(solved, solution); });
        stopped_ = row == nullptr;
        if (stopped_) return {};
        FrontPoint& point = points_.emplace_back();
        point.row = *row;
        point.minimized = minimized;
        point.cap = cap;
        if (point.is_feasible()) point.value = values_of(*row, posed, minimized);
        if (run_.row_done) run_.row_done(table_, std::nullopt);
        return row->number;
    }
    /// The end of least goal `end`, or where the cut-off puts it.
    [[nodiscard]] std::optional<int> end_within(int end, int other_end) {
        const auto other = static_cast<std::size_t>(1 - end);
        const int own = ends_[static_cast<std::size_t>(end)];
        const double most = request_.cut_off * points_[static_cast<std::size_t>(other_end)].value[other];
        FrontPoint& least = points_[static_cast<std::size_t>(own)];
        least.end = FrontEnd::attained;
        if (!(most > 0.0) || least.value[other] <= most || !can_cap(1 - end)) return own;
        const std::optional<int> cut = solve(end, most);
        if (!cut || !points_[static_cast<std::size_t>(*cut)].is_feasible())
            return cut ? std::optional(own) : cut;
        points_[static_cast<std::size_t>(own)].end = FrontEnd::beyond;
        points_[static_cast<std::size_t>(*cut)].end = FrontEnd::cut_off;
        return cut;
    }
    bool find_ends() {
        for (const int goal : {0, 1}) {
            const std::optional<int> end = solve(goal, std::nullopt);
            if (!end || !points_[static_cast<std::size_t>(*end)].is_feasible()) return false;
            ends_[static_cast<std::size_t>(goal)] = *end;
        }
        const std::array<int, 2> least = ends_;
        return std::ranges::all_of(std::array{0, 1}, [&](int goal) {
            const std::optional<int> end = end_within(goal, least[static_cast<std::size_t>(1 - goal)]);
            if (end) ends_[static_cast<std::size_t>(goal)] = *end;
            return end.has_value();
        });
    }
    /// One more point on a piece of the chain: capped in the goal that changes more there, so that halves of
    /// a piece are shorter than the whole.
    void solve_at(FrontChain& chain, const FrontTarget& target) {
        int capped = chain.change(target.after, 1) >= chain.change(target.after, 0) ? 1 : 0;
        if (!can_cap(capped)) capped = 1 - capped;
        const std::optional<int> found = solve(1 - capped, chain.value_within(target, capped));
        if (!found) return;
        if (points_[static_cast<std::size_t>(*found)].is_feasible())
            chain.insert(node(*found), target.after);
        else
            chain.close(target.after);
    }
    void resolve_shape(FrontChain& chain) {
        while (true) {
            const std::vector<double> arc = arc_lengths(chain.places());
            const int piece = longest_piece(chain.places());
            if (piece < 0 || !may_solve(arc.back())) return;
            const auto i = static_cast<std::size_t>(piece);
            if (arc[i + 1] - arc[i] <= arc.back() / (wanted_points(arc.back()) - 1)) return;
            solve_at(chain, {piece, 0.5});
        }
    }
    void space(FrontChain& chain) {
        for (int round = 0; round < most_front_rounds; ++round) {
            std::vector<FrontTarget> missing = missing_targets(chain);
            if (missing.empty()) return;
            // From the far end: new points leave the numbers of the pieces before them alone.
            for (std::size_t i = missing.size(); i-- > 0;) {
                if (!may_solve(arc_lengths(chain.places()).back())) return;
                if (missing[i].after + 1 < static_cast<int>(chain.nodes().size()))
                    solve_at(chain, missing[i]);
            }
        }
    }
    [[nodiscard]] int wanted_points(double length) const {
        if (!request_.spacing) return request_.points;
        return static_cast<int>(std::ceil(length * (1.0 + request_.evenness) / *request_.spacing)) + 1;
    }
    [[nodiscard]] bool may_solve(double length) const {
        return !stopped_ && static_cast<int>(points_.size()) < most_solves_per_point * wanted_points(length);
    }
    /// Where points of the even spacing are missing.
    [[nodiscard]] std::vector<FrontTarget> missing_targets(const FrontChain& chain) const {
        const std::vector<double> arc = arc_lengths(chain.places());
        const int count = wanted_points(arc.back());
        const double gap = arc.back() / (count - 1);
        std::vector<FrontTarget> missing;
        for (int k = 1; k + 1 < count; ++k) {
            const int nearest = nearest_place(arc, k * gap);
            const double off = std::abs(arc[static_cast<std::size_t>(nearest)] - k * gap);
            if (off > 0.5 * aim * request_.evenness * gap) missing.push_back(target_at(arc, k * gap));
        }
        return missing;
    }
    void place_points(const FrontChain& chain) {
        const std::vector<double> arc = arc_lengths(chain.places());
        const auto point_at = [&](int place) -> FrontPoint& {
            return points_[static_cast<std::size_t>(chain.nodes()[static_cast<std::size_t>(place)].point)];
        };
        for (std::size_t i = 0; i < arc.size(); ++i) point_at(static_cast<int>(i)).arc = arc[i];
        const int last = static_cast<int>(arc.size()) - 1;
        const int count = last == 0 ? 1 : wanted_points(arc.back());
        int place = 0;
        for (int k = 0; k < count; ++k) {
            const int nearest = k == 0           ? 0
                                : k + 1 == count ? last
                                                 : nearest_place(arc, k * arc.back() / (count - 1));
            FrontPoint& point = point_at(nearest);
            if (point.place < 0) point.place = place++;
        }
    }
    void sort_points(const FrontChain& chain) {
        std::vector<bool> on_chain(points_.size(), false);
        for (const FrontNode& node : chain.nodes()) on_chain[static_cast<std::size_t>(node.point)] = true;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            FrontPoint& point = points_[i];
            point.dominated = point.is_feasible() && !on_chain[i] && point.end != FrontEnd::beyond;
        }
    }
    void judge_spacing(const FrontChain& chain) {
        FrontSpacing& spacing = front_.spacing;
        std::vector<double> gaps;
        double before = 0.0;
        for (const FrontNode& node : chain.nodes()) {
            const FrontPoint& point = points_[static_cast<std::size_t>(node.point)];
            if (point.place > 0) gaps.push_back(point.arc - before);
            if (point.place >= 0) before = point.arc;
            spacing.length = point.arc;
        }
        for (const FrontPlace& place : chain.places()) spacing.jumps += place.jump_follows ? 1 : 0;
        if (gaps.empty()) return;
        spacing.least = std::ranges::min(gaps);
        spacing.most = std::ranges::max(gaps);
        spacing.mean = spacing.length / static_cast<double>(gaps.size());
        const double off = std::max(spacing.most - spacing.mean, spacing.mean - spacing.least);
        const int missing = wanted_points(spacing.length) - 1 - static_cast<int>(gaps.size());
        front_.even = off <= request_.evenness * spacing.mean && missing == 0 && spacing.jumps == 0 &&
                      (!request_.spacing || spacing.most <= *request_.spacing);
    }

    const Scene& scene_;
    const FrontRequest& request_;
    const RowRun& run_;
    std::vector<const ObjectiveWeight*> weights_;  ///< of the keys
    SweepTable table_;
    RowChain chain_{run_, table_};
    std::vector<FrontPoint> points_;
    std::array<int, 2> ends_{-1, -1};
    bool stopped_ = false;
    ParetoFront front_;
};

void require(bool right, const char* what, double found, const char* allowed) {
    if (!right) throw InputError(fmt::format("{}: found {}; allowed: {}", what, found, allowed));
}

}  // namespace

const char* name_of(FrontEnd value) {
    return word_of<FrontEnd::beyond>(value, {"", "attained", "cut_off", "beyond"});
}

void FrontRequest::validate(const Scene& scene) const {
    require(points >= 2 && points <= most_front_points, "points of the front", points,
            "an integer from 2 to 10000");
    require(!spacing || (*spacing >= least_front_spacing && *spacing <= 1.0), "spacing of the front",
            spacing.value_or(0.0), "a number from 0.0002 to 1");
    require(evenness > 0.0 && evenness < 1.0, "evenness of the front", evenness, "a number > 0 and < 1");
    require(cut_off > 1.0 && std::isfinite(cut_off), "cut-off of the front", cut_off, "a number > 1");
    refuse_sought_number(scene, "--pareto");
    if (goals[0] == goals[1])
        throw InputError(
            fmt::format("a front of {} against itself; allowed: two different goals", name_of(goals[0])));
    if ((keep_weights || !can_be_capped(scene, goals[0])) && !can_be_capped(scene, goals[1]))
        throw InputError(fmt::format(
            "a front of {} and {}: {} cannot be capped; allowed: {} a peak without a limit in time, or a "
            "dimension",
            name_of(goals[0]), name_of(goals[1]), keep_weights ? "the second" : "neither",
            keep_weights ? "as the second" : "one of the two"));
}

ParetoFront pareto_front(const Scene& scene, const FrontRequest& request, const RowRun& run) {
    const Scene written = valid_scene(scene);
    request.validate(written);
    return Tracer(written, request, run).trace();
}

SweepTable front_table(const ParetoFront& front) {
    SweepTable table{front.columns, {}};
    for (const FrontPoint& point : front.points) {
        SweepRow& row = table.rows.emplace_back(point.row);
        row.front.end = name_of(point.end);
        row.on_front = point.is_feasible() && !point.dominated && point.end != FrontEnd::beyond;
        if (!point.is_feasible()) continue;
        if (point.place >= 0) row.front.point = point.place;
        row.front.arc = point.arc;
        if (front.request.keep_weights) row.front.weighted = point.value[0];
    }
    std::ranges::sort(table.rows, {}, &SweepRow::number);
    return table;
}

}  // namespace camopt
