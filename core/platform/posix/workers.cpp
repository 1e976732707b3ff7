// SPDX-License-Identifier: MIT
#include "core/platform/workers.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <deque>
#include <exception>
#include <map>
#include <poll.h>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace camopt {

namespace {

constexpr int patience_milliseconds = 100;  // between two looks at what is not a message
constexpr int most_deaths = 2;              // of one unit

// One worker process and the line to it.

/// What a worker says.
struct WorkerMessage {
    enum class Kind { told, done, wrong_input, error };
    Kind kind = Kind::told;
    int number = 0;    ///< told, done
    std::string text;  ///< wrong_input, error
};

/// What runs in the worker.
struct WorkerDuty {
    std::function<void()> begin;
    std::function<void(int unit, const std::function<void(int)>& tell)> work;
};

/// In the worker: the next number that it was given; none: no one is there any more.
[[nodiscard]] std::optional<int> receive_number(int line);
/// In the worker. Ends it where no one is there any more.
void send_message(int line, const WorkerMessage& message);

class WorkerProcess {
 public:
    /// Forks. `not_mine`: ends of other workers' lines, which the child closes. Throws std::system_error
    /// where the system gives no process.
    WorkerProcess(const WorkerDuty& duty, const std::vector<int>& not_mine);
    WorkerProcess(WorkerProcess&& other) noexcept;
    WorkerProcess& operator=(WorkerProcess&& other) noexcept;
    ~WorkerProcess();  ///< kills it where it still works

    [[nodiscard]] int line() const { return line_; }  ///< a file descriptor to poll
    [[nodiscard]] const std::optional<int>& unit() const { return unit_; }
    void give(int unit);  ///< a worker that is dead already is noticed by listen()
    void set_idle();

    /// The next message; none: it died. Blocks until there is one.
    [[nodiscard]] std::optional<WorkerMessage> listen();
    /// Of a dead worker that had done a unit: whether it died before it took the one that it has now. (One
    /// that has done nothing yet may be unable to begin: who gave to such for ever would never end.)
    [[nodiscard]] bool died_before_its_unit() const { return has_served_ && unread_; }

    /// Of a dead worker: "worker died: signal 11".
    [[nodiscard]] std::string cause_of_death();

 private:
    void end() noexcept;

    pid_t process_ = -1;
    int line_ = -1;
    std::optional<int> unit_;
    bool has_served_ = false;  ///< it has done a unit
    bool unread_ = false;      ///< what it was given last it never read
};

class Pool {
 public:
    explicit Pool(const PoolTask& task)
        : task_(task), duty_{task.begin_worker, task.work}, waiting_(task.units.begin(), task.units.end()) {}

    PoolOutcome run() {
        while (!waiting_.empty() || busy() > 0) {
            if (task_.stop_requested && task_.stop_requested()) return PoolOutcome::stopped;
            hire();
            hand_out();
            wait_and_listen();
            tick();
        }
        return PoolOutcome::finished;
    }

 private:
    /// Messages come by the thousand; a progress line is read by a person.
    void tick() {
        const Clock::time_point now = Clock::now();
        if (!task_.tick || now - last_tick_ < std::chrono::milliseconds(patience_milliseconds)) return;
        last_tick_ = now;
        task_.tick();
    }

    [[nodiscard]] long busy() const {
        return std::ranges::count_if(workers_,
                                     [](const WorkerProcess& one) { return one.unit().has_value(); });
    }

    void hire() {
        const auto wanted = std::min<std::size_t>(static_cast<std::size_t>(task_.workers),
                                                  waiting_.size() + static_cast<std::size_t>(busy()));
        while (workers_.size() < wanted) {
            std::vector<int> lines;
            for (const WorkerProcess& worker : workers_) lines.push_back(worker.line());
            workers_.emplace_back(duty_, lines);
        }
    }

    void hand_out() {
        for (WorkerProcess& worker : workers_) {
            if (worker.unit() || waiting_.empty()) continue;
            worker.give(waiting_.front());
            waiting_.pop_front();
        }
    }

    void wait_and_listen() {
        std::vector<pollfd> lines;
        for (const WorkerProcess& worker : workers_) lines.push_back({worker.line(), POLLIN, 0});
        if (::poll(lines.data(), lines.size(), patience_milliseconds) <= 0) return;
        for (std::size_t i = lines.size(); i-- > 0;)  // from the end: a dead one is taken out
            if (lines[i].revents != 0) listen(i);
    }

    void listen(std::size_t index) {
        using Kind = WorkerMessage::Kind;
        WorkerProcess& worker = workers_[index];
        const std::optional<WorkerMessage> message = worker.listen();
        if (!message) {
            bury(index);
            return;
        }
        if (message->kind == Kind::wrong_input) throw InputError(message->text);
        if (message->kind == Kind::error) throw std::runtime_error(message->text);
        if (message->kind == Kind::told && task_.told) task_.told(message->number);
        if (message->kind == Kind::done) worker.set_idle();
    }

    void bury(std::size_t index) {
        const std::optional<int> unit = workers_[index].unit();
        const bool innocent = workers_[index].died_before_its_unit();
        const std::string cause = workers_[index].cause_of_death();
        workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(index));
        if (!unit) return;
        if (innocent || ++deaths_[*unit] < most_deaths) {
            waiting_.push_front(*unit);
            return;
        }
        task_.lost(*unit, cause);
    }

    using Clock = std::chrono::steady_clock;

    const PoolTask& task_;
    Clock::time_point last_tick_;
    WorkerDuty duty_;
    std::deque<int> waiting_;
    std::vector<WorkerProcess> workers_;
    std::map<int, int> deaths_;
};

