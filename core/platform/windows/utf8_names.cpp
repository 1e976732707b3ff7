// SPDX-License-Identifier: MIT
/// Names of files are UTF-8 throughout, as elsewhere: the standard library of this compiler makes a path of
/// text by mbrtowc() of the old C run-time, which knows no UTF-8 in any locale. The one place that all such
/// text passes is this function; a program that links this object uses it instead (the run-time is linked
/// statically; twice defined would not link).
#include <cerrno>
#include <cwchar>
#include <windows.h>

namespace {

constexpr auto malformed = static_cast<std::size_t>(-1);
constexpr auto incomplete = static_cast<std::size_t>(-2);

std::size_t sequence_length(char lead) {
    const auto byte = static_cast<unsigned char>(lead);
    return byte < 0x80 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
}

}  // namespace

/// As in ISO C, in UTF-8 in every locale. A character of four bytes is two units of UTF-16: the second
/// waits in `state` and comes with the last byte. A sequence that `size` cuts short is left where it is.
extern "C" std::size_t mbrtowc(wchar_t* unit, const char* text, std::size_t size, mbstate_t* state) {
    if (!text) return 0;
    if (*state != 0) {
        if (unit) *unit = static_cast<wchar_t>(*state);
        *state = 0;
        return 1;
    }
    const std::size_t length = size == 0 ? 1 : sequence_length(*text);
    if (size < length) return incomplete;
    wchar_t units[2] = {};
    const int count =
        ::MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, text, static_cast<int>(length), units, 2);
    if (count == 0) {
        errno = EILSEQ;
        return malformed;
    }
    if (unit) *unit = units[0];
    if (units[0] == 0) return 0;
    if (count == 1) return length;
    *state = units[1];
    return length - 1;
}
