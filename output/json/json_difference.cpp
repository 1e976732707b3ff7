// SPDX-License-Identifier: MIT
#include "output/json/json_difference.hpp"

#include "core/text/printable.hpp"
#include "input/result/json_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

using input::json_words;

class TolerantComparison {
 public:
    explicit TolerantComparison(double tolerance) : tolerance_(tolerance) {}

    [[nodiscard]] std::string difference(const Json& found, const Json& allowed,
                                         const std::string& path) const {
        if (found.is_object() && allowed.is_object()) return of_objects(found, allowed, path);
        if (found.is_array() && allowed.is_array() && found.size() == allowed.size())
            return of_lists(found, allowed, path);
        const bool same = found.is_number() && allowed.is_number()
                              ? close(found.get<double>(), allowed.get<double>())
                              : found == allowed;
        return same ? ""
                    : fmt::format("{}: found {}; allowed: {}", printable(path), json_words(found),
                                  json_words(allowed));
    }

 private:
    double tolerance_;

    [[nodiscard]] bool close(double found, double allowed) const {
        const double size = std::max({1.0, std::abs(found), std::abs(allowed)});
        return std::abs(found - allowed) <= tolerance_ * size;
    }

    [[nodiscard]] std::string of_objects(const Json& found, const Json& allowed,
                                         const std::string& path) const {
        const auto inside = [&path](const std::string& key) { return path.empty() ? key : path + "." + key; };
        for (const auto& [key, value] : found.items()) {
            const auto own = allowed.find(key);
            if (own == allowed.end())
                return fmt::format("{}: found a key that is none of it", printable(inside(key)));
            const bool place = (key == "at" || key == "at_deg") && value.is_number() && own->is_number();
            if (place) continue;
            if (std::string text = difference(value, *own, inside(key)); !text.empty()) return text;
        }
        for (const auto& [key, value] : allowed.items())
            if (!found.contains(key)) return fmt::format("{}: found no such key", printable(inside(key)));
        return "";
    }

    [[nodiscard]] std::string of_lists(const Json& found, const Json& allowed,
                                       const std::string& path) const {
        for (std::size_t i = 0; i < found.size(); ++i)
            if (std::string text = difference(found[i], allowed[i], fmt::format("{}[{}]", path, i));
                !text.empty())
                return text;
        return "";
    }
};

}  // namespace

std::string json_difference(const Json& found, const Json& allowed, double tolerance) {
    return TolerantComparison(tolerance).difference(found, allowed, "");
}

}  // namespace camopt
