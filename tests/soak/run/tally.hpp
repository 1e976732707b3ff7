// SPDX-License-Identifier: MIT
// Counts by relation, scenes of failures in a folder, the table at the end.
#pragma once

#include "tests/soak/run/trial.hpp"

#include <filesystem>
#include <map>
#include <string>

namespace camopt::soak {

class Tally {
 public:
    explicit Tally(std::filesystem::path folder) : folder_(std::move(folder)) {}

    void heard(const TrialPlan& plan, const std::string& line);
    void ended(const TrialPlan& plan, const std::string& fault);

    [[nodiscard]] int trials() const { return trials_; }
    [[nodiscard]] int failures() const;
    [[nodiscard]] std::string progress() const;
    [[nodiscard]] std::string table() const;

 private:
    struct Row {
        int trials = 0, failures = 0;
    };
    void fail(const TrialPlan& plan, const std::vector<std::string>& fields);

    std::filesystem::path folder_;
    std::map<std::string, Row> rows_;
    std::map<std::string, int> verdicts_;
    std::map<std::string, std::vector<std::string>> last_;  ///< what each running trial is at, by its name
    double seconds_ = 0.0;
    int trials_ = 0, solves_ = 0;
};

}  // namespace camopt::soak
