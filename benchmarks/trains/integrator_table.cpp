// SPDX-License-Identifier: MIT
// integrator_table: the response of a follower train by matrix exponentials beside integrators of other
// libraries, over eight decades of stiffness and damping from none to twice critical.
//
// CSV on the standard output, a row a run: train, stiffness_ratio, damping_ratio, method, kind (exact,
// implicit, explicit), control (tolerance, or steps), status, error (of place and rate of the output at the
// end of the rise, by their largest over it, against 113 bits), seconds, ratio (to the exact response of the
// same case), evaluations. What each needs for an error of 1e-6 goes to stderr, as ratios.
#include "benchmarks/parts/whole_output.hpp"
#include "benchmarks/trains/exact_chain.hpp"
#include "benchmarks/trains/integrators.hpp"
#include "dynamics/train_formulas.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "report/csv/csv_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace camopt::benchmarks {

namespace {

constexpr double accurate = 1e-6;
constexpr double least_seconds = 2e-3;  // a quicker run is repeated for so long
constexpr int least_repeats = 3;

struct TrainCase {
    const char* train;
    double ratio, damping;
    trains::Chain chain;
};

std::vector<TrainCase> train_cases() {
    std::vector<TrainCase> cases;
    for (const double damping : {0.0, 0.02, 0.3, 1.0, 2.0})
        for (int decade = 0; decade <= 8; ++decade) {
            const double ratio = std::pow(10.0, decade);
            cases.push_back({"one mass", ratio, damping, trains::one_mass(ratio, damping)});
            cases.push_back({"two masses", ratio, damping, trains::two_masses(ratio, damping)});
        }
    return cases;
}

DynamicsSpec spec_of(const trains::Chain& chain) {
    DynamicsSpec spec;
    for (const trains::Mass& mass : chain.masses)
        spec.stages.push_back({mass.mass, mass.stiffness, mass.damping});
    spec.mass = spec.stages.back().mass;
    spec.stiffness = spec.stages.back().stiffness;
    spec.damping = spec.stages.back().damping;
    spec.stages.pop_back();
    return spec;
}

/// u_n, v_n by camopt, everything made anew. with_peaks: the largest |e_n| over the rise as well.
trains::Run camopt_response(const trains::Chain& chain, const Motion& law, bool with_peaks) {
    const auto formulas = train_formulas(spec_of(chain));
    const auto train = formulas->at(1.0, 1.0, 1.0);
    const std::vector<SlopePiece> pieces = formulas->pieces(law);
    const auto states = train->states_along(pieces, Eigen::VectorXd::Zero(train->states()), 0.0);
    const Eigen::VectorXd& end = states.back();
    double peak = 0.0;
    for (std::size_t i = 0; with_peaks && i < pieces.size(); ++i)
        for (const double sign : {1.0, -1.0})
            for (const Extremum& one : train->maxima(train->deflection(), sign, states[i], pieces[i], peak))
                peak = std::max(peak, one.value);
    // X holds the velocities times the root of the mass.
    const Eigen::Index last = end.size() - 1;
    const double rate = end[last] / std::sqrt(chain.masses.back().mass);
    return {
        {train->deflection().state.dot(end) / chain.size, rate / (chain.size * chain.frequency)}, 0, "ok"};
}

struct TimedRun {
    trains::Run run;
    double seconds = 0.0;
};

/// The least of some runs: what else the machine does only adds.
TimedRun timed(const std::function<trains::Run()>& work) {
    using Clock = std::chrono::steady_clock;
    TimedRun result{{}, HUGE_VAL};
    double spent = 0.0;
    for (int k = 0; k < least_repeats || spent < least_seconds; ++k) {
        const auto begin = Clock::now();
        result.run = work();
        const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
        result.seconds = std::min(result.seconds, seconds);
        spent += seconds;
        if (seconds > 0.1) break;
    }
    return result;
}

class IntegratorTable {
 public:
    void measure(const TrainCase& one) {
        const trains::ExactResponse truth = trains::exact_response(one.chain);
        const auto law = make_law("polynomial_345");
        exact_seconds_ = 0.0;
        for (const bool peaks : {false, true}) {
            const TimedRun own = timed([&] { return camopt_response(one.chain, *law, peaks); });
            if (!peaks) exact_seconds_ = own.seconds;
            add(one, truth, peaks ? "exact with its peak" : "exact", "exact", 0.0, own, 2);
        }
        for (const auto& all : {trains::odeint_integrators(), trains::sundials_integrators()})
            for (const trains::Integrator& method : all)
                for (const double control : method.controls) {
                    const TimedRun run = timed([&] { return method.run(one.chain, control); });
                    add(one, truth, method.name, method.implicit ? "implicit" : "explicit", control, run,
                        one.chain.states());
                }
    }

    /// One line a train and damping, one column a stiffness: seconds for an error of 1e-6 by those of the
    /// exact response; "-": none of its runs got there.
    void print_summary() const {
        fmt::print(stderr, "time for an error of {:g}, by that of the exact end state\n", accurate);
        for (const auto& [name, least] : least_)
            for (const auto& [key, ratios] : least) {
                std::string line = fmt::format("{:26} {:10} damping {:4}:", name, key.first, key.second);
                for (const auto& [stiffness, ratio] : ratios)
                    line += ratio ? fmt::format(" {:7.3g}", *ratio) : fmt::format(" {:>7}", "-");
                fmt::print(stderr, "{}\n", line);
            }
    }

 private:
    void add(const TrainCase& one, const trains::ExactResponse& truth, const std::string& method,
             const char* kind, double control, const TimedRun& timed_run, std::size_t states) {
        const trains::Run& run = timed_run.run;
        std::optional<double> error;
        std::string status = run.status;
        if (status == "ok") {
            const double place = run.state[states / 2 - 1], rate = run.state[states - 1];
            const double distance = std::max(std::abs(place - truth.output) / truth.largest_output,
                                             std::abs(rate - truth.rate) / truth.largest_rate);
            if (!(distance < 1.0)) status = "wrong";
            if (std::isfinite(distance)) error = distance;
        }
        const double ratio = timed_run.seconds / exact_seconds_;
        auto& best = least_[method][{one.train, one.damping}][one.ratio];
        if (error && *error <= accurate) best = std::min(best.value_or(HUGE_VAL), ratio);
        CsvLine line;
        line.words(one.train).number(one.ratio).number(one.damping).words(method).words(kind);
        line.number(control).words(status).number(error).number(timed_run.seconds).number(ratio);
        std::fputs(line.count(static_cast<int>(run.evaluations)).finish().c_str(), stdout);
    }

    using Series = std::map<double, std::optional<double>>;
    std::map<std::string, std::map<std::pair<std::string, double>, Series>> least_;
    double exact_seconds_ = 1.0;
};

void run() {
    std::puts(
        "train,stiffness_ratio,damping_ratio,method,kind,control,status,error,seconds,ratio,evaluations");
    if (trains::odeint_integrators().empty())
        fmt::print(stderr, "integrator_table: no Boost (libboost-dev): without odeint\n");
    if (trains::sundials_integrators().empty())
        fmt::print(stderr, "integrator_table: no SUNDIALS (libsundials-dev): without CVODE and ARKODE\n");
    IntegratorTable table;
    for (const TrainCase& one : train_cases()) table.measure(one);
    table.print_summary();
}

}  // namespace

}  // namespace camopt::benchmarks

int main() {
    const camopt::benchmarks::WholeOutput output;
    try {
        camopt::benchmarks::run();
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "integrator_table: %s\n", error.what());
        return 1;
    }
}
