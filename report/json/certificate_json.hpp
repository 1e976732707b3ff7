// SPDX-License-Identifier: MIT
// certificate.json: the verdict with its proof, complete, so that anybody can recompute the bound from the
// file alone, with or without camopt. The recipe stands in the file itself under "how_to_check".
//
// Errors of reading: InputError "FILE: KEY: found …; allowed: …" where the file cannot be read, is no
// certificate, or holds lists whose lengths do not match.
#pragma once

#include "solvers/certificate/certificate.hpp"

#include <filesystem>

namespace camopt {

/// The recipe in words and formulas, as it stands in the file and in the report.
[[nodiscard]] std::string_view how_to_check();

[[nodiscard]] std::string certificate_json(const Certificate& certificate);

/// The proof stored in a file, bit for bit as it was written. Throws InputError also where it holds none.
[[nodiscard]] DualityProof read_certificate(const std::filesystem::path& path);

/// All of it, with or without a proof: certificate_json of it is the file again.
[[nodiscard]] Certificate read_whole_certificate(const std::filesystem::path& path);
/// The same of a text; name: for messages.
[[nodiscard]] Certificate certificate_of_text(std::string_view json, std::string_view name);

}  // namespace camopt
