// SPDX-License-Identifier: MIT
#include "objectives/rules/made_cams.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Rules = std::vector<std::shared_ptr<const CamRule>>;
using OneCam = std::function<Rules(const Scene&, const CamVariables&)>;

/// A number with a tolerance: a dimension of the cam or a number of its spring.
struct TolerantNumber {
    std::string name;
    double half_width = 0.0;  ///< SI
    int dimension = -1;       ///< of the cam, or CamVariables::spring
    double ForceSpec::*spring = nullptr;
};

std::vector<TolerantNumber> tolerant_numbers(const Scene& scene, const CamVariables& variables) {
    std::vector<TolerantNumber> all;
    for (const auto& [name, tolerance] : scene.tolerance->numbers) {
        TolerantNumber number{name};
        if (const int own = scene.cam->written_as(name); own >= 0) {
            const Dimension& value = scene.cam->dimensions[static_cast<std::size_t>(own)].value;
            number.dimension = own;
            number.half_width = tolerance.half_width(std::max(std::abs(value.low), std::abs(value.high)));
        }
        for (std::size_t k = 0; scene.forces && k < spring_numbers.size(); ++k) {
            if (std::string_view(spring_numbers[k].key) != "forces." + name) continue;
            const auto& range = (*scene.forces).*spring_numbers[k].range;
            const double size = range ? std::max(std::abs((*range)[0]), std::abs((*range)[1]))
                                      : (*scene.forces).*spring_numbers[k].number;
            number.half_width = tolerance.half_width(size);
            number.dimension = variables.spring[k];
            number.spring = spring_numbers[k].number;
        }
        all.push_back(std::move(number));
    }
    return all;
}

/// A scene and its cam with other numbers.
struct MadeCam {
    Scene scene;
    CamVariables variables;
};

void move_number(MadeCam& made, const TolerantNumber& number, double error) {
    const auto variable =
        std::ranges::find(made.variables.variables, number.dimension, &CamVariables::Variable::dimension);
    if (number.dimension >= 0 && variable != made.variables.variables.end())
        variable->error += error;
    else if (number.spring != nullptr)
        (*made.scene.forces).*number.spring += error;
    else
        made.variables.cam.dimensions[static_cast<std::size_t>(number.dimension)] += error;
}

constexpr std::string_view made_mark = "made ";

/// "base_radius-" at the lower end, "base_radius+0.25" between them.
std::string word_of(std::string_view name, double part) {
    if (std::abs(part) == 1.0) return fmt::format("{}{}", name, part < 0.0 ? '-' : '+');
    return fmt::format("{}{:+}", name, part);
}

MadeCam with_numbers(const Scene& scene, const CamVariables& variables,
                     std::span<const TolerantNumber> numbers, std::span<const double> parts) {
    MadeCam made{scene, variables};
    made.scene.tolerance.reset();
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        move_number(made, numbers[k], parts[k] * numbers[k].half_width);
        append_item(made.variables.made, word_of(numbers[k].name, parts[k]));
        made.variables.made_parts[numbers[k].name] = parts[k];
    }
    return made;
}

CamVariables with_motion(CamVariables variables, const ToleranceSpec& tolerance,
                         const std::array<double, 3>& parts) {
    std::string moved;
    for (std::size_t order = 0; order < made_cam_marks.size(); ++order) {
        const double error = tolerance.of_motion(order);
        if (error == 0.0) continue;
        variables.motion_error[order] = parts[order] * error;
        append_item(moved, word_of(made_cam_marks[order], parts[order]), " ");
        variables.made_parts[made_cam_marks[order]] = parts[order];
    }
    if (!variables.made.empty()) append_item(moved, variables.made);
    variables.made = moved.empty() ? moved : std::string(made_mark) + moved;
    return variables;
}

/// Bit k of `ends` is 1 at the lower end.
double end_of(unsigned ends, std::size_t k) {
    return ((ends >> k) & 1U) != 0U ? -1.0 : 1.0;
}

/// Of the motion; none: `ends` has a lower end of an error that is 0.
std::optional<std::array<double, 3>> motion_ends(const ToleranceSpec& tolerance, unsigned ends) {
    std::array<double, 3> parts{};
    for (std::size_t order = 0; order < parts.size(); ++order) {
        parts[order] = end_of(ends, order);
        if (tolerance.of_motion(order) == 0.0 && parts[order] < 0.0) return std::nullopt;
    }
    return parts;
}

/// One rule for all cams within the tolerances, by the cams that it is different for.
struct Family {
    std::string key;
    Rules members;
};

/// What rules of different cams have in common. `made`: the end of its remark.
std::string key_of(const CamRule& rule, const std::string& made) {
    const RowOrigin origin = rule.origin();
    std::string remark = origin.remark;
    if (!made.empty() && remark.ends_with(made)) remark.resize(remark.size() - made.size());
    return fmt::format("{}|{}|{}|{}|{}|{}", rule.name(), origin.sign, remark, rule.highest_order(),
                       rule.holds_between()[0], rule.places().size());
}

