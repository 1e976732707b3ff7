// SPDX-License-Identifier: MIT
// A scene that is made key by key: the keys, units and messages of a scene file, without a file.
//
// Each setting is checked at once. What the reader of a scene file would find wrong with its key or its value
// is an InputError "KEY: found …; allowed: …" with the same words, and the document stays as it was. What is
// still missing, or is wrong with other keys, is told when the scene is read. A document belongs to one
// thread while it is written; const calls may come from several.
#pragma once

#include "input/scene_reader.hpp"
#include "scene/scene.hpp"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace camopt::input {

/// A value in TOML, for what the other kinds of values cannot say: "{ min = 20, max = 60 }".
struct TomlValue {
    std::string text;
};
/// An integer key takes a double without a fraction.
using SceneValue = std::variant<bool, int, double, std::string, std::vector<double>, TomlValue>;

class SceneDocument {
 public:
    /// Throws InputError "NAME:LINE:COLUMN: …" for text that is no TOML; its keys are not looked at yet.
    SceneDocument(std::string_view toml, std::string_view name, KnownNames known);
    SceneDocument(const SceneDocument& other);
    SceneDocument& operator=(const SceneDocument& other);
    SceneDocument(SceneDocument&&) noexcept;
    SceneDocument& operator=(SceneDocument&&) noexcept;
    ~SceneDocument();

    /// Replaces the key and every other spelling of the same quantity. `key`: dotted, "limits.velocity_mm_s",
    /// "motion.segments[1].to".
    void set(std::string_view key, const SceneValue& value);

    /// Back to the default. Nothing happens where the key is not there; an unknown one is an error.
    void unset(std::string_view key);

    /// The scene, validated, its mechanism without formulas as of read_scene. `settings`: "KEY=VALUE",
    /// applied before; values in TOML.
    [[nodiscard]] Scene scene(std::span<const std::string> settings = {}) const;

    /// As TOML: read_scene of it is the same Scene, bit for bit. As given, comments and all, where nothing
    /// was set.
    [[nodiscard]] std::string text() const;

    [[nodiscard]] const std::string& name() const;

 private:
    struct State;
    std::unique_ptr<State> state_;

    void adopt(State&& changed);
};

}  // namespace camopt::input
