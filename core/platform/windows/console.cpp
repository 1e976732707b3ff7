// SPDX-License-Identifier: MIT
#include "core/platform/console.hpp"

#include <atomic>
#include <cstdint>
#include <fcntl.h>
#include <io.h>
#include <windows.h>

namespace camopt {

namespace {

std::atomic<bool> was_interrupted{false};

/// The first Ctrl-C is noted, the second ends the program as it would without this.
BOOL WINAPI note_interrupt(DWORD event) {
    return (event == CTRL_C_EVENT || event == CTRL_BREAK_EVENT) && !was_interrupted.exchange(true) ? TRUE
                                                                                                   : FALSE;
}

std::string utf8(const wchar_t* word) {
    const int size = ::WideCharToMultiByte(CP_UTF8, 0, word, -1, nullptr, 0, nullptr, nullptr);
    std::string text(static_cast<std::size_t>(size), '\0');
    ::WideCharToMultiByte(CP_UTF8, 0, word, -1, text.data(), size, nullptr, nullptr);
    text.resize(text.size() - 1);  // the zero at the end
    return text;
}

}  // namespace

std::vector<std::string> program_words(int, char**) {
    ::SetConsoleOutputCP(CP_UTF8);
    const HANDLE error = ::GetStdHandle(STD_ERROR_HANDLE);
    DWORD mode = 0;
    if (::GetConsoleMode(error, &mode) != 0)
        ::SetConsoleMode(error, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
    for (const int stream : {1, 2}) ::_setmode(stream, _O_BINARY);  // lines end as they do elsewhere
    int count = 0;
    wchar_t** const wide = ::CommandLineToArgvW(::GetCommandLineW(), &count);
    std::vector<std::string> words;
    for (int i = 0; i < count; ++i) words.push_back(utf8(wide[i]));
    ::LocalFree(wide);
    return words;
}

bool error_is_terminal() {
    DWORD mode = 0;
    return ::GetConsoleMode(::GetStdHandle(STD_ERROR_HANDLE), &mode) != 0;
}

bool output_is_taken() {
    const int copy = ::_dup(1);
    return copy >= 0 && ::_close(copy) == 0;
}

std::filesystem::path program_folder() {
    std::wstring name(MAX_PATH, L'\0');
    for (;;) {
        const DWORD size = ::GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size()));
        if (size == 0) return {};
        if (size < name.size()) return std::filesystem::path(name.substr(0, size)).parent_path();
        name.resize(2 * name.size());
    }
}

bool open_in_browser(const std::filesystem::path& page) {
    constexpr std::intptr_t greatest_fault = 32;  // so ShellExecute's return value is documented
    return reinterpret_cast<std::intptr_t>(::ShellExecuteW(nullptr, L"open", page.c_str(), nullptr, nullptr,
                                                           SW_SHOWNORMAL)) > greatest_fault;
}

InterruptWatch::InterruptWatch(Signals) {
    was_interrupted = false;
    ::SetConsoleCtrlHandler(note_interrupt, TRUE);
}

InterruptWatch::~InterruptWatch() {
    ::SetConsoleCtrlHandler(note_interrupt, FALSE);
}

bool InterruptWatch::interrupted() {
    return was_interrupted;
}

}  // namespace camopt
