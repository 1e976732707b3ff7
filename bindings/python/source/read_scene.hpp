// SPDX-License-Identifier: MIT
// A scene as Python hands it over: the text of a scene file and settings on top of it, read and checked.
#pragma once

#include <camopt/own_rules.hpp>
#include <camopt/result_json.hpp>
#include <camopt/scene.hpp>
#include <span>
#include <string>
#include <vector>

namespace camopt::python {

/// What a scene has beside its text.
struct OwnRules {
    std::vector<OwnTerm> terms;
    std::vector<OwnLimit> limits;
    /// The text weighs nothing, which its reader refuses: the terms are the whole objective.
    bool alone = false;
};

/// A constant: changes make another one. `settings`: "KEY=VALUE" as the command line's --set takes them.
struct ReadScene {
    std::string text;
    std::string source;  ///< stands in the place of FILE in messages
    std::vector<std::string> settings;
    OwnRules own;
    Scene scene;

    /// Throws InputError "FILE:LINE:COLUMN: key: found …; allowed: …"; about a setting "KEY=VALUE: …".
    ReadScene(std::string toml, std::string source_name, std::vector<std::string> all_settings,
              OwnRules own_rules);

    /// The scene of these settings after its own.
    [[nodiscard]] Scene with(std::span<const std::string> more) const;
    /// One TOML text that reads back as this scene.
    [[nodiscard]] std::string toml() const;
    /// Without a text where there are rules that no text can say.
    [[nodiscard]] RunOrigin origin() const;
};

}  // namespace camopt::python
