// SPDX-License-Identifier: MIT
// Scenes of the tests of the reader as text files: broken/*.txt (what is refused, with the message) and
// accepted/*.txt (what is read, with the value). Both consist of base scenes and of cases on them:
//
//   scene NAME [from SCENE] [for TABLE]: LINE | LINE …    or the lines follow, up to an empty one or the next
//                                          scene. The lines of a case replace the mark *, else they follow;
//                                          their keys are those of TABLE
//   on SCENE[, SCENE …] [without KEY, …]   the cases follow; the scene `nothing` is empty
//
// A case of broken/ is LINE | LINE … # error PLACE: TEXT, where TEXT may go on in lines "#   TEXT" and <NAME>
// is what words.txt has under "words NAME":
//
//   lift_mm = 0  # error 11: motion.lift_mm: found 0; …     in column 11 of the last line of the case
//   type = "A" | jerk = 1  # error 2:8: …                   in column 8 of the second line of the scene
//   --set spline.degree=4  # error: …                       in this setting, where \n is a line feed
//
// A line of accepted/ is a quantity, two blanks, then in each of its units a value and what the Scene holds,
// or another member of it; the base scene's own line of the quantity is left out:
//
//   motion.lift  mm: 10 -> 0.01 | in: 2 -> 0.0508 | rad: 0.5 -> motion.lift_is_angle = 1
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace camopt::input {

struct BrokenScene {
    std::string place;  ///< "forces.txt:31"
    std::string toml;
    std::vector<std::string> settings;
    std::string message;
};

struct AcceptedScene {
    std::string place;
    std::string key;       ///< "motion.lift_mm"
    std::string toml;      ///< with the key
    std::string field;     ///< "motion.lift"
    std::string expected;  ///< "pi/6", "clockwise"
};

/// The text files of a folder, without words.txt, in alphabetical order.
[[nodiscard]] std::vector<std::filesystem::path> case_files(const std::filesystem::path& folder);

/// Throw std::runtime_error with the place for what is no case.
[[nodiscard]] std::vector<BrokenScene> broken_scenes(const std::filesystem::path& file);
[[nodiscard]] std::vector<AcceptedScene> accepted_scenes(const std::filesystem::path& file);

/// Of every file of tests/input/accepted.
[[nodiscard]] const std::vector<AcceptedScene>& all_accepted_scenes();

}  // namespace camopt::input
