// SPDX-License-Identifier: MIT
// Private to objectives/machine/: the Nlp of a MachineProblem's current rows.
#pragma once

#include "objectives/machine/machine_problem.hpp"

namespace camopt {

class MachineProblem::Grid final : public Nlp {
 public:
    explicit Grid(const MachineProblem& machine);

    [[nodiscard]] double cost(const ConstVectorRef& x) const override;
    void gradient(const ConstVectorRef& x, VectorRef out) const override;
    void constraints(const ConstVectorRef& x, VectorRef out) const override;
    void jacobian(const ConstVectorRef& x, std::span<double> out) const override;
    void hessian(const ConstVectorRef& x, double sigma, const ConstVectorRef& lambda,
                 std::span<double> out) const override;
    [[nodiscard]] std::string variable_name(int index) const override;
    [[nodiscard]] std::string row_name(int index) const override { return row_origin(index).text(); }
    [[nodiscard]] RowOrigin row_origin(int index) const override;

 private:
    /// A clearance at one angle, affine in the designs.
    struct Row {
        std::vector<int> columns;
        std::vector<double> weights;
        double offset = 0.0;
    };
    [[nodiscard]] Row clearance_row(const Clear& clear, double angle) const;
    void add_block_pattern(int block);
    void add_clearances();

    const MachineProblem& machine_;
    std::vector<std::vector<int>> row_of_;  ///< of each part's row, the machine's
    std::vector<std::vector<Row>> clear_;   ///< of each clearance
};

}  // namespace camopt
