// SPDX-License-Identifier: MIT
// The folder of a solved machine: a result folder for every axis, the machine's own pages, its scenes.
#pragma once

#include "output/json/result_json.hpp"
#include "studies/machine/machine.hpp"

#include <filesystem>

namespace camopt {

/// What was asked for: the machine file, the settings it was read with, and the words of the command line.
struct MachineRun {
    std::string file;
    std::vector<std::string> settings;
    std::vector<std::string> plc = {};  ///< formats of electronic cams, for every axis
    std::string command = {};
};

/// The scene of every axis as it was solved.
[[nodiscard]] std::vector<RunOrigin> origins_of(const MachineRun& run, const MachineSolution& solution);

/// Throws InputError for a folder that cannot be written.
void write_machine_folder(const std::filesystem::path& out, const MachineRun& run,
                          const MachineSolution& solution);

}  // namespace camopt
