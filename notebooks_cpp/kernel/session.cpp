// SPDX-License-Identifier: MIT
// Cells that fail as if they had never been run. Preloaded into clang-repl-22 by the kernel (session.py),
// which sends one line a cell,
//
//   //camopt cell PIECE …          paths of files that are included one after another
//
// and reads, on stdout and on stderr, what the cell wrote and then the frame "\x1e" "camopt end STATUS
// PID\n". STATUS: ok, compile, exception, signal-N, ended. PID: the process that runs the next cell.
//
// Before a cell runs, the process forks. The child is a copy of the session and waits. Where the cell ends
// well, the child is sent away; else (its code does not compile, it throws, aborts, crashes, is killed) the
// process ends and the child goes on in its place. So an error takes nothing with it: names, include guards,
// instantiated templates and values are those before the cell.
//
// clang-repl itself lets exceptions end the process and has no call between its lines. It calls
// clang::Interpreter::ParseAndExecute across a library boundary; this file puts a function of that name
// before it.
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cxxabi.h>
#include <dlfcn.h>
#include <exception>
#include <fcntl.h>
#include <iostream>
#include <poll.h>
#include <sstream>
#include <string>
#include <string_view>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <typeinfo>
#include <unistd.h>
#include <vector>

// Just as much of LLVM's types as the call needs: these have the layout of LLVM 22.
namespace llvm {
struct StringRef {
    const char* data;
    std::size_t size;
};
/// One pointer, null for success; returned through memory, as everything with a destructor.
struct Error {
    void* payload = nullptr;
    Error() = default;
    Error(Error&& other) noexcept : payload(other.payload) { other.payload = nullptr; }
    Error& operator=(Error&&) = delete;
    ~Error() {}  // NOLINT(modernize-use-equals-default): a trivial one would change how it is returned
};
}  // namespace llvm

namespace clang {
class Value;
class Interpreter {
 public:
    __attribute__((visibility("default"))) llvm::Error ParseAndExecute(llvm::StringRef code, Value* value);
};
}  // namespace clang