/// Any states in reach of an ordinary cam: where two rules agree at both, one of them does not depend on
/// what tells their cams apart.
constexpr std::array<MotionPoint, 2> probes = {
    {{0.0, {0.37, 1.1, 2.3, 0.0}}, {0.0, {0.61, -0.8, -1.9, 0.0}}}};

RuleValue at_probe(const CamRule& rule, const MotionPoint& probe) {
    return rule.evaluate(probe,
                         Eigen::VectorXd::Constant(static_cast<Eigen::Index>(rule.parameters().size()), 0.9));
}

/// `other` <= `rule` for every motion: linear rules that differ by a constant, or equal ones.
bool implies(const CamRule& rule, const CamRule& other) {
    const bool linear = rule.linear() && other.linear();
    return std::ranges::all_of(probes, [&](const MotionPoint& probe) {
        const RuleValue own = at_probe(rule, probe), its = at_probe(other, probe);
        return own.gradient == its.gradient && (linear ? own.value >= its.value : own.value == its.value);
    });
}

void add_to(Family& family, const std::shared_ptr<const CamRule>& rule) {
    const auto is_implied = [&](const auto& other) { return implies(*other, *rule); };
    if (std::ranges::any_of(family.members, is_implied)) return;
    std::erase_if(family.members, [&](const auto& other) { return implies(*rule, *other); });
    family.members.push_back(rule);
}

/// The rules of one more cam, each to those of the others.
void add_cam(std::vector<Family>& families, const Rules& rules, const std::string& made) {
    std::map<std::string, int> seen;
    for (const auto& rule : rules) {
        std::string key = key_of(*rule, made);
        key += fmt::format("|{}", seen[key]++);
        auto own = std::ranges::find(families, key, &Family::key);
        if (own == families.end()) own = families.insert(families.end(), {std::move(key), {}});
        add_to(*own, rule);
    }
}

}  // namespace

std::string made_cam_of(const CamRule& rule) {
    const std::string remark = rule.origin().remark;
    const std::size_t begin = remark.find(made_mark);
    return begin == std::string::npos ? std::string() : remark.substr(begin);
}

void visit_made_cam(const Scene& scene, const CamVariables& variables, const MadeParts& parts,
                    const MadeCamVisit& visit) {
    const MadeCam made = with_numbers(scene, variables, tolerant_numbers(scene, variables), parts.numbers);
    visit(made.scene, with_motion(made.variables, *scene.tolerance, parts.motion));
}

void visit_made_cams(const Scene& scene, const CamVariables& variables, const MadeCamVisit& visit) {
    const ToleranceSpec& tolerance = *scene.tolerance;
    const std::vector<TolerantNumber> numbers = tolerant_numbers(scene, variables);
    for (unsigned ends = 0; ends < (1U << numbers.size()); ++ends) {
        std::vector<double> parts;
        for (std::size_t k = 0; k < numbers.size(); ++k) parts.push_back(end_of(ends, k));
        const MadeCam made = with_numbers(scene, variables, numbers, parts);
        for (unsigned motion = 0; motion < (1U << made_cam_marks.size()); ++motion)
            if (const auto own = motion_ends(tolerance, motion))
                visit(made.scene, with_motion(made.variables, tolerance, *own));
    }
    for (const MadeParts& parts : tolerance.between) visit_made_cam(scene, variables, parts, visit);
}

FreeCam with_free_numbers(const Scene& scene, const CamVariables& drawn) {
    FreeCam free{scene, drawn, {}};
    free.scene.tolerance.reset();
    const std::vector<TolerantNumber> numbers = tolerant_numbers(scene, drawn);
    std::vector<double>& dimensions = free.variables.cam.dimensions;
    const auto add = [&](std::size_t k, int dimension) {
        free.variables.variables.push_back({dimension, static_cast<int>(free.places.size()),
                                            numbers[k].half_width,
                                            dimensions[static_cast<std::size_t>(dimension)]});
        free.places.push_back(k);
    };
    for (std::size_t k = 0; k < numbers.size(); ++k)
        if (numbers[k].spring == nullptr) add(k, numbers[k].dimension);
    for (std::size_t s = 0; s < spring_numbers.size(); ++s)
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            if (numbers[k].spring == nullptr || numbers[k].spring != spring_numbers[s].number) continue;
            free.variables.spring[s] = static_cast<int>(dimensions.size());
            dimensions.push_back((*scene.forces).*numbers[k].spring);
            add(k, free.variables.spring[s]);
        }
    return free;
}

std::vector<std::shared_ptr<const CamRule>> limits_of_made_cams(const Scene& scene,
                                                                const CamVariables& variables,
                                                                const OneCam& one) {
    std::vector<Family> families;
    visit_made_cams(scene, variables, [&](const Scene& own, const CamVariables& made) {
        add_cam(families, one(own, made), made.made);
    });
    Rules all;
    for (const Family& family : families) all.insert(all.end(), family.members.begin(), family.members.end());
    return all;
}

}  // namespace camopt
