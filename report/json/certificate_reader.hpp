// SPDX-License-Identifier: MIT
// certificate.json read back.
#pragma once

#include "report/json/certificate_json.hpp"

#include <filesystem>

namespace camopt {

/// The proof stored in a file, bit for bit as it was written. Throws InputError where the file cannot be
/// read, is no certificate, holds no proof, or holds lists whose lengths do not match.
[[nodiscard]] DualityProof read_certificate(const std::filesystem::path& path);

/// All of it, with or without a proof: certificate_json of it is the file again. Throws like
/// read_certificate.
[[nodiscard]] Certificate read_whole_certificate(const std::filesystem::path& path);
/// The same of a text; name: for messages.
[[nodiscard]] Certificate certificate_of_text(std::string_view json, std::string_view name);

}  // namespace camopt
