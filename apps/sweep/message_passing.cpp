// SPDX-License-Identifier: MIT
#include "apps/sweep/message_passing.hpp"

#include "core/errors.hpp"
#include "core/text/parsing.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <system_error>

namespace camopt::apps {

namespace {

namespace fs = std::filesystem;

constexpr const char* module_name = "camopt_mpi.so";

/// Where a launcher puts rank and number of ranks.
struct LauncherVariables {
    const char *rank, *size;
};

constexpr std::array launchers = {LauncherVariables{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
                                  LauncherVariables{"PMI_RANK", "PMI_SIZE"},
                                  LauncherVariables{"PMIX_RANK", "SLURM_STEP_NUM_TASKS"}};

std::optional<int> number_in_environment(const char* name) {
    const char* text = std::getenv(name);
    const std::optional<long long> value = text ? integer_in(text) : std::nullopt;
    if (!value || !std::in_range<int>(*value)) return std::nullopt;
    return static_cast<int>(*value);
}

/// Beside the program in a build, below the prefix where it is installed; empty: nowhere.
fs::path module_path() {
    std::error_code error;
    const fs::path here = fs::read_symlink("/proc/self/exe", error).parent_path();
    for (const fs::path& folder : {here, here / CAMOPT_MODULE_FOLDER})
        if (fs::exists(folder / module_name, error)) return folder / module_name;
    return {};
}

}  // namespace

RankLaunch rank_launch() {
    for (const LauncherVariables& names : launchers) {
        const std::optional<int> rank = number_in_environment(names.rank);
        const std::optional<int> size = number_in_environment(names.size);
        if (rank && size && *rank >= 0 && *rank < *size) return {*rank, *size};
    }
    return {};
}

std::unique_ptr<MessagePassing> start_message_passing(const RankLaunch& launch) {
    const fs::path path = module_path();
    const std::string started = fmt::format("mpirun started {} processes of camopt", launch.size);
    if (path.empty())
        throw InputError(
            fmt::format("{}, and this camopt was built without MPI; allowed: camopt without "
                        "mpirun, --shard i/N, or a build with libopenmpi-dev installed (CAMOPT_WITH_MPI)",
                        started));
    // Global, since MPI loads parts of itself that look for its symbols. Its own symbols first: MUMPS without
    // MPI (below Ipopt) brings an MPI_Init that does nothing. Never closed: parts of MPI stay to the end.
    void* const module = ::dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL | RTLD_DEEPBIND);
    if (!module)
        throw InputError(
            fmt::format("{}, and MPI does not load: {}; allowed: the MPI that camopt was built "
                        "with (libopenmpi3), or camopt without mpirun",
                        started, ::dlerror()));
    const auto start = reinterpret_cast<StartMessagePassing>(::dlsym(module, message_passing_entry));
    std::unique_ptr<MessagePassing> messages(start ? start() : nullptr);
    if (!messages || messages->size() != launch.size || messages->rank() != launch.rank)
        throw InputError(
            fmt::format("{}, and MPI of {} does not know of them; allowed: mpirun of the MPI that "
                        "camopt was built with",
                        started, path.string()));
    return messages;
}

}  // namespace camopt::apps
