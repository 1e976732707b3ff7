// SPDX-License-Identifier: MIT
// Builds a scene key by key: the keys, units and messages of a scene file, without a file.
//
// Each setting is validated at once. A fault in its key or value is an InputError "KEY: found …; allowed: …"
// in the words of the scene reader, and the document is unchanged. Missing keys and faults of other keys are
// reported when the scene is read. A document belongs to one thread while it is written; const calls may come
// from several.
#pragma once

#include "input/scene_reader.hpp"

namespace camopt::input {

/// A value in TOML, for values of other kinds: "{ min = 20, max = 60 }".
struct TomlValue {
    std::string text;
};
/// An integer key takes a double without a fraction.
using SceneValue = std::variant<bool, int, double, std::string, std::vector<double>, TomlValue>;

class SceneDocument {
 public:
    /// Throws InputError "NAME:LINE:COLUMN: …" for text that is not TOML; its keys are not validated yet.
    SceneDocument(std::string_view toml, std::string_view name, KnownNames known);
    SceneDocument(const SceneDocument& other);
    SceneDocument& operator=(const SceneDocument& other);
    SceneDocument(SceneDocument&&) noexcept;
    SceneDocument& operator=(SceneDocument&&) noexcept;
    ~SceneDocument();

    /// Replaces the key and its synonyms. `key`: dotted, "limits.velocity_mm_s", "motion.segments[1].to".
    void set(std::string_view key, const SceneValue& value);

    /// Restores the default. No effect if the key is absent; an unknown one is an error.
    void unset(std::string_view key);

    /// The scene, validated, its mechanism without formulas as of read_scene. `settings`: "KEY=VALUE",
    /// applied before; values in TOML.
    [[nodiscard]] Scene scene(std::span<const std::string> settings = {}) const;

    /// As TOML: read_scene of it is the same Scene, bit for bit. The original text with comments if nothing
    /// was set.
    [[nodiscard]] std::string text() const;

    [[nodiscard]] const std::string& name() const;

 private:
    struct State;
    std::unique_ptr<State> state_;

    void adopt(State&& changed);
};

}  // namespace camopt::input
