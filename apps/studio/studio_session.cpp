// SPDX-License-Identifier: MIT
#include "apps/studio/studio_controls.hpp"
#include "apps/studio/studio_page.hpp"
#include "core/errors.hpp"
#include "core/word_of.hpp"
#include "report/page/result_page.hpp"
#include "studies/delivered/solution.hpp"
#include "studies/least/least_value.hpp"
#include "studies/solve/solve.hpp"

#include <fmt/format.h>

#include <atomic>
#include <list>
#include <mutex>

namespace camopt::apps {

namespace {

// What the page is told of a solve, as one JSON text.
//
// A change is answered in up to three stages, so that the picture waits for nothing it does not need:
// the curve (not proved, and its words say so), the proof with words and tables, the rest (the reference law
// in the scene's place; of a scene without a motion, which change would help).
//
//   stage     "curve", "proof", "rest"
//   more      the rest is worth asking for
//   data      as page_data (report/page/result_page.hpp)
//   laws      as page_laws, of the laws asked for
//   scene     the scene as solved, TOML
//   controls  as studio_controls
//   units     "mm", "in": of its lengths
//   downloads as downloads_of
//   verdict, objective, seconds   of the solve, its own figures
enum class AnswerStage : unsigned char { curve, proof, rest };

struct AnswerWishes {
    std::vector<std::string> laws = {};
    AnswerStage stage = AnswerStage::rest;
};

const char* name_of_stage(AnswerStage stage) {
    return word_of<AnswerStage::rest>(stage, {"curve", "proof", "rest"});
}

/// A law to compare with, or a scene without a motion that may be explained.
bool has_rest(const Solution& solution) {
    return !solution.motion || solution.certificate.verdict == Verdict::infeasible ||
           !solution.scene.objective.reference.numeric;
}

/// Throws InputError for a law that is not in the catalogue.
std::string studio_answer(const Solution& solution, const std::string& text, const AnswerWishes& wishes) {
    using Json = nlohmann::ordered_json;
    const double objective = solution.certificate.objective;
    const Json own = {{"verdict", name_of(solution.certificate.verdict)},
                      {"objective", std::isfinite(objective) ? Json(objective) : Json(nullptr)},
                      {"seconds", solution.seconds_total},
                      {"stage", name_of_stage(wishes.stage)},
                      {"more", wishes.stage == AnswerStage::proof && has_rest(solution)},
                      {"scene", text},
                      {"units", name_of(solution.scene.length_unit)},
                      {"downloads", downloads_of(solution.scene)},
                      {"controls", studio_controls(text)}};
    // Texts of JSON side by side: the curves need not be read to be sent on.
    std::string answer = own.dump(-1, ' ', false, Json::error_handler_t::replace);
    answer.back() = ',';
    const View view(solution);
    answer += "\"laws\":" + page_laws(view, wishes.laws) + ",\"data\":";
    answer += page_data(
        view, {.scene_file = "scene.toml", .command = "camopt solve scene.toml", .scene_text = text},
        {.reference = wishes.stage == AnswerStage::rest ? PageReference::compared : PageReference::later,
         .proof = wishes.stage != AnswerStage::curve});
    return answer + "}";
}

using RequestJson = nlohmann::ordered_json;

// Two places of a slider are near neighbours: a grid of three times the plain one still saves more than it
// costs.
constexpr double neighbour_growth = 3.0;

/// A request that cannot be read; its text is for who wrote the page.
class RequestError : public InputError {
    using InputError::InputError;
};

/// A newer request came, or the studio ends.
class Superseded : public std::exception {};

struct Request {
    std::string page, scene, what;
    RequestJson set = RequestJson::object();
    std::optional<LengthUnit> units;
    std::vector<std::string> laws;
    AnswerStage stage = AnswerStage::proof;
};

[[noreturn]] void bad_member(std::string_view name, std::string_view allowed) {
    throw RequestError(fmt::format("the request's \"{}\" is not what is allowed: {}", name, allowed));
}

std::string text_member(const RequestJson& body, const char* name, std::size_t most) {
    const auto found = body.find(name);
    if (found == body.end() || !found->is_string() || found->get_ref<const std::string&>().size() > most)
        bad_member(name, fmt::format("a text of at most {} bytes", most));
    return found->get<std::string>();
}

std::vector<std::string> law_members(const RequestJson& body, std::size_t most) {
    const auto found = body.find("laws");
    if (found == body.end()) return {};
    const auto is_text = [](const RequestJson& law) { return law.is_string(); };
    if (!found->is_array() || found->size() > most || !std::ranges::all_of(*found, is_text))
        bad_member("laws", fmt::format("an array of at most {} keys of laws", most));
    return found->get<std::vector<std::string>>();
}

AnswerStage stage_member(const RequestJson& body) {
    const auto found = body.find("stage");
    if (found == body.end() || *found == "proof") return AnswerStage::proof;
    if (*found == "curve") return AnswerStage::curve;
    if (*found == "rest") return AnswerStage::rest;
    bad_member("stage", R"("curve", "proof", "rest")");
}

std::optional<LengthUnit> units_member(const RequestJson& body) {
    const auto found = body.find("units");
    if (found == body.end()) return std::nullopt;
    for (const LengthUnit unit : {LengthUnit::millimetre, LengthUnit::inch})
        if (*found == name_of(unit)) return unit;
    bad_member("units", R"("mm", "in")");
}

Request read_request(const std::string& text, const StudioLimits& limits, bool is_download) {
    const RequestJson body = RequestJson::parse(text, nullptr, false);
    if (!body.is_object()) throw RequestError("the request is no JSON object");
    constexpr std::size_t longest_name = 64, longest_scene = 1'000'000;
    Request request;
    request.page = text_member(body, "page", longest_name);
    request.scene = text_member(body, "scene", longest_scene);
    if (is_download) request.what = text_member(body, "what", longest_name);
    if (const auto set = body.find("set"); set != body.end()) {
        if (!set->is_object() || set->size() > limits.settings)
            bad_member("set", fmt::format("an object of at most {} keys", limits.settings));
        request.set = *set;
    }
    request.laws = law_members(body, limits.laws);
    request.units = units_member(body);
    request.stage = stage_member(body);
    return request;
}

/// An open page: its solves one after another, each from what the one before found.
struct Page {
    std::string name;
    std::atomic<unsigned long> newest{0};
    std::mutex turn;
    KnownSolutions known{.most_growth = neighbour_growth};
    std::string proved_text;         ///< the scene that was proved last; empty: none
    std::optional<Solution> proved;  ///< of it

