// SPDX-License-Identifier: MIT
// Reads the keys of a checked scene file by their rows, which say where the values live. Internal to input/.
#pragma once

#include "input/document/scene_source.hpp"
#include "scene/key_row.hpp"

namespace camopt::input {

struct GivenAt {
    Given given;
    KeyAt at;
    std::string key;  ///< as the user would write it: "motion.segments[1].via[0].at_deg"

    [[nodiscard]] std::string_view unit() const { return given.spelling->unit; }
};

/// Called before a key is read: throws for one that does not fit.
using KeyVisit = std::function<void(const GivenAt& key)>;

/// How units were written, by the key without its unit: "motion.lift".
using WrittenUnits = std::map<std::string, Spelling>;

/// What is stored as it is written, or in SI, of the whole file, in the order of its rows.
void read_rows(const SceneSource& source, const KeyOwner& owner, WrittenUnits* written = nullptr);

/// The keys of one table, "motion", that are stored by others which were read before: set points by their
/// stretch, limits with their units.
void read_scaled_rows(const SceneSource& source, std::string_view table, const KeyOwner& owner,
                      const KeyVisit& check);

}  // namespace camopt::input
