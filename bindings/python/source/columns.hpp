// SPDX-License-Identifier: MIT
// Tables of the library as columns of NumPy.
#pragma once

#include <pybind11/numpy.h>
#include <string_view>

namespace camopt::python {

/// A CSV text of the library (a line of names, then numbers) as {name: array}, in the order of the text. The
/// numbers are those of the file to the last bit; an empty cell is `empty`.
[[nodiscard]] pybind11::dict columns_of_csv(std::string_view csv, double empty);

}  // namespace camopt::python