namespace {

constexpr std::string_view cell_command = "//camopt cell ";
constexpr int fatal_signals[] = {SIGSEGV, SIGABRT, SIGFPE, SIGILL, SIGBUS};

volatile sig_atomic_t interrupted = 0;
int report_pipe = -1;  ///< to the waiting copy, while a cell runs

void note_interrupt(int) {
    interrupted = 1;
}

/// What LLVM prints by itself: values of expressions.
void flush_llvm() {
    using Outs = void* (*)();
    using Flush = void (*)(void*);
    static const auto outs = reinterpret_cast<Outs>(dlsym(RTLD_DEFAULT, "_ZN4llvm4outsEv"));
    static const auto flush =
        reinterpret_cast<Flush>(dlsym(RTLD_DEFAULT, "_ZN4llvm11raw_ostream14flush_nonemptyEv"));
    if (outs != nullptr && flush != nullptr) flush(outs());
}

void flush_all() {
    std::cout.flush();
    std::cerr.flush();
    std::fflush(nullptr);
    flush_llvm();
}

void write_all(int file, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(file, text.data(), text.size());
        if (written <= 0) return;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

void write_end(const std::string& status) {
    const std::string frame =
        "\x1e"
        "camopt end " +
        status + ' ' + std::to_string(::getpid()) + '\n';
    write_all(STDOUT_FILENO, frame);
    write_all(STDERR_FILENO, frame);
}

/// Tells the copy why the cell ends, and ends it. Safe in a signal handler.
[[noreturn]] void give_way(unsigned char reason) {
    [[maybe_unused]] const ssize_t written = ::write(report_pipe, &reason, 1);
    ::_exit(1);
}

void report_signal(int number) {
    give_way(static_cast<unsigned char>(number));
}

constexpr unsigned char cell_is_done = 255, does_not_compile = 254, threw = 253;

std::string status_of(unsigned char reason) {
    switch (reason) {
        case 0:
            return "ended";
        case does_not_compile:
            return "compile";
        case threw:
            return "exception";
        default:
            return "signal-" + std::to_string(reason);
    }
}

/// The copy's life: returns where it takes over, with the reason.
unsigned char wait_as_copy(int pipe_end, pid_t running) {
    ::signal(SIGINT, SIG_IGN);
    unsigned char reason = 0;
    for (;;) {
        pollfd ends[2] = {{pipe_end, POLLIN, 0}, {STDIN_FILENO, 0, 0}};
        if (::poll(ends, 2, -1) < 0) continue;
        if (ends[0].revents != 0) {
            if (::read(pipe_end, &reason, 1) <= 0) reason = 0;
            break;
        }
        if ((ends[1].revents & (POLLHUP | POLLERR)) != 0) {  // the kernel is gone
            ::kill(running, SIGKILL);
            ::_exit(0);
        }
    }
    if (reason == cell_is_done) ::_exit(0);
    // What the other process wrote must be complete before the end is told.
    unsigned char rest = 0;
    while (::read(pipe_end, &rest, 1) > 0) {
    }
    ::close(pipe_end);
    return reason;
}

void set_handlers() {
    interrupted = 0;
    struct sigaction action {};
    action.sa_handler = note_interrupt;
    ::sigaction(SIGINT, &action, nullptr);
    action.sa_handler = report_signal;
    action.sa_flags = SA_ONSTACK;  // the stack itself may be what overflowed; LLVM has set another one up
    for (const int number : fatal_signals) ::sigaction(number, &action, nullptr);
}

std::string type_of_exception() {
    const std::type_info* type = abi::__cxa_current_exception_type();
    if (type == nullptr) return "exception";
    int status = 0;
    char* words = abi::__cxa_demangle(type->name(), nullptr, nullptr, &status);
    std::string result = words != nullptr ? words : type->name();
    std::free(words);
    return result;
}

void write_exception(const std::string& what) {
    flush_all();
    const std::string text = type_of_exception() + '\n' + what;
    write_all(STDERR_FILENO,
              "\x1e"
              "camopt exception " +
                  std::to_string(text.size()) + '\n' + text);
}

using ParseAndExecute = llvm::Error (*)(clang::Interpreter*, llvm::StringRef, clang::Value*);

ParseAndExecute the_real_one() {
    static const auto next = reinterpret_cast<ParseAndExecute>(
        dlsym(RTLD_NEXT, "_ZN5clang11Interpreter15ParseAndExecuteEN4llvm9StringRefEPNS_5ValueE"));
    return next;
}

void run_piece(clang::Interpreter* interpreter, const std::string& path) {
    const std::string line = "#include \"" + path + '"';
    try {
        const llvm::Error error = the_real_one()(interpreter, {line.data(), line.size()}, nullptr);
        if (error.payload != nullptr) {
            flush_all();
            give_way(does_not_compile);
        }
        return;
    } catch (const std::exception& error) {
        write_exception(error.what());
    } catch (...) {
        write_exception("");
    }
    give_way(threw);
}

void run_cell(clang::Interpreter* interpreter, std::string_view paths) {
    flush_all();
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) return write_end("ended");
    const pid_t running = ::getpid();
    const pid_t copy = ::fork();
    if (copy < 0) {
        std::perror("camopt: fork");
        ::close(ends[0]);
        ::close(ends[1]);
        return write_end("ended");
    }
    if (copy == 0) {
        ::close(ends[1]);
        const unsigned char reason = wait_as_copy(ends[0], running);
        ::signal(SIGINT, SIG_DFL);
        return write_end(status_of(reason));
    }
    ::close(ends[0]);
    report_pipe = ends[1];
    set_handlers();
    std::istringstream list{std::string(paths)};
    for (std::string path; list >> path;) run_piece(interpreter, path);
    flush_all();
    const unsigned char done = cell_is_done;
    [[maybe_unused]] const ssize_t written = ::write(report_pipe, &done, 1);
    ::close(report_pipe);
    ::waitpid(copy, nullptr, 0);
    write_end("ok");
}

/// The first process of a session goes with the kernel, whatever becomes of that; others see their input end.
__attribute__((constructor)) void begin_session() {
    ::unsetenv("LD_PRELOAD");
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
}

}  // namespace

namespace clang {

llvm::Error Interpreter::ParseAndExecute(llvm::StringRef code, Value* value) {
    const std::string_view line(code.data, code.size);
    if (line.substr(0, cell_command.size()) != cell_command) return the_real_one()(this, code, value);
    run_cell(this, line.substr(cell_command.size()));
    return {};
}

}  // namespace clang

/// Whether the cell that runs was asked to stop (display.hpp).
extern "C" __attribute__((visibility("default"))) bool camopt_notebook_interrupted() {
    return interrupted != 0;
}
