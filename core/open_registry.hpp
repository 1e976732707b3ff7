// SPDX-License-Identifier: MIT
// A registry of named choices that a program may extend: each entry has a description and a factory. Threads
// may read and add concurrently. Entries are never removed, and a returned span remains valid.
#pragma once

#include "core/base/standard.hpp"

#include <atomic>
#include <deque>
#include <mutex>

namespace camopt {

template <class Description, class Maker>
class OpenRegistry {
 public:
    struct Lists {
        std::vector<Description> descriptions;
        std::vector<Maker> makers;  ///< of each
    };

    /// `name`: of a description, unique among the entries.
    OpenRegistry(std::string Description::*name, Lists first) : name_(name) {
        versions_.push_back(std::move(first));
        newest_ = &versions_.back();
    }

    [[nodiscard]] const Lists& lists() const { return *newest_.load(); }
    [[nodiscard]] std::span<const Description> descriptions() const { return lists().descriptions; }

    /// `refuse` is called if the name is taken, and throws.
    template <class Refuse>
    void add(Description description, Maker maker, const Refuse& refuse) {
        const std::lock_guard lock(mutex_);
        Lists next = versions_.back();
        const std::string& name = description.*name_;
        if (std::ranges::find(next.descriptions, name, name_) != next.descriptions.end()) refuse();
        next.descriptions.push_back(std::move(description));
        next.makers.push_back(std::move(maker));
        versions_.push_back(std::move(next));
        newest_ = &versions_.back();
    }

 private:
    std::string Description::*name_;
    std::mutex mutex_;
    std::deque<Lists> versions_;  ///< readers may hold any of them
    std::atomic<const Lists*> newest_{nullptr};
};

}  // namespace camopt
