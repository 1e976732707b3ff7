// SPDX-License-Identifier: MIT
#include "studies/sweep/row_chain.hpp"

#include "studies/least/least_value.hpp"

namespace camopt {

namespace {

/// What is absent in both is the same.
bool is_same(double one, double other) {
    return one == other || (std::isnan(one) && std::isnan(other));
}

}  // namespace

const SweepRow* RowChain::solve(std::span<const double> settings, const std::function<Scene()>& scene,
                                const Addition& add) {
    const std::size_t next = table_.rows.size();
    if (next < end_of_known_ && std::ranges::equal(run_.known[next].settings, settings, is_same)) {
        table_.rows.push_back(run_.known[next]);
        return &table_.rows.back();
    }
    end_of_known_ = 0;
    if (run_.control.stopped()) return nullptr;
    const int number = next_number();
    solved_before_.number = number;
    const Solution solution = solve_asked(scene(), run_.control, &solved_before_);
    if (run_.control.stopped()) return nullptr;
    SweepRow row = sweep_row(number, settings, solution);
    if (add) add(row, solution);
    if (run_.found) run_.found(number, settings_of(table_.columns.keys, settings), solution);
    table_.rows.push_back(std::move(row));
    return &table_.rows.back();
}

void RowChain::fail(std::span<const double> settings, std::string_view reason) {
    table_.rows.push_back(failed_row(next_number(), settings, reason));
    solved_before_ = {};
}

}  // namespace camopt
