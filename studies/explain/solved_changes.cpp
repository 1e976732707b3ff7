// SPDX-License-Identifier: MIT
#include "studies/explain/solved_changes.hpp"

#include "studies/least/feasible_edge.hpp"
#include "studies/search/planned_solve.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// Where the search's word was too good: how much further off a solve is tried, of the size.
constexpr double further_off[] = {0.0, 1e-4, 1e-3, 1e-2, 5e-2};
// Of a value that is determined: what is left of it after rounding errors are dropped.
constexpr int exact_digits = 9;

constexpr double first_part = 0.02, most_part = 1e3;
// The common part is found to this part of itself: finer than the digits it is told with.
constexpr double part_accuracy = 1e-7;
// A limit that could give way by less than this part less stays: the search is not exact.
constexpr double noticeably_less = 1e-2;
// How much more than the least part a solve is tried with.
constexpr double larger_factors[] = {0.0, 1e-3, 1e-2, 1e-1};

class JointSearch {
 public:
    JointSearch(const Scene& scene, std::vector<Adjustment> members, const Budget& budget)
        : scene_(scene), members_(std::move(members)), budget_(budget) {
        std::erase_if(members_, [](const Adjustment& one) {
            return (one.may_grow ? one.most : one.least) == one.given;
        });
    }

    [[nodiscard]] std::vector<Relaxation> run() {
        if (members_.empty()) return {};
        const double part = least_part();
        if (!(part > 0.0)) return {};
        std::vector<double> parts(members_.size(), part);
        give_back(parts);
        for (const double more : larger_factors) {
            Scene changed = scene_;
            std::vector<Relaxation> rows = rounded(parts, 1.0 + more, changed);
            if (is_solved(changed, budget_)) return rows;
            if (budget_.spent()) break;
        }
        return {};
    }

 private:
    const Scene& scene_;
    std::vector<Adjustment> members_;
    const Budget& budget_;

    [[nodiscard]] static double size_of(const Adjustment& one) {
        return std::max(std::abs(one.given), one.step);
    }
    /// An upper limit times 1 + part, a lower one divided by it: both give way by the same factor, and a
    /// least radius never comes to nothing.
    [[nodiscard]] static double value_of(const Adjustment& one, double part) {
        if (one.may_grow) return std::min(one.given + part * size_of(one), one.most);
        if (one.given > 0.0) return std::max(one.given / (1.0 + part), one.least);
        return std::max(one.given - part * size_of(one), one.least);
    }
    /// Of each member its own part; 0: it keeps its value.
    [[nodiscard]] double violation(const std::vector<double>& parts) const {
        Scene changed = scene_;
        for (std::size_t i = 0; i < members_.size(); ++i)
            if (parts[i] > 0.0) changed = members_[i].with(changed, value_of(members_[i], parts[i]));
        return least_violation(changed, budget_);
    }
    /// By the part of one member, the others as they are; of all: nothing.
    [[nodiscard]] ValueSearch search(std::vector<double> parts, std::optional<std::size_t> which) const {
        return {[this, parts = std::move(parts), which](double part) mutable {
                    if (which)
                        parts[*which] = part;
                    else
                        std::ranges::fill(parts, part);
                    return violation(parts);
                },
                [this] { return budget_.spent(); }};
    }
    [[nodiscard]] static double least_between(const ValueSearch& search, const ValueBracket& bracket) {
        return closed_in(search, bracket, part_accuracy * bracket.inside.value).inside.value;
    }
    /// 0: none found.
    [[nodiscard]] double least_part() const {
        const ValueSearch all = search(std::vector<double>(members_.size()), std::nullopt);
        const ValueMarch march = marched(all, {0.0, infinity}, first_part, most_part);
        return march.changed ? least_between(all, {*march.changed, march.last}) : 0.0;
    }
    /// One that has to give way far would take the others along further than they need.
    void give_back(std::vector<double>& parts) const {
        for (std::size_t i = parts.size(); i-- > 0;)
            if (!budget_.spent() && search(parts, i).at(0.0).feasible()) parts[i] = 0.0;
        for (std::size_t i = parts.size(); i-- > 0;) {
            if (parts[i] == 0.0 || budget_.spent()) continue;
            const ValueSearch one = search(parts, i);
            const ValueTrial less = one.at((1.0 - noticeably_less) * parts[i]);
            if (less.feasible()) parts[i] = least_between(one, {less, {}});
        }
    }
    /// `factor`: of every part. `changed`: gets the rows' values.
    [[nodiscard]] std::vector<Relaxation> rounded(const std::vector<double>& parts, double factor,
                                                  Scene& changed) const {
        std::vector<Relaxation> rows;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (parts[i] == 0.0) continue;
            const Adjustment& one = members_[i];
            const double needed = value_of(one, factor * parts[i]),
                         size = std::max(std::abs(needed), one.step);
            const double reported = std::clamp(safe_value(needed, one.may_grow, size),
                                               std::min(one.least, one.given), std::max(one.most, one.given));
            rows.push_back({one.key, one.given, needed, reported});
            changed = one.with(changed, reported);
        }
        return rows;
    }
};

