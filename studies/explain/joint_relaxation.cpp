// SPDX-License-Identifier: MIT
#include "studies/explain/joint_relaxation.hpp"

#include "core/numbers/scalar_search.hpp"
#include "studies/explain/feasibility_question.hpp"
#include "studies/explain/value_search.hpp"

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

constexpr double first_part = 0.02;
constexpr int most_joint_doublings = 16;
// The common part is found to this part of itself: finer than the digits it is told with.
constexpr double part_accuracy = 1e-7;
constexpr int most_joint_bisections = 40;
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
        keep_what_may_stay(part);
        for (const double more : larger_factors) {
            std::vector<Relaxation> rows = rounded(part * (1.0 + more));
            Scene changed = scene_;
            for (std::size_t i = 0; i < rows.size(); ++i)
                changed = members_[i].with(changed, *rows[i].solved);
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
    /// leave_out: a member that keeps its value; -1: none.
    [[nodiscard]] bool does(double part, int leave_out = -1) const {
        Scene changed = scene_;
        for (int i = 0; i < static_cast<int>(members_.size()); ++i) {
            const Adjustment& one = members_[static_cast<std::size_t>(i)];
            if (i != leave_out) changed = one.with(changed, value_of(one, part));
        }
        return least_violation(changed, budget_) <= 0.0;
    }
    /// 0: none found.
    [[nodiscard]] double least_part() const {
        double low = 0.0, high = first_part;
        for (int k = 0; !does(high); ++k, high *= 2.0) {
            if (k == most_joint_doublings || budget_.spent()) return 0.0;
            low = high;
        }
        return bisected([&](double part) { return does(part); }, {high, low}, most_joint_bisections,
                        [&](const Border& now) {
                            return now.with - now.without <= part_accuracy * now.with || budget_.spent();
                        })
            .with;
    }
    void keep_what_may_stay(double part) {
        for (int i = static_cast<int>(members_.size()) - 1; i >= 0 && members_.size() > 1; --i) {
            if (budget_.spent()) return;
            if (does(part, i)) members_.erase(members_.begin() + i);
        }
    }
    [[nodiscard]] std::vector<Relaxation> rounded(double part) const {
        std::vector<Relaxation> rows;
        for (const Adjustment& one : members_) {
            const double needed = value_of(one, part), size = std::max(std::abs(needed), one.step);
            const double told = std::clamp(safe_value(needed, one.may_grow, size),
                                           std::min(one.least, one.given), std::max(one.most, one.given));
            rows.push_back({one.key, one.given, needed, told});
        }
        return rows;
    }
};

}  // namespace

std::vector<Relaxation> joint_relaxation(const Scene& scene, const std::vector<Adjustment>& members,
                                         const Budget& budget) {
    return JointSearch(scene, members, budget).run();
}

}  // namespace camopt
