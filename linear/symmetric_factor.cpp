// SPDX-License-Identifier: MIT
#include "linear/symmetric_factor.hpp"

#include "core/word_of.hpp"

namespace camopt {

const char* name_of(FactorOutcome value) {
    return word_of<FactorOutcome::not_finite>(value, {"ok", "zero_pivot", "wrong_sign", "not_finite"});
}

}  // namespace camopt
