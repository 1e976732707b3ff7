// SPDX-License-Identifier: MIT
// A square in formulas that are generic over the scalar: of an enclosure it is never below 0, as a product of
// it with itself is not seen to be (core/numbers/range_along.hpp, range_over.hpp).
#pragma once

namespace camopt {

template <class T>
[[nodiscard]] T squared(const T& a) {
    return T(a * a);
}

}  // namespace camopt
