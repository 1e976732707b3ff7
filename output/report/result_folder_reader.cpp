// SPDX-License-Identifier: MIT
#include "output/report/result_folder_reader.hpp"

#include "core/errors.hpp"
#include "core/text/printable.hpp"
#include "core/text/text_file.hpp"
#include "input/result/result_reader.hpp"
#include "output/json/certificate/certificate_reader.hpp"
#include "output/json/json_difference.hpp"
#include "output/json/json_text.hpp"
#include "output/json/result_json.hpp"
#include "output/report/folder_update.hpp"
#include "studies/delivered/delivered_objective.hpp"
#include "studies/restored/restored_solution.hpp"

#include <fmt/format.h>

#include <system_error>

namespace camopt {

namespace {

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
    const std::string difference =
        json_difference(Json::parse(text), Json::parse(result_json(read.solution, read.origin)), same_figure);
    if (difference.empty()) return;
    throw InputError(
        fmt::format("{}: {}, which is what the motion and its scene give: the folder was changed "
                    "after the solve, or its files are of two runs",
                    printable(file), difference));
}

}  // namespace

ResultFolder read_result_folder(const std::filesystem::path& folder, const SceneLoader& load) {
    std::error_code error;
    if (std::filesystem::exists(folder / incomplete_mark, error))
        throw InputError(
            fmt::format("{}: found {}: files of two runs may lie side by side; allowed: a complete "
                        "result folder",
                        printable(folder.string()), incomplete_mark));
    const std::string result_file = (folder / "result.json").string();
    const std::string scene_file = (folder / "scene.toml").string();
    const std::string result = text_of(folder, "result.json", "");
    const input::ResultRecord record = input::read_result(result, result_file);
    ResultFolder read;
    read.origin = {record.scene_file, record.command,
                   text_of(folder, "scene.toml", " of a scene file (a scene built in C++ has no text)")};
    try {
        read.solution = restored_solution(load(read.origin.scene_text, scene_file), record);
    } catch (const InputError& wrong) {
        const std::string words = wrong.what();
        if (words.starts_with(printable(scene_file))) throw;
        throw InputError(fmt::format("{}: {}", printable(folder.string()), words));
    }
    Certificate& certificate = read.solution.certificate =
        read_whole_certificate(folder / "certificate.json");
    const double written = certificate.objective;
    certificate.objective = defined_objective(read.solution);
    check_written(result, read, result_file);
    certificate.objective = written;
    return read;
}

}  // namespace camopt
