// SPDX-License-Identifier: MIT
#include "bindings/c/failure.hpp"

#include "core/errors.hpp"
#include "core/word_of.hpp"

#include <new>

namespace camopt::c {
namespace {

std::string& thread_text() {
    thread_local std::string text;
    return text;
}

/// Set where there was no memory for the text.
thread_local const char* fixed_text = nullptr;

camopt_error noted(camopt_error code, const char* text) noexcept {
    try {
        thread_text() = text;
        fixed_text = nullptr;
    } catch (...) {
        fixed_text = "no memory was left, not even for the message";
    }
    return code;
}

}  // namespace

void require(const void* argument, const char* name) {
    if (argument == nullptr)
        throw Failure(CAMOPT_ERROR_NULL, std::string(name) + ": found NULL; allowed: a pointer to it");
}

camopt_error code_of_exception() noexcept {
    try {
        throw;
    } catch (const Failure& failure) {
        return noted(failure.code(), failure.what());
    } catch (const UnavailableError& error) {
        return noted(CAMOPT_ERROR_UNAVAILABLE, error.what());
    } catch (const InputError& error) {
        return noted(CAMOPT_ERROR_INPUT, error.what());
    } catch (const std::bad_alloc&) {
        return noted(CAMOPT_ERROR_MEMORY, "no memory was left");
    } catch (const std::exception& error) {
        return noted(CAMOPT_ERROR_INTERNAL, error.what());
    } catch (...) {
        return noted(CAMOPT_ERROR_INTERNAL, "an exception was thrown that is not a std::exception");
    }
}

const char* failure_text() noexcept {
    if (fixed_text != nullptr) return fixed_text;
    try {
        return thread_text().c_str();
    } catch (...) {
        return "";
    }
}

}  // namespace camopt::c

extern "C" {

const char* camopt_error_text() {
    return camopt::c::failure_text();
}

const char* camopt_error_name(camopt_error code) {
    return camopt::word_of<CAMOPT_ERROR_INTERNAL>(
        code, {"ok", "null", "argument", "input", "unavailable", "absent", "capacity", "cancelled",
               "callback", "memory", "internal"});
}
}
