// SPDX-License-Identifier: MIT
// Counts the evaluations that a backend requests of a problem.
#pragma once

#include "core/nlp.hpp"

namespace camopt {

struct EvaluationCounts {
    long cost = 0, gradient = 0, constraints = 0, jacobian = 0, hessian = 0;
    long profile_points = 0;  ///< no [cam]: none, ever
};

/// Forwards everything to `base`; both `base` and `counts` must outlive it.
class CountingNlp final : public Nlp {
 public:
    CountingNlp(const Nlp& base, EvaluationCounts& counts)
        : Nlp(base.shape()), base_(base), counts_(counts) {}

    [[nodiscard]] double cost(const ConstVectorRef& x) const override {
        ++counts_.cost;
        return base_.cost(x);
    }
    void gradient(const ConstVectorRef& x, VectorRef out) const override {
        ++counts_.gradient;
        base_.gradient(x, out);
    }
    void constraints(const ConstVectorRef& x, VectorRef out) const override {
        ++counts_.constraints;
        base_.constraints(x, out);
    }
    void jacobian(const ConstVectorRef& x, std::span<double> out) const override {
        ++counts_.jacobian;
        base_.jacobian(x, out);
    }
    void hessian(const ConstVectorRef& x, double sigma, const ConstVectorRef& lambda,
                 std::span<double> out) const override {
        ++counts_.hessian;
        base_.hessian(x, sigma, lambda, out);
    }
    [[nodiscard]] std::string variable_name(int index) const override { return base_.variable_name(index); }
    [[nodiscard]] std::string row_name(int index) const override { return base_.row_name(index); }
    [[nodiscard]] RowOrigin row_origin(int index) const override { return base_.row_origin(index); }

 private:
    const Nlp& base_;
    EvaluationCounts& counts_;
};

}  // namespace camopt
