// SPDX-License-Identifier: MIT
// What a program called camopt is made of: its groups of commands, and what it knows of cams. Each program
// says it beside its main(), and so links these parts and no others.
#pragma once

#include "core/base/standard.hpp"

namespace camopt {
class CamMechanism;
struct CamSpec;
struct FolderFile;
struct ForwardCheckReport;
struct RunOrigin;
struct Solution;
struct View;
}  // namespace camopt

namespace camopt::apps {

class Commands;

struct ProgramParts {
    std::vector<void (*)(Commands&)> groups;
    /// The formulas of a kind of cam. Throws SceneError for a kind whose formulas the program does not have.
    std::shared_ptr<const CamMechanism> (*cam_formulas)(const CamSpec& spec);
    /// Puts the forward check of a delivered cam into its report.
    void (*add_forward_check)(Solution& solution);
    /// What a result folder holds beside the files of every result.
    std::vector<FolderFile> (*result_extras)(const View& view, const RunOrigin& origin);
    /// The cam of a folder for CAD: `camopt solve --dxf`; null: not in this program.
    std::vector<FolderFile> (*dxf_files)(const View& view);
    /// "this program is a part of camopt, … builds all": where some commands are left out; empty: it has all.
    std::string_view left_out;
};

/// Of the program that runs.
[[nodiscard]] const ProgramParts& program_parts();

// The groups of commands.

/// solve, check, table.
void add_first_commands(Commands& commands);
/// All others.
void add_more_commands(Commands& commands);

}  // namespace camopt::apps
