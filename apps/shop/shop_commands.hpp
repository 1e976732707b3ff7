// SPDX-License-Identifier: MIT
// What the shop adds to the program. A build without it (CAMOPT_SHOP=OFF) adds nothing (apps/no_shop.cpp).
#pragma once

#include "apps/commands.hpp"
#include "apps/list/described_keys.hpp"

namespace camopt::apps {

class Commands;

struct ExportRequest {
    std::string scene;                  ///< file, or a result folder: then nothing is solved
    std::string out;                    ///< folder
    std::string solver;                 ///< replaces solver.name; empty: the scene's
    std::vector<std::string> settings;  ///< KEY=VALUE
    std::vector<std::string> plc;       ///< keys of plc_formats(); empty: none
    std::optional<double> step_deg;     ///< of table.csv, lobe.csv; none: by points, 1
    std::string lobe;                   ///< "mm" or "in": lobe.csv of a valve lobe; empty: none
    std::string columns;                ///< of table.csv, between commas; empty: the usual ones
    std::optional<int> digits;          ///< of table.csv, lobe.csv; none: all
    bool csv = false, stl = false, step = false, picture = false, dxf = false, nc = false;
    std::string units;               ///< as of solve
    std::string sheet;               ///< "svg", "pdf", "dxf": a workshop drawing; empty: none
    std::optional<int> points = {};  ///< over the turn
    /// Of plates and programs, by the key of its row (shop/exports/workshop_options.hpp); empty: not given.
    std::map<std::string, std::string> options;
};
/// "--cutter-mm" of "cutter_mm".
[[nodiscard]] std::string flag_of(std::string key);
[[nodiscard]] ExitCode export_command(const ExportRequest& request);
/// Of a workshop drawing: "svg", "pdf", "dxf".
[[nodiscard]] std::vector<std::string> drawing_formats();

/// camopt export.
void add_shop_commands(Commands& commands);

[[nodiscard]] std::vector<ListTopic> shop_topics();
[[nodiscard]] std::vector<DescribedKeys> shop_keys();

}  // namespace camopt::apps
