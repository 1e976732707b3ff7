// SPDX-License-Identifier: MIT
// The studio's session as a WebAssembly module, for the Worker of a page that opens without a server:
// requests and answers as of the server (studio_page.hpp), text in and text out.
//
//   reserve(size) → memory for a request; release(it)
//   solve(request, size), download(request, size) → HTTP status; the answer stays until the next call:
//   answer_text, answer_size; answer_type, answer_file (zero-terminated; the file is empty but for a
//   download)
#include "apps/studio/studio_page.hpp"

#include <cstdlib>

namespace {

using camopt::apps::StudioAnswer;

StudioAnswer& answer() {
    static StudioAnswer last;
    return last;
}

camopt::apps::StudioSession& session() {
    // One page, whose computer this is; what takes longer is ended by the page.
    static camopt::apps::StudioSession one({.download_seconds = 600.0, .pages = 1});
    return one;
}

int given(StudioAnswer made) {
    answer() = std::move(made);
    return answer().status;
}

}  // namespace

#define EXPORTED(name) extern "C" __attribute__((export_name(#name)))

EXPORTED(reserve) char* reserve(std::size_t size) {
    return static_cast<char*>(std::malloc(size));
}

EXPORTED(release) void release(char* text) {
    std::free(text);
}

EXPORTED(solve) int solve(const char* text, std::size_t size) {
    return given(session().solve({text, size}));
}

EXPORTED(download) int download(const char* text, std::size_t size) {
    return given(session().download({text, size}));
}

EXPORTED(answer_text) const char* answer_text() {
    return answer().body.data();
}

EXPORTED(answer_size) std::size_t answer_size() {
    return answer().body.size();
}

EXPORTED(answer_type) const char* answer_type() {
    return answer().type.c_str();
}

EXPORTED(answer_file) const char* answer_file() {
    return answer().file_name.c_str();
}
