// SPDX-License-Identifier: MIT
// Work in a forked child process, and what it says meanwhile. Internal to core/platform/.
#pragma once

#include "core/base/standard.hpp"

namespace camopt {

struct Child {
    /// In the child; its threads may tell at once.
    std::function<void(const std::function<void(int)>& tell, const std::function<void(int)>& done)> work;

    // In the thread that waits for it.
    std::function<void(int)> told, done;
    std::function<bool()> stop;  ///< asked several times a second; true: the child is killed
};

/// Whether this system can fork; without it run_in_child does nothing.
[[nodiscard]] bool can_run_children();

/// None: the work is done or was stopped. Else how the child died: "worker died: signal 11". Throws what the
/// work threw, as InputError or std::runtime_error, and std::system_error where the system gives no process.
[[nodiscard]] std::optional<std::string> run_in_child(const Child& child);

}  // namespace camopt
