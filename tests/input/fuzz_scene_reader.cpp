// SPDX-License-Identifier: MIT
// libFuzzer target: whatever the bytes are, reading them as a scene gives a Scene or an InputError, nothing
// else. The first zero byte parts the file from an override.
#include "core/errors.hpp"
#include "input/scene_reader.hpp"
#include "profiles/factory/cam_formulas.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const camopt::input::KnownNames known = {.laws = {"cycloidal", "modified_sine", "polynomial_345"},
                                                    .solvers = {"ipopt", "structured"},
                                                    .cam_formulas = camopt::cam_formulas};
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const std::size_t zero = text.find('\0');
    std::vector<std::string> overrides;
    if (zero != std::string_view::npos) overrides.emplace_back(text.substr(zero + 1));
    try {
        // A scene that was read is a valid one.
        camopt::validate(camopt::input::read_scene(text.substr(0, zero), "fuzz.toml", known, overrides));
    } catch (const camopt::InputError&) {
    }
    return 0;
}
