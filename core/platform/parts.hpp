// SPDX-License-Identifier: MIT
// Parts of camopt that stand on a large library and that most runs do not use: STEP files, PDF drawings, the
// studio's server, Ipopt. A build has a part linked in, or as a separate file that is opened when the part
// is first used, or not at all; who calls the part does not see which.
//
// A part is a table of functions. Its file, camopt_part_NAME.so, stands in the folder camopt/ below one of
// those in which the system looks for the libraries of the module that camopt is linked into
// (LD_LIBRARY_PATH, the module's run path, the system's own folders), or in the one that the variable
// CAMOPT_PARTS names. It holds none of camopt's libraries, so nothing of their state exists twice; it is of
// the same build, so classes and exceptions of camopt pass between both; and it stays open until the process
// ends.
#pragma once

#include "core/base/standard.hpp"
#include "core/platform/part_function.hpp"

namespace camopt {

/// How this build has a part.
enum class PartBuild { absent, linked, opened };

struct PartInfo {
    const char* name;             ///< "step"
    const char* use;              ///< "STEP files"
    const char* library;          ///< "Open CASCADE"
    const char* package;          ///< Debian package of the part's file: "camopt-step"
    const char* library_package;  ///< Debian package to build it with: "libocct-data-exchange-dev"
    const char* option;           ///< that leaves it out of a build: "CAMOPT_WITH_OPENCASCADE"
    PartBuild build;
};

/// The part can be used: it is linked in, or its file is there. Nothing is opened.
[[nodiscard]] bool part_available(const PartInfo& part);

/// What to do where it is not available, without a full stop: "install the Debian package camopt-step, or …".
[[nodiscard]] std::string part_remedy(const PartInfo& part);

/// Throws UnavailableError where the part is not available: what needs it, where its file was looked for,
/// what to do.
void require_part(const PartInfo& part);

/// The part's table. `linked`: its entry where it is linked in. Throws UnavailableError as require_part() and
/// where the file cannot be opened.
[[nodiscard]] const void* part_table(const PartInfo& part, PartEntry linked);

/// The same, found once and typed. `entry` exists only where the part is linked in.
template <class Table, const PartInfo& part, PartEntry entry>
[[nodiscard]] const Table& opened_part() {
    PartEntry linked = nullptr;
    if constexpr (part.build == PartBuild::linked) linked = entry;
    static const void* const table = part_table(part, linked);
    return *static_cast<const Table*>(table);
}

}  // namespace camopt
