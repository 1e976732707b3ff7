// SPDX-License-Identifier: MIT
// The post-processor: how a program is written for one control. A TOML file of its own (docs/nc.md).
//
// A value q of a machine axis (m, rad; shop/nc/machine.hpp) is printed as  sign · q + offset  in the
// program's units, after the axis's letter. Everything is data: a new control is a new file, no code.
#pragma once

#include "core/units.hpp"
#include "scene/key_row.hpp"
#include "shop/nc/machine.hpp"

#include <filesystem>
#include <map>

namespace camopt {

/// inverse_time: F of a G93 block is 1 / its minutes. per_minute: G94, only where no axis turns.
enum class FeedMode { inverse_time, per_minute };
[[nodiscard]] const char* name_of(FeedMode mode);  ///< in the file

struct PostAxis {
    std::string letter;   ///< one capital letter
    int sign = 1;         ///< +1 or −1
    double offset = 0.0;  ///< m or rad, added after the sign
};

struct PostProcessor {
    std::string name = "generic";
    LengthUnit unit = LengthUnit::millimetre;
    FeedMode feed_mode = FeedMode::inverse_time;
    int linear_decimals = 4, angle_decimals = 5, feed_decimals = 3;  ///< 0 … 9
    bool modal = true;                    ///< words of axes that do not change are left out
    int first_block = 0, block_step = 0;  ///< N words; a step of 0 leaves them out
    std::string comment_begin = "(", comment_end = ")";
    /// {title}, {post}, {tool}, {machine} are replaced. Units, G90 and the feed mode are written by camopt.
    std::vector<std::string> header = {"%"}, footer = {"M5", "M30", "%"};
    /// {spindle_rpm}; {spindle_sense} is M3 or M4. Empty: none.
    std::string spindle_on = "S{spindle_rpm} {spindle_sense}";
    std::string tool_call = "T{tool_number} M6";  ///< empty: none
    std::map<std::string, PostAxis> axes;         ///< by MachineAxis::key

    void validate() const;  ///< throws InputError
};

/// X, Y, Z; rotary C and tilt B with five axes, rotary A with four. Inverse time where an axis turns, else
/// mm/min.
[[nodiscard]] PostProcessor generic_post(const Machine& machine);

/// The keys of its file.
[[nodiscard]] const std::vector<KeyRow>& post_rows();

/// What the file leaves out is that of `base`. Throws InputError "FILE:LINE:COLUMN: key: found …; allowed: …"
/// for a key or value, "post-processor: …" for values that exclude each other.
[[nodiscard]] PostProcessor read_post(const std::filesystem::path& file, PostProcessor base);
[[nodiscard]] PostProcessor post_of_text(std::string_view text, std::string_view name, PostProcessor base);

/// The axis of the machine in the post. Throws InputError where it has none.
[[nodiscard]] const PostAxis& post_axis(const PostProcessor& post, const MachineAxis& axis);

/// One printed unit of an axis in m or rad.
[[nodiscard]] double printed_unit(const PostProcessor& post, AxisKind kind);

/// Half the last printed digit of an axis, m or rad.
[[nodiscard]] double half_last_digit(const PostProcessor& post, AxisKind kind);

}  // namespace camopt
