// SPDX-License-Identifier: MIT
// camopt valves: intake and exhaust lobe of one crankshaft, each a scene, which is solved, or a result
// folder, which is used as it is.
#include "apps/commands.hpp"
#include "apps/scene_loading.hpp"
#include "apps/terminal.hpp"
#include "core/errors.hpp"
#include "core/units.hpp"
#include "output/json/valve_json.hpp"
#include "output/view/valve_tables.hpp"

namespace camopt::apps {

ExitCode valves_command(const ValvesRequest& request) {
    const InterruptWatch watch;
    const auto lobe = [&](const std::string& scene) {
        return solved_or_read(scene, {}, [](const Scene&) {});
    };
    Solution intake = lobe(request.intake);
    const Solution exhaust = lobe(request.exhaust);
    std::optional<ValveGap> gap;
    if (request.gap_mm)
        gap = ValveGap{*request.gap_mm * units::millimetre, request.included_deg * units::degree};
    const ValvePair pair = valve_pair(intake, exhaust, gap);
    show_in(intake.scene, request.units);
    print(request.json ? valve_pair_json(pair) : valve_pair_text(pair, intake.scene.length_unit));
    return !pair.clearance || *pair.clearance > 0.0 ? success : failure;
}

}  // namespace camopt::apps
