// SPDX-License-Identifier: MIT
#include "sweep_run_of_program.hpp"

#include "core/text/text_file.hpp"

#include <algorithm>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

namespace camopt::test {

namespace {

void redirect(int target, const std::string& path) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (file < 0 || ::dup2(file, target) < 0) ::_exit(126);
}

}  // namespace

RunningProgram::RunningProgram(const std::vector<std::string>& arguments, const std::string& log) {
    std::vector<std::string> words = {CAMOPT_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    process_ = ::fork();
    if (process_ < 0) throw std::runtime_error("no process");
    if (process_ == 0) {
        redirect(STDOUT_FILENO, log + ".out");
        redirect(STDERR_FILENO, log + ".err");
        ::execv(CAMOPT_PROGRAM, pointers.data());
        ::_exit(127);
    }
}

RunningProgram::~RunningProgram() {
    if (process_ < 0) return;
    send(SIGKILL);
    (void)wait();
}

void RunningProgram::send(int signal) const {
    if (process_ > 0) ::kill(process_, signal);
}

bool RunningProgram::runs() {
    if (process_ > 0 && ::waitpid(process_, &status_, WNOHANG) == process_) process_ = -1;
    return process_ > 0;
}

int RunningProgram::wait() {
    if (process_ > 0) ::waitpid(process_, &status_, 0);
    process_ = -1;
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
}

std::vector<pid_t> RunningProgram::children() const {
    std::vector<pid_t> found;
    std::error_code gone;  // each thread lists the children that it forked
    for (const auto& thread :
         std::filesystem::directory_iterator("/proc/" + std::to_string(process_) + "/task", gone)) {
        std::ifstream list(thread.path() / "children");
        for (pid_t child = 0; list >> child;) found.push_back(child);
    }
    return found;
}

std::vector<std::string> timeless_rows(const std::string& folder) {
    std::istringstream text(read_text_file(folder + "/sweep.csv"));
    std::vector<std::string> rows;
    for (std::string line; std::getline(text, line);) {
        for (int column = 0; column < 2; ++column) line.erase(line.find_last_of(','));
        rows.push_back(line);
    }
    std::ranges::sort(rows);
    return rows;
}

int chunk_count(const std::string& folder) {
    std::error_code absent;
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder + "/chunks", absent))
        count += entry.path().extension() == ".csv" ? 1 : 0;
    return count;
}

}  // namespace camopt::test
