// SPDX-License-Identifier: MIT
// The table of a measured cam: displacements of the follower, or points of the cam, recognized by the names
// of the columns: theta_deg and s_mm, else x_mm and y_mm, else r_mm and theta_deg, or other units of these.
// Separated by commas, semicolons or tabs; with the last two a comma in a cell is a decimal comma.
#pragma once

#include "core/base/standard.hpp"

#include <Eigen/Core>

#include <filesystem>

namespace camopt::input {

struct InspectedTable {
    std::string file;                   ///< its name in messages
    bool points = false;                ///< of the cam, in its frame; else displacements of the follower
    bool is_angle = false;              ///< the displacements are angles
    std::vector<Eigen::Vector2d> rows;  ///< (cam angle, displacement), rad and m or rad; points: (x, y), m
    std::vector<int> lines;             ///< of each row, from 1
};

struct InspectedForm {
    std::vector<std::string> columns = {};  ///< their names in the order of the file; empty: its first line
    /// Of each column, in the unit of its name: offset + scale · cell; empty: as written.
    std::vector<double> scale = {}, offset = {};
};

/// Throws InputError, naming the file and mostly the line, for columns that are missing, cells that are not
/// finite numbers, angles that neither ascend nor descend, fewer than 8 rows, files that cannot be read.
[[nodiscard]] InspectedTable read_inspected_table(const std::filesystem::path& file,
                                                  const InspectedForm& form = {});
[[nodiscard]] InspectedTable inspected_table_of(std::string_view text, const std::string& name,
                                                const InspectedForm& given = {});

}  // namespace camopt::input
