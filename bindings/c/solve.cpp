// SPDX-License-Identifier: MIT
#include "studies/solve/solve.hpp"

#include "bindings/c/control.hpp"
#include "bindings/c/handles.hpp"
#include "bindings/c/structs.hpp"
#include "core/errors.hpp"
#include "core/licenses.hpp"
#include "core/version.hpp"
#include "studies/checked/checked_cam.hpp"

#include <memory>
#include <string>
#include <utility>

namespace camopt::c {
namespace {

std::vector<std::string> station_names(const Solution& solution) {
    std::vector<std::string> names;
    if (solution.cam) {
        const CamMechanism& formulas = *solution.cam->cam.formulas;
        for (int i = 0; i < formulas.stations(); ++i) names.push_back(formulas.station_name(i));
    }
    return names;
}

std::unique_ptr<camopt_solution> solved(const camopt_scene& given, const camopt_solve_options& options) {
    const Scene scene = complete_scene(given);
    CallbackControl callbacks(options);
    auto result = std::make_unique<camopt_solution>();
    result->solution = solve(scene, callbacks.control());
    callbacks.finish();
    if (options.forward_check != 0 && !callbacks.stopped()) add_forward_check(result->solution);
    result->stations = station_names(result->solution);
    result->origin = {given.document.name(), "", given.document.text()};
    return result;
}

}  // namespace
}  // namespace camopt::c

using namespace camopt::c;

extern "C" {

int camopt_abi_version() {
    return CAMOPT_ABI_VERSION;
}

const char* camopt_version() {
    return camopt::version().data();
}

const char* camopt_licenses() {
    static const std::string text = camopt::license_text();
    return text.c_str();
}

camopt_error camopt_solve(const camopt_scene* scene, const camopt_solve_options* options,
                          camopt_solution** solution) {
    return guarded([&] {
        require(solution, "solution");
        *solution = nullptr;
        require(scene, "scene");
        *solution = solved(*scene, read_options(options, "options")).release();
    });
}

void camopt_solution_free(camopt_solution* solution) {
    delete solution;
}
}
