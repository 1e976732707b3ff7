// SPDX-License-Identifier: MIT
// What an installed camopt opens when it is used: Ipopt solves, Open CASCADE writes a face. parts FILE.step
#include <camopt/errors.hpp>
#include <camopt/solve.hpp>
#include <camopt/solver_registry.hpp>
#include <camopt/surfaces.hpp>
#include <filesystem>
#include <iostream>

int main(int, char** words) {
    using namespace camopt;
    for (const SolverEntry& entry : solver_entries())
        if (entry.name == "ipopt" && entry.available) {
            Scene scene;
            scene.spline.segments = 12;
            scene.objective.jerk = 1.0;
            scene.solver.name = entry.name;
            const Solution solution = solve(scene);
            std::cout << "ipopt " << entry.version << ": " << name_of(solution.certificate.verdict) << '\n';
        }
    if (step_available()) {
        SurfaceGrid grid{"flat", {0.0, 1.0}, {0.0, 1.0}, {}, {}};
        for (const double v : grid.v)
            for (const double u : grid.u) grid.points.emplace_back(u * 1e-2, v * 1e-2, 0.0);
        write_step_file(words[1], bspline_surfaces(grid));
        std::cout << "step: " << (std::filesystem::file_size(words[1]) > 1000 ? "written" : "empty") << '\n';
        try {
            BsplineSurface wrong = bspline_surfaces(grid).front();
            wrong.knots_u[1] = wrong.knots_u.back() + 1.0;
            write_step_file(words[1], std::span(&wrong, 1));
        } catch (const InputError& error) {
            std::cout << "refused: " << error.what() << '\n';
        }
    }
    std::cout << "every part\n";
}
