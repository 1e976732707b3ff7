// SPDX-License-Identifier: MIT
#include "tests/soak/known/tally.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace camopt::soak {

namespace {

std::string band_of(double condition) {
    for (const int power : {2, 4, 6, 8})
        if (condition < std::pow(10.0, power)) return fmt::format("1e{} … 1e{}", power - 2, power);
    return "1e8 and more";
}

std::string class_of(const KnownScene& scene) {
    // One that is extreme from the start may have moved numbers as well.
    if (!scene.change.empty()) return scene.change.substr(0, scene.change.find(", "));
    // Those near the impossible by the decade of their distance.
    if (scene.answer.margin > 0.0 && scene.answer.margin < 1e-7)
        return fmt::format("1e{} from impossible",
                           static_cast<int>(std::floor(std::log10(scene.answer.margin))));
    return scene.kind;
}

std::string answer_of(const KnownAnswer& answer) {
    return answer.margin == 0.0 ? "optimum" : answer.feasible ? "feasible" : "infeasible";
}

}  // namespace

KnownTally::KnownTally(std::filesystem::path file) : file_(std::move(file)) {
    std::ifstream stream(file_);
    std::string word, line;
    if (!stream) return;
    if (!(stream >> word >> next_) || word != "next")
        throw std::runtime_error(fmt::format("{}: no state of camopt_known", file_.string()));
    std::getline(stream, line);
    while (std::getline(stream, line)) {
        std::istringstream cells(line);
        Row row;
        for (std::string& cell : row) std::getline(cells, cell, '\t');
        for (long& count : rows_[row]) cells >> count;
    }
}

void KnownTally::count(const Finished& finished) {
    ++rows_[finished.row][static_cast<std::size_t>(finished.judgement)];
    ++next_;
}

void KnownTally::add(long number, const KnownScene& scene, const Judged& judged) {
    ahead_[number] = {{class_of(scene), answer_of(scene.answer), band_of(scene.answer.condition)},
                      judged.judgement};
    while (!ahead_.empty() && ahead_.begin()->first == next_) {
        count(ahead_.begin()->second);
        ahead_.erase(ahead_.begin());
    }
}

void KnownTally::save() const {
    if (file_.empty()) return;
    if (file_.has_parent_path()) std::filesystem::create_directories(file_.parent_path());
    const std::filesystem::path written = file_.string() + ".new";
    {
        std::ofstream stream(written);
        stream << "next " << next_ << "\n";
        for (const auto& [row, counts] : rows_) {
            for (const std::string& cell : row) stream << cell << '\t';
            for (std::size_t k = 0; k < counts.size(); ++k)
                stream << counts[k] << (k + 1 < counts.size() ? '\t' : '\n');
        }
    }
    std::filesystem::rename(written, file_);
}

long KnownTally::count(Judgement judgement) const {
    long sum = 0;
    for (const auto& [row, counts] : rows_) sum += counts[static_cast<std::size_t>(judgement)];
    return sum;
}

long KnownTally::scenes() const {
    long sum = 0;
    for (const Judgement one : {Judgement::right, Judgement::open, Judgement::wrong, Judgement::refused})
        sum += count(one);
    return sum;
}

std::string KnownTally::table() const {
    std::string text = fmt::format("{:<44}{:<12}{:<14}{:>9}{:>9}{:>7}{:>7}{:>9}\n", "class", "answer",
                                   "condition", "scenes", "right", "open", "wrong", "refused");
    for (const auto& [row, counts] : rows_)
        text += fmt::format("{:<44}{:<12}{:<14}{:>9}{:>9}{:>7}{:>7}{:>9}\n", row[0], row[1], row[2],
                            counts[0] + counts[1] + counts[2] + counts[3], counts[0], counts[1], counts[2],
                            counts[3]);
    return text + fmt::format("{} scenes, {} right, {} open, {} wrong, {} refused\n", scenes(),
                              count(Judgement::right), count(Judgement::open), count(Judgement::wrong),
                              count(Judgement::refused));
}

}  // namespace camopt::soak