    /// Says the rest of a scene without solving it again.
    [[nodiscard]] bool knows(const StudioScene& given) const {
        return proved && proved_text == given.text && proved->motion &&
               proved->certificate.verdict != Verdict::infeasible;
    }
};

StudioAnswer answer_of(int status, const RequestJson& body) {
    return {.status = status, .body = body.dump(-1, ' ', false, RequestJson::error_handler_t::replace)};
}

StudioAnswer error_answer(int status, std::string_view what) {
    return answer_of(status, {{"error", what}});
}

/// For a picture that the next one follows within a tenth of a second: no eye sees the difference, and the
/// rounds that find the last digits are left out.
void loosen(Scene& scene) {
    constexpr double tolerance = 1e-6, gap = 1e-4;
    scene.solver.tolerance = std::max(scene.solver.tolerance, tolerance);
    scene.solver.gap = std::max(scene.solver.wanted_gap(false), gap);
}

/// Faults become answers.
template <typename Work>
StudioAnswer answered(const Work& work) {
    try {
        return work();
    } catch (const Superseded&) {
        return error_answer(409, "a newer request came");
    } catch (const RequestError& error) {
        return error_answer(400, error.what());
    } catch (const InputError& error) {
        return error_answer(422, error.what());
    } catch (const std::exception& error) {
        return error_answer(500, fmt::format("internal error: {}", error.what()));
    }
}

}  // namespace

struct StudioSession::State {
    StudioLimits limits;
    std::atomic<bool> stopping{false};
    std::mutex mutex;
    std::list<std::shared_ptr<Page>> pages;                   ///< the one heard of last in front
    KnownSolutions opening{.most_growth = neighbour_growth};  ///< of the scene that pages open with

