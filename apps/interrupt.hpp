// SPDX-License-Identifier: MIT
// Ctrl-C during a solve: the first asks the solver to stop and deliver the best point it has, the second ends
// the program at once.
#pragma once

namespace camopt::apps {

/// Watches SIGINT as long as it lives; then the previous behaviour returns.
class InterruptWatch {
 public:
    enum class Signals { interrupt, termination_too };  ///< too: SIGTERM, as job schedulers send it

    explicit InterruptWatch(Signals signals = Signals::interrupt);
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;

    [[nodiscard]] static bool interrupted();
};

}  // namespace camopt::apps
