// SPDX-License-Identifier: MIT
#include "bindings/python/source/read_scene.hpp"

#include <camopt/errors.hpp>
#include <camopt/laws.hpp>
#include <camopt/mechanism_factory.hpp>
#include <camopt/scene_file.hpp>
#include <camopt/solver_registry.hpp>
#include <string_view>
#include <utility>

namespace camopt::python {

namespace {

input::KnownNames names_known() {
    input::KnownNames known;
    for (const LawInfo& law : law_catalogue()) known.laws.push_back(law.key);
    for (const SolverEntry& solver : solver_entries()) known.solvers.push_back(solver.name);
    return known;
}

/// Messages about a setting begin with the option of the command line that it would have come from; here
/// there is none.
std::string without_option(std::string_view message) {
    constexpr std::string_view option = "--set ";
    if (message.starts_with(option)) message.remove_prefix(option.size());
    return std::string(message);
}

Scene read(const std::string& text, const std::string& source, std::span<const std::string> settings) {
    try {
        Scene scene = input::read_scene(text, source, names_known(), settings);
        complete_mechanism(scene);
        return scene;
    } catch (const UnavailableError& error) {
        throw UnavailableError(without_option(error.what()));
    } catch (const InputError& error) {
        throw InputError(without_option(error.what()));
    }
}

}  // namespace

ReadScene::ReadScene(std::string toml, std::string source_name, std::vector<std::string> all_settings)
    : text(std::move(toml)),
      source(std::move(source_name)),
      settings(std::move(all_settings)),
      scene(read(text, source, settings)) {}

Scene ReadScene::with(std::span<const std::string> more) const {
    std::vector<std::string> all = settings;
    all.insert(all.end(), more.begin(), more.end());
    return read(text, source, all);
}

std::string ReadScene::toml() const {
    return input::scene_with_overrides(text, source, settings);
}

RunOrigin ReadScene::origin() const {
    return {source, "", toml()};
}

}  // namespace camopt::python
