// SPDX-License-Identifier: MIT
// surface.json: what a folder of camopt sweep --surface holds beside its table, so that a run can be
// continued and any weight be looked up.
#pragma once

#include "studies/surface/trade_off_surface.hpp"

#include <string>
#include <string_view>

namespace camopt {

/// Everything that its rows depend on, and what was asked for.
struct SurfaceIdentity {
    std::string version;     ///< of the camopt that made it
    std::string scene_file;  ///< as given; for people
    std::string scene_text;  ///< as it was read, with the settings worked in
    double error = 0.0;      ///< asked for
};

[[nodiscard]] std::string surface_json(const SurfaceIdentity& identity, const TradeOffSurface& surface);

/// Throws InputError "NAME: …" for what is no such text.
[[nodiscard]] SurfaceIdentity read_surface_json(std::string_view text, std::string_view name);

/// Why rows of one are no rows of the other, in words; empty where they are.
[[nodiscard]] std::string difference(const SurfaceIdentity& one, const SurfaceIdentity& other);

}  // namespace camopt
