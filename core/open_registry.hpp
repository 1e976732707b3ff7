// SPDX-License-Identifier: MIT
// A list of what there is to choose from by name, which a program may add to: each entry a description and
// what makes the thing. Threads may read and add at once. Nothing is ever taken away, and a span that was
// handed out stays as it was.
#pragma once

#include <atomic>
#include <deque>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

namespace camopt {

template <class Description, class Maker>
class OpenRegistry {
 public:
    struct Lists {
        std::vector<Description> descriptions;
        std::vector<Maker> makers;  ///< of each
    };

    explicit OpenRegistry(Lists first) {
        versions_.push_back(std::move(first));
        newest_ = &versions_.back();
    }

    [[nodiscard]] const Lists& lists() const { return *newest_.load(); }
    [[nodiscard]] std::span<const Description> descriptions() const { return lists().descriptions; }

    /// `check` is called with what there is before the entry is added, and throws where it may not be.
    template <class Check>
    void add(Description description, Maker maker, const Check& check) {
        const std::lock_guard lock(mutex_);
        Lists next = versions_.back();
        check(std::as_const(next));
        next.descriptions.push_back(std::move(description));
        next.makers.push_back(std::move(maker));
        versions_.push_back(std::move(next));
        newest_ = &versions_.back();
    }

 private:
    std::mutex mutex_;
    std::deque<Lists> versions_;  ///< readers may hold any of them
    std::atomic<const Lists*> newest_{nullptr};
};

}  // namespace camopt
