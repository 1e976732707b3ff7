// SPDX-License-Identifier: MIT
// The square in formulas that are generic over the scalar: an enclosure of it is never below 0, unlike that
// of a product with itself (core/numbers/range_along.hpp, range_over.hpp).
#pragma once

namespace camopt {

template <class T>
[[nodiscard]] T squared(const T& a) {
    return T(a * a);
}

}  // namespace camopt
