// SPDX-License-Identifier: MIT
#include "solvers/certificate/box_proof.hpp"

#include "core/errors.hpp"
#include "core/word_of.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

/// Every step that a step or part names.
template <class Visit>
void visit_named(const BoxStep& step, const Visit& visit) {
    for (const auto& [index, multiplier] : step.multipliers) visit(index);
    for (const int index : step.bounds) visit(index);
    for (const auto& ends : step.ends)
        for (const int index : ends)
            if (index >= 0) visit(index);
}

/// Bounds of x if the named steps hold too: each bounds one variable.
Box narrowed(const BoxProof& proof, const std::vector<int>& bounds) {
    Box box = proof.box;
    for (const int index : bounds) {
        const BoxStep& step = proof.steps[static_cast<std::size_t>(index)];
        Eigen::Index j = 0;
        if (step.weights.cwiseAbs().maxCoeff(&j) != 1.0 || step.weights.cwiseAbs().sum() != 1.0)
            throw ModelError(fmt::format("box proof: step {} is no bound of one variable", index));
        if (step.weights[j] > 0.0)
            box.upper[j] = std::min(box.upper[j], step.side);
        else
            box.lower[j] = std::max(box.lower[j], -step.side);
    }
    return box;
}

/// An upper bound of weights · x from the multipliers of earlier steps.
double greatest(const BoxProof& proof, const Eigen::VectorXd& weights,
                const std::vector<std::pair<int, double>>& multipliers, const std::vector<int>& bounds) {
    const Box box = narrowed(proof, bounds);
    const auto size = static_cast<std::size_t>(weights.size());
    std::vector<long double> rest(weights.begin(), weights.end()), magnitude(size);
    for (std::size_t j = 0; j < size; ++j) magnitude[j] = std::abs(rest[j]);
    long double sum = 0.0L, sizes = 0.0L;
    for (const auto& [index, multiplier] : multipliers) {
        const BoxStep& step = proof.steps[static_cast<std::size_t>(index)];
        if (!(multiplier >= 0.0)) throw ModelError("box proof: found a multiplier below 0");
        const long double by = multiplier;
        sum += by * step.side;
        sizes += std::abs(by * step.side);
        for (std::size_t j = 0; j < size; ++j) {
            const long double term = by * step.weights[static_cast<Eigen::Index>(j)];
            rest[j] -= term;
            magnitude[j] += std::abs(term);
        }
    }
    // The terms above are summed with an error of a few units of long double; this is a thousand times as
    // much.
    constexpr long double rounding = 1e3L * std::numeric_limits<long double>::epsilon();
    for (std::size_t j = 0; j < size; ++j) {
        const auto at = static_cast<Eigen::Index>(j);
        const long double slack = rounding * magnitude[j], low = box.lower[at], high = box.upper[at];
        const auto most = [&](long double slope) { return slope > 0.0L ? slope * high : slope * low; };
        sum += std::max(most(rest[j] - slack), most(rest[j] + slack));
    }
    return static_cast<double>(sum + rounding * (sizes + std::abs(sum)));
}

// Relative tolerance between a step's claim and its recomputation: the claim was rounded outward by more.
constexpr double same_side = 1e-14;

}  // namespace

const char* name_of(BoxStep::Kind value) {
    return word_of<BoxStep::Kind::split>(value, {"linear", "cost", "plane", "derived", "split"});
}

BoxProof pruned(const BoxProof& proof) {
    std::vector<char> needed(proof.steps.size(), 0);
    const auto need = [&](int index) { needed[static_cast<std::size_t>(index)] = 1; };
    for (const BoxPart& part : proof.parts) {
        for (const auto& [index, multiplier] : part.multipliers) need(index);
        for (const int index : part.bounds) need(index);
        for (const int index : part.splits) need(index);
    }
    for (std::size_t i = proof.steps.size(); i-- > 0;)
        if (needed[i]) visit_named(proof.steps[i], need);
    std::vector<int> place(proof.steps.size(), -1);
    BoxProof result = proof;
    result.steps.clear();
    const auto moved = [&](int& index) {
        if (index >= 0) index = place[static_cast<std::size_t>(index)];
    };
    for (std::size_t i = 0; i < proof.steps.size(); ++i) {
        if (!needed[i]) continue;
        place[i] = static_cast<int>(result.steps.size());
        BoxStep step = proof.steps[i];
        for (auto& [index, multiplier] : step.multipliers) moved(index);
        for (int& index : step.bounds) moved(index);
        for (auto& ends : step.ends)
            for (int& index : ends) moved(index);
        result.steps.push_back(std::move(step));
    }
    for (BoxPart& part : result.parts) {
        for (auto& [index, multiplier] : part.multipliers) moved(index);
        for (int& index : part.bounds) moved(index);
        for (int& index : part.splits) moved(index);
    }
    return result;
}

double recomputed_bound(const BoxProof& proof) {
    for (int i = 0; i < static_cast<int>(proof.steps.size()); ++i) {
        const BoxStep& step = proof.steps[static_cast<std::size_t>(i)];
        visit_named(step, [&](int index) {
            if (index < 0 || index >= i)
                throw ModelError(
                    fmt::format("box proof: step {} names step {}; allowed: an earlier one", i, index));
        });
        if (step.kind != BoxStep::Kind::derived) continue;
        const double most = greatest(proof, step.weights, step.multipliers, step.bounds);
        if (!(most <= step.side + same_side * std::max(1.0, std::abs(step.side))))
            throw ModelError(
                fmt::format("box proof: step {} says at most {:.17g}; the steps it follows from allow "
                            "{:.17g}",
                            i, step.side, most));
    }
    double least = infinity;
    for (const BoxPart& part : proof.parts) {
        const Eigen::VectorXd cost =
            part.infeasible ? Eigen::VectorXd::Zero(proof.cost.size()).eval() : Eigen::VectorXd(-proof.cost);
        const double most = greatest(proof, cost, part.multipliers, part.bounds);
        if (part.infeasible && !(most < 0.0))
            throw ModelError(
                "box proof: a part is called infeasible, but its multipliers prove no contradiction");
        if (!part.infeasible) least = std::min(least, proof.constant - most);
    }
    return least;
}

}  // namespace camopt
