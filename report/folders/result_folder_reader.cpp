// SPDX-License-Identifier: MIT
#include "report/folders/result_folder_reader.hpp"

#include "core/errors.hpp"
#include "core/text/printable.hpp"
#include "core/text/text_file.hpp"
#include "report/json/certificate_json.hpp"
#include "report/json/json_fields.hpp"
#include "report/json/result_reader.hpp"
#include "studies/delivered/solution_parts.hpp"
#include "studies/restored/restored_solution.hpp"

#include <fmt/format.h>

#include <system_error>

namespace camopt {

namespace {

// The first difference between two JSON documents that should say the same.

class TolerantComparison {
 public:
    explicit TolerantComparison(double tolerance) : tolerance_(tolerance) {}

    [[nodiscard]] std::string difference(const Json& found, const Json& allowed,
                                         const std::string& path) const {
        if (found.is_object() && allowed.is_object()) return of_objects(found, allowed, path);
        if (found.is_array() && allowed.is_array() && found.size() == allowed.size())
            return of_lists(found, allowed, path);
        const bool same = found.is_number() && allowed.is_number()
                              ? close(found.get<double>(), allowed.get<double>())
                              : found == allowed;
        return same ? ""
                    : fmt::format("{}: found {}; allowed: {}", printable(path), json_words(found),
                                  json_words(allowed));
    }

 private:
    double tolerance_;

    [[nodiscard]] bool close(double found, double allowed) const {
        const double size = std::max({1.0, std::abs(found), std::abs(allowed)});
        return std::abs(found - allowed) <= tolerance_ * size;
    }

    [[nodiscard]] std::string of_objects(const Json& found, const Json& allowed,
                                         const std::string& path) const {
        const auto inside = [&path](const std::string& key) { return path.empty() ? key : path + "." + key; };
        for (const auto& [key, value] : found.items()) {
            const auto own = allowed.find(key);
            if (own == allowed.end()) return fmt::format("{}: found an unknown key", printable(inside(key)));
            const bool place = (key == "at" || key == "at_deg") && value.is_number() && own->is_number();
            if (place) continue;
            if (std::string text = difference(value, *own, inside(key)); !text.empty()) return text;
        }
        for (const auto& [key, value] : allowed.items())
            if (!found.contains(key)) return fmt::format("{}: found no such key", printable(inside(key)));
        return "";
    }

    [[nodiscard]] std::string of_lists(const Json& found, const Json& allowed,
                                       const std::string& path) const {
        for (std::size_t i = 0; i < found.size(); ++i)
            if (std::string text = difference(found[i], allowed[i], fmt::format("{}[{}]", path, i));
                !text.empty())
                return text;
        return "";
    }
};

/// In words: the key, what was found, what is allowed; empty where there is none. Numbers may differ by
/// `tolerance`, relative (below 1 absolute); where an extreme lies (keys at, at_deg) is not looked at: a flat
/// one may lie anywhere.
std::string json_difference(const Json& found, const Json& allowed, double tolerance) {
    return TolerantComparison(tolerance).difference(found, allowed, "");
}

// Figures are sums and searches that another compiler rounds otherwise; what a hand changes is larger.
constexpr double same_figure = 1e-9;

/// Throws where a file of the folder is not there, with what that means.
std::string text_of(const std::filesystem::path& folder, const char* name, const char* meaning) {
    std::error_code error;
    if (!std::filesystem::exists(folder / name, error))
        throw InputError(
            fmt::format("{}: found no {}; allowed: a folder that `camopt solve SCENE --out DIR` "
                        "wrote{}",
                        printable(folder.string()), name, meaning));
    return read_text_file(folder / name);
}

/// What result.json says must be what the delivered motion and its scene give.
void check_written(const std::string& text, const ResultFolder& read, const std::string& file) {
    Json written = Json::parse(text), allowed = Json::parse(result_json(read.solution, read.origin));
    for (Json* one : {&written, &allowed}) one->erase("plan");  // another build may have other solvers
    const std::string difference = json_difference(written, allowed, same_figure);
    if (difference.empty()) return;
    throw InputError(
        fmt::format("{}: {}, as computed from the motion and its scene: the folder was changed "
                    "after the solve, or its files are of two runs",
                    printable(file), difference));
}

/// What make() gives; the folder is named where an error of it does not begin with `file`.
auto named_by(const std::filesystem::path& folder, const std::string& file, const auto& make) {
    try {
        return make();
    } catch (const InputError& wrong) {
        const std::string words = wrong.what();
        if (words.starts_with(printable(file))) throw;
        throw InputError(fmt::format("{}: {}", printable(folder.string()), words));
    }
}

}  // namespace

ResultFolder read_result_folder(const std::filesystem::path& folder, const SceneLoader& load) {
    std::error_code error;
    if (std::filesystem::exists(folder / incomplete_mark, error))
        throw InputError(
            fmt::format("{}: found {}: it may contain files of two runs; allowed: a complete "
                        "result folder",
                        printable(folder.string()), incomplete_mark));
    const std::string result_file = (folder / "result.json").string();
    const std::string scene_file = (folder / "scene.toml").string();
    const std::string result = text_of(folder, "result.json", "");
    ResultFolder read;
    Scene scene;
    const ResultRecord record = read_result(result, result_file, [&]() -> const Scene& {
        read.origin.scene_text =
            text_of(folder, "scene.toml", " of a scene file (a scene built in C++ has no text)");
        return scene = named_by(folder, scene_file, [&] { return load(read.origin.scene_text, scene_file); });
    });
    read.origin.scene_file = record.scene_file;
    read.origin.command = record.command;
    read.solution = named_by(folder, scene_file, [&] { return restored_solution(scene, record); });
    Certificate& certificate = read.solution.certificate =
        read_whole_certificate(folder / "certificate.json");
    const double written = certificate.objective;
    certificate.objective = defined_objective(read.solution);
    check_written(result, read, result_file);
    certificate.objective = written;
    return read;
}

}  // namespace camopt
