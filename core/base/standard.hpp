// SPDX-License-Identifier: MIT
// The headers of the standard library that nearly every file uses: a file that includes a header of the
// project has them by it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>
