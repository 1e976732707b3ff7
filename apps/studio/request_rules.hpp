// SPDX-License-Identifier: MIT
// Which requests the studio answers. A page of another origin, open in the same browser, can send requests to
// this port, and can give its own name this machine's address (DNS rebinding): Host, Origin and
// Sec-Fetch-Site say so, and the token is what it does not know.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace camopt::apps {

/// A request before its body is read.
struct RequestHead {
    std::string method, target;
    std::vector<std::pair<std::string, std::string>> headers;  ///< names in any case

    /// All values of a header.
    [[nodiscard]] std::vector<std::string> values(std::string_view name) const;
};

struct StudioPlace {
    int port = 0;
    std::string token;
    std::size_t body_bytes = 0;  ///< the most a request may carry

    [[nodiscard]] std::string host() const;                         ///< "127.0.0.1:41234"
    [[nodiscard]] std::string origin() const;                       ///< "http://127.0.0.1:41234"
    [[nodiscard]] std::string target(std::string_view what) const;  ///< "/TOKEN/solve"
};

/// 0: to be answered. Else the status of the refusal:
///   403  another Host than this one; a foreign Origin; Sec-Fetch-Site says another site
///   404  no such target: another token, anything behind the page but solve and export
///   405  the target is there, for another method
///   411  a body without a length (chunked, or none given)
///   413  a longer body than is read
///   415  a body that is no JSON, or a compressed one
///   417  an expectation
///   400  a header twice that may stand once, a length that is no number
[[nodiscard]] int refusal_of(const RequestHead& request, const StudioPlace& place);

}  // namespace camopt::apps
