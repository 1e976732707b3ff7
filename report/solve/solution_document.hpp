// SPDX-License-Identifier: MIT
// What there is to say of a solved scene, in the user's units: verdict, motion, what drives it, cam, how it
// was found, the scene. Console, report.md and pages print it; curves, drawings and result.json are made
// beside it (report/view, report/page, report/json).
#pragma once

#include "report/document/document_text.hpp"

namespace camopt {

/// The reference law in the scene's place: its limits need a second look at the cam, up to some tenths of a
/// second.
enum class PageReference : unsigned char { compared, later };

struct SolutionWishes {
    unsigned where = Where::everywhere;  ///< for whom: what takes long and none of them sees is left out
    PageReference reference = PageReference::compared;  ///< later: only the law's title
    /// false: before the proof. The verdict says so; figures and scene are all there is.
    bool proof = true;
};

/// The origin gives the scene, key by key and as text, that repeats the run.
[[nodiscard]] Document solution_document(const Solution& solution, const RunOrigin& origin = {},
                                         const SolutionWishes& wishes = {});

/// What `camopt solve` prints.
[[nodiscard]] std::string summary_text(const Solution& solution);

/// report.md.
[[nodiscard]] std::string report_markdown(const Solution& solution, const RunOrigin& origin = {});

/// report.md and tables.csv.
[[nodiscard]] std::vector<FolderFile> solution_texts(const Solution& solution, const RunOrigin& origin);

}  // namespace camopt
