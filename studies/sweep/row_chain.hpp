// SPDX-License-Identifier: MIT
// Rows that are solved one after another, each from what the ones before found: the one way in which a chunk
// of a sweep, a front and a surface get their rows. Private to studies/.
#pragma once

#include "studies/search/known_solutions.hpp"
#include "studies/sweep/sweep_plan.hpp"

namespace camopt {

class RowChain {
 public:
    /// Rows go to the end of the table, numbered from `first`. All must outlive the chain.
    RowChain(const RowRun& run, SweepTable& table, int first = 0)
        : run_(run), table_(table), first_(first), end_of_known_(run.known.size()) {}

    /// What a row says of a solution beyond what every row says.
    using Addition = std::function<void(SweepRow&, const Solution&)>;

    /// The next row: one that is known, or a solve. Null: the control stopped it, and what the solve had come
    /// to then is an accident. Throws as `scene` and as solve() do.
    const SweepRow* solve(std::span<const double> settings, const std::function<Scene()>& scene,
                          const Addition& add = {});
    /// A row without a solution in its place; the next one starts cold.
    void fail(std::span<const double> settings, std::string_view reason);

 private:
    [[nodiscard]] int next_number() const { return first_ + static_cast<int>(table_.rows.size()); }

    const RowRun& run_;
    SweepTable& table_;
    int first_;
    std::size_t end_of_known_;  ///< 0 from the first row on that is not the known one
    KnownSolutions solved_before_;
};

}  // namespace camopt
