// SPDX-License-Identifier: MIT
#include "bindings/python/source/read_scene.hpp"

#include <algorithm>
#include <camopt/errors.hpp>
#include <camopt/scene_file.hpp>
#include <string_view>
#include <utility>

namespace camopt::python {

namespace {

/// Messages about a setting begin with the option of the command line that it would have come from; here
/// there is none.
std::string without_option(std::string_view message) {
    constexpr std::string_view option = "--set ";
    if (message.starts_with(option)) message.remove_prefix(option.size());
    return std::string(message);
}

/// A weight for the reader, which has no own terms to look at, and taken back after it.
constexpr const char* stand_in = "objective.velocity=1";

Scene read(const std::string& text, const std::string& source, std::vector<std::string> settings,
           const OwnRules& own) {
    const bool weighed = std::ranges::any_of(
        settings, [](const std::string& setting) { return setting.starts_with("objective.velocity="); });
    const bool stands_in = own.alone && !weighed;
    if (stands_in) settings.emplace_back(stand_in);
    try {
        Scene scene = scene_of_toml(text, settings, source);
        if (stands_in) scene.objective.velocity = 0.0;
        scene.own_terms = own.terms;
        scene.own_limits = own.limits;
        validate(scene);
        return scene;
    } catch (const UnavailableError& error) {
        throw UnavailableError(without_option(error.what()));
    } catch (const InputError& error) {
        throw InputError(without_option(error.what()));
    }
}

}  // namespace

ReadScene::ReadScene(std::string toml, std::string source_name, std::vector<std::string> all_settings,
                     OwnRules own_rules)
    : text(std::move(toml)),
      source(std::move(source_name)),
      settings(std::move(all_settings)),
      own(std::move(own_rules)),
      scene(read(text, source, settings, own)) {}

Scene ReadScene::with(std::span<const std::string> more) const {
    std::vector<std::string> all = settings;
    all.insert(all.end(), more.begin(), more.end());
    return read(text, source, all, own);
}

std::string ReadScene::toml() const {
    return input::scene_with_overrides(text, source, settings);
}

RunOrigin ReadScene::origin() const {
    const bool complete = own.terms.empty() && own.limits.empty();
    return {source, "", complete ? toml() : ""};
}

}  // namespace camopt::python
