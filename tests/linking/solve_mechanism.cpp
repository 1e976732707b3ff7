// SPDX-License-Identifier: MIT
// solve_…  SCENE: what a program for one kind of cam is made of. Each kind has its own formulas (FORMULAS,
// below) and none of the others; the linker's map is then looked at.
//
// Prints how often the cam was evaluated. Exit 0: solved, and by formulas of the wanted kind alone.
#include "input/loading/load_scene.hpp"
#include "input/scene_reader.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "studies/solve/solve.hpp"

#include <cstdio>
#include <exception>

#if defined(KIND_remote)
#include "profiles/remote/remote_cam.hpp"
#define FORMULAS remote_mechanism
#elif defined(KIND_inverse)
#include "profiles/inverse/inverse_mechanism.hpp"
#define FORMULAS inverse_mechanism
#elif defined(KIND_spatial)
#include "profiles/spatial/spatial_cam.hpp"
#define FORMULAS spatial_mechanism
#else
#define FORMULAS disk_formulas
#endif

namespace camopt {

namespace {

Scene scene_of(const char* file) {
    const std::vector<std::string> small = {"spline.segments=12", "solver.starts=1"};
    input::KnownNames known = names_of_laws_and_solvers();
    known.cam_formulas = FORMULAS;
    return input::read_scene_file(file, known, small);
}

bool solved_by_its_own_formulas(const char* file) {
    const Solution solution = solve(scene_of(file));
    std::printf("%s, %ld points of a profile\n", name_of(solution.certificate.verdict),
                solution.evaluations.profile_points);
#ifdef KIND_disk
    constexpr bool is_disk = true;
#else
    constexpr bool is_disk = false;
#endif
    return solution.motion && solution.cam && disk_cam(solution.cam->cam).has_value() == is_disk &&
           solution.evaluations.profile_points > 0;
}

}  // namespace

}  // namespace camopt

int main(int, char** arguments) {
    try {
        return camopt::solved_by_its_own_formulas(arguments[1]) ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
