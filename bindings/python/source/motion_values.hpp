// SPDX-License-Identifier: MIT
// Motions as Python holds them: shared with the solution they come from, constant.
#pragma once

#include <camopt/laws.hpp>
#include <camopt/motion.hpp>
#include <memory>
#include <utility>

namespace camopt::python {

struct MotionValue {
    std::shared_ptr<const Motion> motion;
};

struct LawValue : MotionValue {
    std::shared_ptr<const Law> law;
    explicit LawValue(std::shared_ptr<const Law> made) : MotionValue{made}, law(std::move(made)) {}
};

}  // namespace camopt::python
