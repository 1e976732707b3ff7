// SPDX-License-Identifier: MIT
// Programs in which some numbers are sought: which of their values are best?
//
// For given values the scene is an ordinary one. Boxes of values are bounded and split, values inside tried
// in the ordinary solve; then the best values are moved by steps until none helps. Within `solver.gap` of the
// least bound of boxes that together hold everything, each with its proof, the verdict is optimal.
#pragma once

#include "core/deadline.hpp"
#include "studies/delivered/solution.hpp"

#include <functional>
#include <string>
#include <vector>

namespace camopt {

/// The ordinary solve of a scene in which nothing is sought.
using SolveGiven = std::function<Solution(const Scene&)>;

/// What is proved of a box of values.
struct ProvedBox {
    double bound = 0.0;  ///< no cost is negative
    bool infeasible = false;
    std::shared_ptr<const DualityProof> proof = {};  ///< of the bound, or that nothing is feasible
};

/// What the search for one kind of numbers has in common with that for another. Of this module only.
class ProgramSearch {
 public:
    using Values = std::vector<double>;  ///< one for each number that is sought

    ProgramSearch(const ProgramSearch&) = delete;
    ProgramSearch& operator=(const ProgramSearch&) = delete;
    virtual ~ProgramSearch() = default;

 protected:
    // Parts of the time that boxes may take, and moves with them; the rest is for the last solve.
    static constexpr double time_for_boxes = 0.6, time_for_moves = 0.9;

    /// What the words and verdicts of a search differ in.
    struct Kind {
        std::string name;          ///< "angles"
        std::string proof_source;  ///< of the boxes' bounds
        Reason open;               ///< why a feasible motion is not proved
        std::size_t
            one_freedom;  ///< so many numbers can be moved in one way alone: no step helps means local
    };

    ProgramSearch(const Scene& scene, const SolveGiven& solve_given, const SolveControl& control, Kind kind);

    /// The scene for these values as an ordinary one.
    [[nodiscard]] virtual Scene given(const Values& values) const = 0;
    /// Whether a better motion counts.
    [[nodiscard]] virtual bool counts(const Solution&) const { return true; }

    [[nodiscard]] bool found() const { return best_.motion != nullptr; }
    [[nodiscard]] double objective() const {
        if (!found()) return infinity;
        return best_.certificate.objective;
    }
    /// Seconds of a part of the time that are left.
    [[nodiscard]] double left(double part) const { return part * allowed_ - watch_.seconds(); }
    [[nodiscard]] bool out_of_time(double part);
    /// A box of this bound holds nothing better worth the search.
    [[nodiscard]] bool is_closed(const ProvedBox& box) const;
    /// The scene for these values, as fast as it goes: the search itself breaks no ties.
    [[nodiscard]] Scene quick(const Values& values, double seconds) const;
    /// Whether values that were not tried yet are the best so far.
    bool try_values(const Values& values, double part_of_time);
    /// The step after one that helped or did not.
    [[nodiscard]] static double next_step(double step, bool helped);

    /// The best motion, solved as the scene asks where that is no worse. There is one.
    [[nodiscard]] Solution best_solved() const;
    /// The verdict over all values; boxes: together they hold everything, or none.
    void judge(Solution& solution, std::vector<CaseProof> boxes, bool time_ended) const;
    /// The values are entries of the design like any other.
    void add_to_design(Solution& solution, std::vector<std::string> names) const;
    void note_time(Solution& solution) const;

    Solution best_;
    Values best_values_;
    std::vector<Values> tried_;
    bool timed_out_ = false, settled_ = false;
    Stopwatch watch_;
    const Scene& scene_;
    const SolveGiven& solve_given_;
    const SolveControl& control_;

 private:
    Kind kind_;
    double allowed_;
};

}  // namespace camopt
