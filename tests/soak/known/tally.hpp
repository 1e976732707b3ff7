// SPDX-License-Identifier: MIT
// Counts of scenes with a known answer, kept in a file so that a run goes on where it stopped.
//
// The file: `next N` (all scenes before N are counted), then a line for each row, separated by tabs: class,
// answer, condition, scenes, right, open, wrong, refused.
#pragma once

#include "tests/soak/known/judge.hpp"

#include <array>
#include <filesystem>
#include <map>
#include <string>

namespace camopt::soak {

class KnownTally {
 public:
    /// Reads `file` if it is there; empty: nothing is kept. Throws std::runtime_error for a file that is
    /// none.
    explicit KnownTally(std::filesystem::path file);

    void add(long number, const KnownScene& scene, const Judged& judged);
    void save() const;

    /// The first scene that is not counted.
    [[nodiscard]] long next() const { return next_; }
    [[nodiscard]] long count(Judgement judgement) const;
    [[nodiscard]] long scenes() const;
    [[nodiscard]] std::string table() const;

 private:
    using Row = std::array<std::string, 3>;
    struct Finished {
        Row row;
        Judgement judgement;
    };
    void count(const Finished& finished);

    std::filesystem::path file_;
    long next_ = 0;
    std::map<long, Finished> ahead_;  ///< finished before scenes with smaller numbers
    std::map<Row, std::array<long, 4>> rows_;
};

}  // namespace camopt::soak