constexpr int least_factor = 8;      // three doublings are always tried, but for
constexpr int most_segments = 512;   // splines that take longer than the explanation may
constexpr int enough_segments = 64;  // few segments are doubled on up to here

/// By the number of segments.
ValueSearch segment_search(const Scene& scene, const Budget& budget) {
    return {[&](double segments) {
                return least_violation(with_segments(scene, static_cast<int>(segments)), budget);
            },
            [&] { return budget.spent(); }, [](double segments) { return std::floor(segments); }};
}

bool is_told(const Scene& scene, int segments, const Budget& budget) {
    const bool uniform = scene.spline.breakpoints.empty();
    return is_solved(with_segments(scene, segments), budget) &&
           (!uniform || is_solved(with_segments(scene, segments + 1), budget));
}

}  // namespace

std::optional<Relaxation> solved_relaxation(const Scene& scene, const Adjustment& adjustment, double needed,
                                            const Budget& budget) {
    const bool up = needed > adjustment.given;
    const double size = std::max(std::abs(needed), adjustment.step);
    const auto solved = [&](double told) {
        return !budget.spent() && is_solved(adjustment.with(scene, told), budget);
    };
    const auto row = [&](double edge, double told) {
        Relaxation found{adjustment.key, adjustment.given, edge, told};
        if (adjustment.also) found.also = adjustment.also(told);
        return found;
    };
    for (const double margin : further_off) {
        const double edge = needed + (up ? margin : -margin) * size;
        // The end of a range needs no margin: there is nothing beyond it.
        const double told =
            std::clamp(safe_value(edge, up, size), std::min(adjustment.least, adjustment.given),
                       std::max(adjustment.most, adjustment.given));
        if (solved(told)) return row(margin == 0.0 ? needed : told, told);
    }
    const double scale =
        needed == 0.0 ? 1.0 : std::pow(10.0, exact_digits - std::ceil(std::log10(std::abs(needed))));
    for (const double told : {std::round(needed * scale) / scale, as_written(needed)})
        if (solved(told)) return row(needed, told);
    return {};
}

std::vector<Relaxation> joint_relaxation(const Scene& scene, const std::vector<Adjustment>& members,
                                         const Budget& budget) {
    return JointSearch(scene, members, budget).run();
}

FinerSpline finer_spline(const Scene& scene, const Budget& budget) {
    FinerSpline result;
    const int given = segments_of(scene.spline);
    const bool uniform = scene.spline.breakpoints.empty();
    const int most = std::min(most_segments, std::max(least_factor * given, enough_segments));
    int fails = given;
    for (int n = 2 * given; n <= most && !budget.spent(); n *= 2) {
        budget.say(fmt::format("suggested changes: {} segments", n));
        const ValueSearch search = segment_search(scene, budget);
        const ValueTrial tried = search.at(n);
        if (budget.spent()) break;
        if (tried.feasible()) {
            // The fewest above `fails`, of whole ones.
            const ValueBracket between{tried, {static_cast<double>(fails), infinity}};
            const int found = uniform ? static_cast<int>(closed_in(search, between, 1.0).inside.value) : n;
            for (const int told : {found, found + 1, found + 2, n}) {
                if (budget.spent()) return result;
                if (told > n || (!uniform && told != n) || !is_told(scene, told, budget)) continue;
                result.row =
                    Relaxation{uniform ? "spline.segments" : "spline.breakpoints", static_cast<double>(given),
                               static_cast<double>(told), static_cast<double>(told)};
                result.finest = 0;
                return result;
            }
            if (budget.spent()) break;  // what the clock ended does not count as tried
        }
        fails = n;
        result.finest = n;
    }
    return result;
}

}  // namespace camopt
