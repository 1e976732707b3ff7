// SPDX-License-Identifier: MIT
// What the handles of the C face hold.
#pragma once

#include "bindings/c/failure.hpp"
#include "input/scene_document.hpp"
#include "report/json/result_json.hpp"
#include "studies/delivered/solution.hpp"

#include <cstring>
#include <type_traits>

struct camopt_scene {
    camopt::input::SceneDocument document;
};

struct camopt_solution {
    camopt::Solution solution;
    camopt::RunOrigin origin;
    std::vector<std::string> stations;  ///< names; one "" of a plane cam, none without a cam
};

namespace camopt::c {

/// Complete and validated.
[[nodiscard]] Scene complete_scene(const camopt_scene& scene, std::span<const std::string> settings = {});

/// Throws Failure for NULL, and ABSENT where there is no motion.
[[nodiscard]] const MotionChain& motion_of(const camopt_solution* solution);

[[nodiscard]] camopt_verdict verdict_of(Verdict verdict);

// Structs of the C face that may grow: their member `size` says how much of them the caller has.

inline constexpr double absent_number = std::numeric_limits<double>::quiet_NaN();

[[nodiscard]] double number_or_absent(const std::optional<double>& value);
/// NaN for what is infinite too.
[[nodiscard]] double finite_or_absent(double value);

/// Of the first version of the struct: one that grows gets its own.
template <class Struct>
inline constexpr std::size_t first_size = sizeof(Struct);

/// Throws Failure where size is smaller than any version of the struct had it, as where no one has set it.
void check_size(std::size_t size, std::size_t least, const char* name);

/// Copies `value` into what the caller has of it; `size` of the target becomes the number of bytes filled.
template <class Struct>
void fill(Struct* target, Struct value, const char* name) {
    static_assert(std::is_trivially_copyable_v<Struct>);
    require(target, name);
    check_size(target->size, first_size<Struct>, name);
    value.size = std::min(target->size, sizeof(Struct));
    std::memcpy(target, &value, value.size);
}

/// What the caller has of options, the rest 0.
template <class Struct>
[[nodiscard]] Struct read_options(const Struct* given, const char* name) {
    static_assert(std::is_trivially_copyable_v<Struct>);
    Struct options{};
    if (given == nullptr) return options;
    check_size(given->size, first_size<Struct>, name);
    std::memcpy(&options, given, std::min(given->size, sizeof(Struct)));
    return options;
}

/// A list for a caller's buffer: its length always comes back; Failure where the buffer is too small.
template <class Element>
void hand_out(const Element* elements, std::size_t length, Element* buffer, std::size_t capacity,
              std::size_t* count) {
    require(count, "count");
    if (buffer == nullptr && capacity > 0) require(buffer, "buffer");
    *count = length;
    if (buffer == nullptr) return;
    if (length > capacity)
        throw Failure(CAMOPT_ERROR_CAPACITY, "found room for " + std::to_string(capacity) +
                                                 "; allowed: for " + std::to_string(length) + " or more");
    std::copy_n(elements, length, buffer);
}

/// Copies the bytes. Throws Failure for a NULL, std::bad_alloc. name: of the argument.
void hand_out_text(std::string_view text, camopt_text* target, const char* name);

/// Throws Failure where index is not below count.
void check_index(std::size_t index, std::size_t count, const char* name);

}  // namespace camopt::c
