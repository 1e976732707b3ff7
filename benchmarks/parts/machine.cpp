// SPDX-License-Identifier: MIT
#include "benchmarks/parts/machine.hpp"

#include "core/version.hpp"
#include "solvers/registry.hpp"

#include <Eigen/Core>
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <thread>

namespace camopt::benchmarks {

namespace {

std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown processor";
}

std::string load() {
    double averages[3] = {};
    if (::getloadavg(averages, 3) != 3) return "unknown";
    return fmt::format("{:.2f}, {:.2f}, {:.2f} (1, 5, 15 minutes)", averages[0], averages[1], averages[2]);
}

}  // namespace

std::string machine_line() {
    return fmt::format("{}, {} cores", processor(), std::thread::hardware_concurrency());
}

std::string machine_text() {
    std::string text = fmt::format("date: {:%Y-%m-%d %H:%M} UTC\n", fmt::gmtime(std::time(nullptr)));
    text += fmt::format("processor: {}\ncores: {}\n", processor(), std::thread::hardware_concurrency());
    text += fmt::format("load at the end of the run: {}\ncompiler: {}\n", load(), CAMOPT_COMPILER);
    text += fmt::format("camopt: {}\nEigen: {}.{}.{}\nfmt: {}\n", version(), EIGEN_WORLD_VERSION,
                        EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION, FMT_VERSION);
    for (const SolverEntry& entry : solver_entries()) {
        text += fmt::format("{}: {}\n", entry.name,
                            !entry.available        ? "not in this build"
                            : entry.version.empty() ? "in this build"
                                                    : entry.version);
    }
    return text;
}

}  // namespace camopt::benchmarks
