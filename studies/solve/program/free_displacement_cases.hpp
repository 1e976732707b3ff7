// SPDX-License-Identifier: MIT
// One case of a program with free displacements: a box for each of them, a bound on every motion inside, and
// how it is split. Of this module only.
#pragma once

#include "objectives/free_displacements.hpp"
#include "objectives/model.hpp"
#include "studies/solve/program/program_search.hpp"

#include <optional>
#include <vector>

namespace camopt {

struct DisplacementCase : ProvedBox {
    std::vector<DisplacementBox> boxes;
    std::vector<double> levels = {};  ///< what the relaxation likes, one a free joint
    int worst = -1;                   ///< the box that makes the relaxation err most, −1: none known
    double liked = 0.0;               ///< its displacement in the relaxation
    bool indivisible = false;         ///< it cannot be cut into smaller ones
};

/// Bounds cases of one scene, and splits them.
class DisplacementCases {
 public:
    DisplacementCases(const Scene& scene, const Peaks& reference, const SolveControl& control);

    [[nodiscard]] const FreeDisplacements& free() const { return free_; }
    [[nodiscard]] const MotionFamily& family() const { return family_; }
    /// The whole, not bounded yet.
    [[nodiscard]] DisplacementCase whole() const;
    /// Solves the relaxation of a case; seconds: the most it may take.
    void bound(DisplacementCase& part, double seconds);
    /// Parts that hold all of a case, narrowed; none where it cannot be split.
    [[nodiscard]] std::vector<DisplacementCase> split(const DisplacementCase& whole) const;

 private:
    const ProvedBox& shape();
    [[nodiscard]] bool moves_from_rest_to_rest(const DisplacementCase& part) const;
    void find_worst(DisplacementCase& part, const CamModel& model, const Eigen::VectorXd& x,
                    const Eigen::VectorXd& design) const;

    const Scene& scene_;
    const Peaks& reference_;
    const SolveControl& control_;
    MotionFamily family_;
    FreeDisplacements free_;
    std::optional<ProvedBox> shape_;  ///< of every segment that moves from rest to rest
};

}  // namespace camopt
