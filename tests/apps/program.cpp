// SPDX-License-Identifier: MIT
#include "program.hpp"

#include "core/text/text_file.hpp"
#include "tests/report/temporary_folder.hpp"
#include "tests/support/source_folder.hpp"

#include <cstdlib>
#include <sys/wait.h>

namespace camopt::test {

namespace {

ProgramRun run_shell(const std::string& command) {
    const TemporaryFolder folder;
    const std::string out = folder.path() + "/out", err = folder.path() + "/err";
    const int status = std::system(("{ " + command + " ; } >" + out + " 2>" + err).c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text_file(out), read_text_file(err)};
}

/// CAMOPT_TEST_PROGRAM: another one than the built one, such as a script that runs camopt.exe under Wine.
std::string program() {
    const char* const other = std::getenv("CAMOPT_TEST_PROGRAM");
    return std::string("'") + (other != nullptr ? other : CAMOPT_PROGRAM) + "' ";
}

}  // namespace

ProgramRun run_camopt(const std::string& arguments) {
    return run_shell(program() + arguments);
}

ProgramRun run_camopt_interrupted(const std::string& arguments, double seconds) {
    return run_shell(program() + arguments + " & pid=$!; sleep " + std::to_string(seconds) +
                     "; kill -INT $pid; wait $pid");
}

std::string scene(const std::string& name) {
    return "'" + source_folder() + "/scenes/" + name + ".toml'";
}

}  // namespace camopt::test
