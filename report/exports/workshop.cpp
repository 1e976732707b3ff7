// SPDX-License-Identifier: MIT
#include "report/exports/workshop.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

namespace camopt {

const Workshop& needed_workshop(std::string_view what) {
    if (workshop() == nullptr)
        throw UnavailableError(fmt::format("{}: this camopt was built without the shop (CAMOPT_SHOP)", what));
    return *workshop();
}

std::vector<std::string> controller_keys() {
    std::vector<std::string> keys;
    if (workshop() != nullptr)
        for (Controller& controller : workshop()->controllers()) keys.push_back(std::move(controller.key));
    return keys;
}

std::vector<std::vector<FolderFile>> controller_files(std::span<const Solution> solutions,
                                                      const std::vector<std::string>& formats) {
    if (formats.empty()) return {};
    return needed_workshop("electronic cams").controller_files(solutions, formats);
}

}  // namespace camopt
