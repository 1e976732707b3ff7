// SPDX-License-Identifier: MIT
// Scenes of tests: a named one and what the test changes in it, read as the program reads a file and `--set`.
//
//     const Scene scene = scene_named("cam_roller").with("limits.pressure_angle_deg = 25", "cam.offset_mm =
//     0");
#pragma once

#include "scene/scene.hpp"

#include <fmt/format.h>

#include <compare>

namespace camopt::testing_support {

class TestScene;

/// NAME.toml of scenes/, tests/support/cases/ or tests/cases/, the first that is there.
[[nodiscard]] TestScene scene_named(std::string name);

class TestScene {
 public:
    explicit TestScene(std::string toml) : toml_(std::move(toml)) {}

    /// Settings "key = value" with dotted keys, applied in their order as those of `--set`.
    template <class... Settings>
    [[nodiscard]] TestScene with(const Settings&... settings) const {
        return with_all({std::string(settings)...});
    }
    [[nodiscard]] TestScene with_all(const std::vector<std::string>& settings) const {
        TestScene changed = *this;
        changed.settings_.insert(changed.settings_.end(), settings.begin(), settings.end());
        return changed;
    }
    /// A number, without loss, or a word.
    template <class Value>
    [[nodiscard]] TestScene set(std::string_view key, const Value& value) const {
        if constexpr (std::is_convertible_v<Value, std::string_view>)
            return with(fmt::format("{} = '{}'", key, value));
        else
            return with(fmt::format("{} = {}", key, value));
    }

    /// Throws InputError as the reader of scenes does.
    [[nodiscard]] Scene read() const;
    operator Scene() const { return read(); }  // NOLINT(google-explicit-constructor): what a test means by it

    friend auto operator<=>(const TestScene&, const TestScene&) = default;

 private:
    friend TestScene scene_named(std::string name);

    std::string toml_, name_;
    std::vector<std::string> settings_;
};

/// docs/theory/pressure_angle.md: rise 60°, lift 20 mm, |φ| <= 30°, cubic, roller of 10 mm on the cam axis.
[[nodiscard]] TestScene pressure_angle_scene(double prime_radius_mm, int segments = 24);

/// A flat-faced valve lift: rise and return of 70° each, lift 14 mm.
[[nodiscard]] TestScene flat_scene(double base_mm);

}  // namespace camopt::testing_support
