// SPDX-License-Identifier: MIT
#include "apps/studio/request_room.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <iterator>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <system_error>
#include <unistd.h>

namespace camopt::apps {

namespace {

bool same_name(std::string_view first, std::string_view second) {
    return std::ranges::equal(
        first, second, [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); });
}

/// In a time that does not tell how much of it is right.
bool same_secret(std::string_view given, std::string_view secret) {
    if (given.size() != secret.size()) return false;
    unsigned difference = 0;
    for (std::size_t i = 0; i < given.size(); ++i)
        difference |= static_cast<unsigned char>(given[i]) ^ static_cast<unsigned char>(secret[i]);
    return difference == 0;
}

bool has(const RequestHead& request, std::string_view name) {
    return !request.values(name).empty();
}

int foreign(const RequestHead& request, const StudioPlace& place) {
    const std::vector<std::string> hosts = request.values("Host");
    if (hosts.size() != 1 || hosts.front() != place.host()) return 403;
    for (const std::string& origin : request.values("Origin"))
        if (origin != place.origin()) return 403;
    // "same-site" is another port of this machine.
    for (const std::string& site : request.values("Sec-Fetch-Site"))
        if (site != "same-origin" && site != "none") return 403;
    return 0;
}

/// The method the target is there for; none: no such target.
std::optional<std::string_view> method_for(const std::string& target, const StudioPlace& place) {
    if (same_secret(target, place.target(""))) return "GET";
    if (same_secret(target, place.target("solve")) || same_secret(target, place.target("export")))
        return "POST";
    return std::nullopt;
}

int unfit_body(const RequestHead& request, const StudioPlace& place) {
    if (has(request, "Transfer-Encoding")) return 411;
    const std::vector<std::string> lengths = request.values("Content-Length");
    if (lengths.empty()) return request.method == "POST" ? 411 : 0;
    std::size_t length = 0;
    const std::string& text = lengths.front();
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), length);
    if (error == std::errc::result_out_of_range) return 413;
    if (error != std::errc() || end != text.data() + text.size()) return 400;
    if (length > place.body_bytes) return 413;
    if (request.method != "POST") return length == 0 ? 0 : 400;
    if (has(request, "Content-Encoding")) return 415;
    const std::vector<std::string> types = request.values("Content-Type");
    return types.size() == 1 && types.front() == "application/json" ? 0 : 415;
}

}  // namespace

RequestRoom::RequestRoom(const Limits& limits, std::function<void(Connection)> arrived)
    : limits_(limits), arrived_(std::move(arrived)), bell_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
    if (bell_ < 0) throw std::system_error(errno, std::generic_category(), "eventfd");
    thread_ = std::thread([this] { wait(); });
}

RequestRoom::~RequestRoom() {
    stopping_ = true;
    wake();
    thread_.join();
    let_in();
    for (const Connection& connection : waiting_) ::close(connection.socket);
    ::close(bell_);
}

void RequestRoom::take(int socket) {
    const auto time =
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limits_.seconds));
    {
        const std::lock_guard lock(mutex_);
        newcomers_.push_back({socket, Clock::now() + time});
    }
    wake();
}

void RequestRoom::wake() const {
    const std::uint64_t once = 1;
    [[maybe_unused]] const ssize_t written = ::write(bell_, &once, sizeof once);  // full: it rings already
}

void RequestRoom::let_in() {
    const std::lock_guard lock(mutex_);
    std::ranges::move(newcomers_, std::back_inserter(waiting_));
    newcomers_.clear();
    while (waiting_.size() > limits_.connections) {
        ::close(waiting_.front().socket);
        waiting_.erase(waiting_.begin());
    }
}

bool RequestRoom::waits_on(Connection& connection, bool readable) {
    if (readable) {
        std::array<char, 4096> part{};
        const ssize_t got = ::recv(connection.socket, part.data(), part.size(), MSG_DONTWAIT);
        if (got > 0) connection.bytes.append(part.data(), static_cast<std::size_t>(got));
        const bool whole = connection.bytes.find("\r\n\r\n") != std::string::npos;
        if (whole || connection.bytes.size() >= limits_.bytes) {
            arrived_(std::move(connection));
            return false;
        }
        const bool later = got < 0 && (errno == EAGAIN || errno == EINTR);
        if (got <= 0 && !later) connection.end = {};
    }
    if (Clock::now() < connection.end) return true;
    ::close(connection.socket);
    return false;
}

void RequestRoom::wait() {
    while (!stopping_) {
        let_in();
        std::vector<pollfd> looked_at = {{bell_, POLLIN, 0}};
        for (const Connection& connection : waiting_) looked_at.push_back({connection.socket, POLLIN, 0});
        if (::poll(looked_at.data(), looked_at.size(), look_ms) < 0) continue;
        std::uint64_t rung = 0;
        [[maybe_unused]] const ssize_t heard = ::read(bell_, &rung, sizeof rung);
        std::vector<Connection> left;
        for (std::size_t i = 0; i < waiting_.size(); ++i)
            if (waits_on(waiting_[i], looked_at[i + 1].revents != 0)) left.push_back(std::move(waiting_[i]));
        waiting_ = std::move(left);
    }
}

std::vector<std::string> RequestHead::values(std::string_view name) const {
    std::vector<std::string> found;
    for (const auto& [key, value] : headers)
        if (same_name(key, name)) found.push_back(value);
    return found;
}

std::string StudioPlace::host() const {
    return fmt::format("127.0.0.1:{}", port);
}

std::string StudioPlace::origin() const {
    return "http://" + host();
}

std::string StudioPlace::target(std::string_view what) const {
    return fmt::format("/{}/{}", token, what);
}

int refusal_of(const RequestHead& request, const StudioPlace& place) {
    if (const int status = foreign(request, place)) return status;
    for (const std::string_view once : {"Origin", "Content-Length", "Content-Type", "Sec-Fetch-Site"})
        if (request.values(once).size() > 1) return 400;
    const std::optional<std::string_view> method = method_for(request.target, place);
    if (!method) return 404;
    if (request.method != *method) return 405;
    if (has(request, "Expect")) return 417;
    return unfit_body(request, place);
}

}  // namespace camopt::apps
