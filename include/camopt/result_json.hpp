// SPDX-License-Identifier: MIT
// result.json, and certificate.json with the recipe by which anybody can recompute the bound, also read back
// (read_certificate). Display units in result.json; the certificate is in the units of its problem. Errors:
// InputError for a file that is not a certificate.
#pragma once

#include "core/language.hpp"
#include "output/json/certificate_json.hpp"
#include "output/json/certificate_reader.hpp"
#include "output/json/result_json.hpp"
