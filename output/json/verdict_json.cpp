// SPDX-License-Identifier: MIT
#include "output/json/verdict_json.hpp"

namespace camopt {

Json bound_json(const Certificate& certificate) {
    return {{"lower", number_json(certificate.lower_bound)},
            {"gap", number_json(certificate.gap)},
            {"proof", name_of(certificate.proof_kind)}};
}

void add_verdict(Json& json, const Certificate& certificate) {
    json["verdict"] = name_of(certificate.verdict);
    json["reason"] = words_json(name_of(certificate.reason));
    json["objective"] = number_json(certificate.objective);
    json["bound"] = bound_json(certificate);
}

}  // namespace camopt
