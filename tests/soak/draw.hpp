// SPDX-License-Identifier: MIT
// Random numbers that are the same on every machine: the standard's distributions are not.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

namespace camopt::soak {

/// SplitMix64. Each trial has one of its own, made from the seed of the run and the number of the trial.
class Draw {
 public:
    explicit Draw(std::uint64_t seed) : state_(seed) {}
    Draw(std::uint64_t seed, std::uint64_t trial) : state_(seed * 0x9e3779b97f4a7c15ULL + trial) {
        state_ = next();
    }

    /// In [0, 1).
    double unit() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
    double between(double low, double high) { return low + (high - low) * unit(); }
    /// Evenly in the logarithm.
    double sized(double low, double high) { return low * std::pow(high / low, unit()); }
    /// From low to high, both included.
    int whole(int low, int high) { return low + static_cast<int>(unit() * (high - low + 1)); }
    bool chance(double probability) { return unit() < probability; }
    template <typename Value>
    Value one_of(const std::vector<Value>& values) {
        return values[static_cast<std::size_t>(unit() * static_cast<double>(values.size()))];
    }

 private:
    std::uint64_t next() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31);
    }

    std::uint64_t state_;
};

}  // namespace camopt::soak
