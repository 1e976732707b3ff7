// SPDX-License-Identifier: MIT
#include "profiles/inverse/inverse_spec.hpp"
#include "tests/input/scene_key_cases.hpp"

#include <algorithm>
#include <iterator>

namespace camopt::input {
namespace inverse_key_cases {

bool is_angle(const std::string& name) {
    return name.ends_with("angle");
}

/// An inverse cam's scene, without one of its numbers.
std::string inverse(const std::string& except) {
    std::string toml = "motion.lift_mm = 20\n";
    if (except != "cam.type") toml += "cam.type = \"inverse\"\n";
    for (int i = 0; i < inverse_number_count; ++i) {
        const std::string name = name_of_number(static_cast<InverseNumber>(i));
        if ("cam." + name != except) toml += "cam." + name + (is_angle(name) ? "_deg = 90\n" : "_mm = 100\n");
    }
    return toml;
}

}  // namespace inverse_key_cases

std::vector<KeyCase> inverse_cases() {
    using namespace inverse_key_cases;
    std::vector<KeyCase> all = {
        {"cam.type", "\"inverse\"", 1,
         [](const Scene& s) { return s.cam.value().type == "inverse" ? 1.0 : 0.0; }, inverse("cam.type")},
    };
    for (int i = 0; i < inverse_number_count; ++i) {
        const std::string name = name_of_number(static_cast<InverseNumber>(i));
        const std::string key = "cam." + name;
        const auto low = [i](const Scene& s) {
            return s.cam.value().dimensions.at(static_cast<std::size_t>(i)).value.low;
        };
        std::ranges::move(dimension_cases(key, is_angle(name), low, inverse(key)), std::back_inserter(all));
    }
    return all;
}

}  // namespace camopt::input