    std::shared_ptr<Page> page_named(const std::string& name) {
        const std::lock_guard lock(mutex);
        const auto found = std::ranges::find(pages, name, [](const auto& page) { return page->name; });
        if (found != pages.end()) {
            pages.splice(pages.begin(), pages, found);
        } else {
            pages.push_front(std::make_shared<Page>());
            pages.front()->name = name;
            pages.front()->known = opening;
        }
        while (pages.size() > limits.pages) {
            ++pages.back()->newest;  // what it still solves is for no one
            pages.pop_back();
        }
        return pages.front();
    }

    [[nodiscard]] SolveControl control(const Scene& scene, double seconds, std::function<bool()> stop) const {
        return {.stop_requested = std::move(stop),
                .progress = {},
                .deadline = Deadline::after(std::min(seconds, scene.solver.max_seconds))};
    }

    StudioAnswer solve(const std::string& body) {
        const Request request = read_request(body, limits, false);
        const std::shared_ptr<Page> page = page_named(request.page);
        const unsigned long number = ++page->newest;
        const auto outdated = [&] { return stopping || page->newest != number; };
        const std::lock_guard turn(page->turn);
        if (outdated()) throw Superseded();
        StudioScene given = studio_scene(request.scene, request.set, "scene", request.units);
        if (request.stage == AnswerStage::rest && page->knows(given))
            return {.body = studio_answer(*page->proved, given.text, {request.laws, request.stage})};
        if (request.stage == AnswerStage::curve) loosen(given.scene);
        const SolveControl solving = control(given.scene, limits.solve_seconds, outdated);
        Solution solution = solved(given.scene, request.stage, *page, solving);
        if (outdated()) throw Superseded();
        StudioAnswer answer{.body = studio_answer(solution, given.text, {request.laws, request.stage})};
        if (request.stage == AnswerStage::proof) {
            page->proved_text = given.text;
            page->proved = std::move(solution);
        }
        return answer;
    }

    static Solution solved(const Scene& scene, AnswerStage stage, Page& page, const SolveControl& control) {
        switch (stage) {
            case AnswerStage::curve:
                return solve_asked(scene, control, &page.known, {.look = true});
            case AnswerStage::proof:
                return solve_asked(scene, control, &page.known);
            case AnswerStage::rest:
                break;
        }
        return camopt::solve(scene, control);  // explains what has no motion
    }

    /// New pages go on from what it found.
    std::string first(const std::string& scene) {
        const StudioScene given = studio_scene(scene, RequestJson::object(), "scene");
        const auto ending = [this] { return stopping.load(); };
        const SolveControl solving = control(given.scene, limits.solve_seconds, ending);
        KnownSolutions known{.most_growth = neighbour_growth};
        Solution solution = solve_asked(given.scene, solving, &known);
        {
            const std::lock_guard lock(mutex);
            opening = std::move(known);
        }
        const bool to_explain = !solution.motion || solution.certificate.verdict == Verdict::infeasible;
        if (to_explain) solution = camopt::solve(given.scene, solving);
        return studio_answer(solution, given.text, {});
    }

    /// As the command line would: from the scene alone, not from the solve before.
    StudioAnswer download(const std::string& body) {
        const Request request = read_request(body, limits, true);
        const std::shared_ptr<Page> page = page_named(request.page);
        const std::lock_guard turn(page->turn);
        const auto ending = [this] { return stopping.load(); };
        if (ending()) throw Superseded();
        StudioScene given = studio_scene(request.scene, request.set, "scene", request.units);
        return studio_download(request.what, given, control(given.scene, limits.download_seconds, ending));
    }
};

StudioSession::StudioSession(const StudioLimits& limits) : state_(std::make_unique<State>()) {
    state_->limits = limits;
}

StudioSession::~StudioSession() = default;

StudioAnswer StudioSession::solve(const std::string& body) {
    if (state_->stopping) return error_answer(503, "the studio ends");
    return answered([&] { return state_->solve(body); });
}

StudioAnswer StudioSession::download(const std::string& body) {
    if (state_->stopping) return error_answer(503, "the studio ends");
    return answered([&] { return state_->download(body); });
}

std::string StudioSession::first(const std::string& scene) {
    return state_->first(scene);
}

void StudioSession::stop() {
    state_->stopping = true;
}

}  // namespace camopt::apps
