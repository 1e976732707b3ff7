// SPDX-License-Identifier: MIT
// result.json read back, as far as it cannot be recomputed. Whether it belongs to its scene is verified when
// a Solution is made of it (studies/restored/restored_solution.hpp), its other figures when a folder is read
// (report/folders/result_folder_reader.hpp).
#pragma once

#include "studies/delivered/result_record.hpp"

namespace camopt {

/// Whether a result without a motion (infeasible, failed) is read: its record has none.
enum class RecordedMotion { required, optional };

/// Gives the scene of a result, which tells the units of some figures; called once, for a result of this
/// version of camopt.
using SceneOfResult = std::function<const Scene&()>;

/// Throws InputError "FILE: KEY: found …; allowed: …" for text that is not a result of this version of
/// camopt, and for one without a required motion.
[[nodiscard]] ResultRecord read_result(std::string_view json, std::string_view source_name,
                                       const SceneOfResult& scene_of_result,
                                       RecordedMotion needed = RecordedMotion::required);

}  // namespace camopt
