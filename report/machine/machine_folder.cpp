// SPDX-License-Identifier: MIT
#include "report/machine/machine_folder.hpp"

#include "input/machine/machine_reader.hpp"
#include "input/scene_reader.hpp"
#include "report/json/certificate_json.hpp"
#include "report/machine/machine_document.hpp"
#include "report/machine/machine_json.hpp"
#include "report/page/result_page.hpp"
#include "scene/part_names.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

/// The scene of an axis as it was solved.
RunOrigin origin_of(const MachineSolution& solution, std::size_t own, const std::string& command) {
    const AxisSpec& axis = solution.spec.axes[own];
    std::vector<std::string> settings = axis.settings;
    settings.push_back(input::speed_setting(solution.speed));
    if (axis.phase != axis.scene.motion.phase)
        settings.push_back(input::setting_of("motion", "motion", "phase", axis.phase));
    const MotionSpec& motion = axis.scene.motion;
    for (std::size_t s = 0; solution.timing && s < motion.own_segments(); ++s) {
        if (!solution.timing->searched[own][s]) continue;
        settings.push_back(
            input::setting_of(segment_key(s), "motion.segments", "angle", motion.segments[s].angle));
    }
    return {axis.file, command,
            input::scene_with_overrides(input::scene_file_text(axis.file), axis.file, settings,
                                        std::filesystem::path(axis.file).parent_path())};
}

/// In the folder of the machine.
std::string scene_name(const AxisSpec& axis) {
    return axis.name + ".toml";
}

}  // namespace

MachineRun machine_run(const std::string& file, std::span<const std::string> settings,
                       const std::string& command, const MachineSolution& solution) {
    MachineRun run{{file, command, {}}, {}, {}};
    std::vector<std::string> own = input::machine_settings(settings, solution.spec);
    for (std::size_t b = 0; b < solution.spec.axes.size(); ++b) {
        run.axes.push_back(origin_of(solution, b, command));
        own.push_back(
            fmt::format("{}=\"{}\"", entry_key("axis", b, "scene"), scene_name(solution.spec.axes[b])));
    }
    run.toml = input::scene_with_overrides(input::scene_file_text(file), file, own);
    return run;
}

void write_machine_folder(const std::filesystem::path& out, const MachineRun& run,
                          const MachineSolution& solution, std::span<const std::vector<FolderFile>> also) {
    for (std::size_t b = 0; b < solution.axes.size(); ++b) {
        const View view(solution.axes[b]);
        std::vector<FolderFile> files = result_extras(view, run.axes[b]);
        if (!also.empty()) files.insert(files.end(), also[b].begin(), also[b].end());
        write_result_folder(out / solution.spec.axes[b].name, view, run.axes[b], {.also = std::move(files)});
    }
    FolderUpdate folder(out);
    for (const char* const name : {"impossible.json", "timing.svg", "timing.csv"})
        folder.remove_earlier(name);
    for (const FolderFile& file : document_files(machine_document(solution), run.machine))
        folder.write(file.name, file.text);
    // With the scenes of its axes beside it: the machine can be run and checked from its folder alone.
    for (std::size_t b = 0; b < run.axes.size(); ++b)
        folder.write(scene_name(solution.spec.axes[b]), run.axes[b].scene_text);
    folder.write("machine.toml", run.toml);
    folder.write("certificate.json", certificate_json(solution.certificate));
    if (solution.impossible) folder.write("impossible.json", impossible_json(solution));
    folder.write("machine.json",
                 machine_json(solution, run.machine, run.axes));  // last: the rest is complete then
    folder.finish();
}

}  // namespace camopt