constexpr std::size_t longest_message = 4096;

/// On the line a message is kind, number, text, in one packet.
struct Head {
    int kind = 0;
    int number = 0;
};

bool send_packet(int line, const void* data, std::size_t size) {
    ssize_t sent = -1;
    do {
        sent = ::send(line, data, size, MSG_NOSIGNAL);  // a dead listener is an answer, not a signal
    } while (sent < 0 && errno == EINTR);
    return sent == static_cast<ssize_t>(size);
}

/// The number of bytes; 0 where no one is there any more.
std::size_t receive_packet(int line, void* data, std::size_t size) {
    ssize_t received = -1;
    do {
        received = ::recv(line, data, size, 0);
    } while (received < 0 && errno == EINTR);
    return received > 0 ? static_cast<std::size_t>(received) : 0;
}

/// The whole life of a worker. _exit, not exit: what the parent has in its buffers is the parent's to write.
[[noreturn]] void live(const WorkerDuty& duty, int line) {
    using Kind = WorkerMessage::Kind;
    try {
        if (duty.begin) duty.begin();
        while (const std::optional<int> unit = receive_number(line)) {
            duty.work(*unit, [line](int number) { send_message(line, {Kind::told, number, {}}); });
            send_message(line, {Kind::done, *unit, {}});
        }
    } catch (const InputError& error) {
        send_message(line, {Kind::wrong_input, 0, error.what()});
    } catch (const std::exception& error) {
        send_message(line, {Kind::error, 0, error.what()});
    }
    ::_exit(0);
}

void become_worker(pid_t parent) {
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_IGN);
    // Between fork and this call the parent may have died: then no one would tell.
    if (::prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || ::getppid() != parent) ::_exit(0);
}

[[noreturn]] void fail(const char* what) {
    throw std::system_error(errno, std::generic_category(), what);
}

std::optional<int> receive_number(int line) {
    int number = 0;
    if (receive_packet(line, &number, sizeof number) != sizeof number) return std::nullopt;
    return number;
}

void send_message(int line, const WorkerMessage& message) {
    const Head head{static_cast<int>(message.kind), message.number};
    std::array<char, longest_message> packet{};
    const std::size_t length = std::min(message.text.size(), packet.size() - sizeof head);
    std::memcpy(packet.data(), &head, sizeof head);
    std::copy_n(message.text.begin(), length, packet.begin() + sizeof head);
    if (!send_packet(line, packet.data(), sizeof head + length)) ::_exit(0);  // the parent has gone
}

WorkerProcess::WorkerProcess(const WorkerDuty& duty, const std::vector<int>& not_mine) {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0)
        fail("cannot make a line to a worker");
    std::fflush(nullptr);
    const pid_t parent = ::getpid();
    process_ = ::fork();
    if (process_ < 0) {
        const int reason = errno;
        ::close(ends[0]);
        ::close(ends[1]);
        errno = reason;
        fail("cannot start a worker");
    }
    if (process_ == 0) {
        become_worker(parent);
        ::close(ends[0]);
        for (const int other : not_mine) ::close(other);
        live(duty, ends[1]);
    }
    ::close(ends[1]);
    line_ = ends[0];
}

WorkerProcess::WorkerProcess(WorkerProcess&& other) noexcept
    : process_(std::exchange(other.process_, -1)),
      line_(std::exchange(other.line_, -1)),
      unit_(std::exchange(other.unit_, std::nullopt)),
      has_served_(other.has_served_),
      unread_(other.unread_) {}

WorkerProcess& WorkerProcess::operator=(WorkerProcess&& other) noexcept {
    if (this == &other) return *this;
    end();
    process_ = std::exchange(other.process_, -1);
    line_ = std::exchange(other.line_, -1);
    unit_ = std::exchange(other.unit_, std::nullopt);
    has_served_ = other.has_served_;
    unread_ = other.unread_;
    return *this;
}

WorkerProcess::~WorkerProcess() {
    end();
}

void WorkerProcess::end() noexcept {
    if (process_ > 0) {
        if (unit_) ::kill(process_, SIGKILL);
        ::close(line_);  // an idle worker leaves by itself
        while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
        }
    }
    process_ = line_ = -1;
}

void WorkerProcess::give(int unit) {
    unit_ = unit;
    unread_ = !send_packet(line_, &unit, sizeof unit);
}

void WorkerProcess::set_idle() {
    unit_.reset();
    has_served_ = true;
}

std::optional<WorkerMessage> WorkerProcess::listen() {
    std::array<char, longest_message> packet{};
    errno = 0;
    const std::size_t size = receive_packet(line_, packet.data(), packet.size());
    if (size == 0 && errno == ECONNRESET) unread_ = true;  // so says an end that closed with a packet in it
    Head head;
    if (size < sizeof head) return std::nullopt;
    std::memcpy(&head, packet.data(), sizeof head);
    return WorkerMessage{static_cast<WorkerMessage::Kind>(head.kind), head.number,
                         std::string(packet.data() + sizeof head, size - sizeof head)};
}

std::string WorkerProcess::cause_of_death() {
    ::kill(process_, SIGKILL);  // it hung up: if it is not dead, it is of no use; if it is, nothing changes
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    ::close(line_);
    process_ = line_ = -1;
    return WIFSIGNALED(status) ? fmt::format("worker died: signal {}", WTERMSIG(status))
                               : fmt::format("worker died: exit code {}", WEXITSTATUS(status));
}

}  // namespace

PoolOutcome run_workers(const PoolTask& task) {
    return Pool(task).run();
}

}  // namespace camopt
