// SPDX-License-Identifier: MIT
// The folder of a solved machine: a result folder for every axis, the machine's own pages, its scenes.
#pragma once

#include "report/json/result_json.hpp"
#include "studies/machine/machine.hpp"

#include <filesystem>

namespace camopt {

/// What was read: the machine file, and the scene of every axis as it was solved.
struct MachineRun {
    RunOrigin machine;            ///< without its text
    std::vector<RunOrigin> axes;  ///< in the order of the machine
    std::string toml;             ///< the machine with its settings, and the scenes of its axes beside it
};

/// `settings`: those the file was read with; `command`: the words of the command line. Reads the files once:
/// what is written later is what was solved.
[[nodiscard]] MachineRun machine_run(const std::string& file, std::span<const std::string> settings,
                                     const std::string& command, const MachineSolution& solution);

/// `also`: further files of every axis, in the order of the machine; empty: none. Throws InputError for a
/// folder that cannot be written.
void write_machine_folder(const std::filesystem::path& out, const MachineRun& run,
                          const MachineSolution& solution,
                          std::span<const std::vector<FolderFile>> also = {});

}  // namespace camopt
