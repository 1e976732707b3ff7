// SPDX-License-Identifier: MIT
#include "report/json/certificate_json.hpp"

#include "core/errors.hpp"
#include "core/text/text_file.hpp"
#include "solvers/certificate/box_proof.hpp"
#include "tests/report/sample_solution.hpp"
#include "tests/report/temporary_folder.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace camopt {
namespace certificate_json_test {

using testing_support::says;

DualityProof written_and_read(const Certificate& certificate) {
    const test::TemporaryFolder folder;
    const std::string path = folder.path() + "/certificate.json";
    write_text_file(path, certificate_json(certificate));
    return read_certificate(path);
}

std::string refusal(const std::string& text) {
    const test::TemporaryFolder folder;
    const std::string path = folder.path() + "/certificate.json";
    write_text_file(path, text);
    return testing_support::refusal([&] { (void)read_certificate(path); });
}

TEST(CertificateJson, ProofRoundTripsBitForBit) {
    const Certificate certificate = test::sample_solution().certificate;
    const DualityProof& proof = *certificate.proof;
    const DualityProof read = written_and_read(certificate);
    EXPECT_EQ(read.statement, proof.statement);
    EXPECT_EQ(read.variables, proof.variables);
    EXPECT_EQ(read.rows, proof.rows);
    EXPECT_EQ(read.origins, proof.origins);
    EXPECT_EQ(read.cost, proof.cost);
    EXPECT_EQ(read.constant, proof.constant);
    EXPECT_EQ(Eigen::MatrixXd(read.matrix), Eigen::MatrixXd(proof.matrix));
    EXPECT_EQ(read.lower, proof.lower);
    EXPECT_EQ(read.upper, proof.upper);
    EXPECT_EQ(read.multipliers, proof.multipliers);
    EXPECT_EQ(read.box.lower, proof.box.lower);
    EXPECT_EQ(read.box.upper, proof.box.upper);
    EXPECT_EQ(read.bound, proof.bound);
}

/// The file of what was read, which must be the file that it was read from.
std::string written_again(const Certificate& certificate) {
    return certificate_json(certificate_of_text(certificate_json(certificate), "c"));
}

TEST(CertificateJson, SharedProofsRoundTrip) {
    Certificate certificate = test::sample_solution().certificate;
    const auto proof = std::make_shared<const DualityProof>(*certificate.proof);
    certificate.cases = {{{"a rises"}, 1.5, false, proof, {{.segment = 2, .rises = true}}},
                         {{"a falls", "b rests"},
                          infinity,
                          true,
                          proof,
                          {{.segment = 0, .angle_deg = {{12.5, 90.0}}}, {.segment = 2, .rises = false}}},
                         {{}, -infinity, false, nullptr}};
    EXPECT_EQ(written_again(certificate), certificate_json(certificate));
    const Certificate read = certificate_of_text(certificate_json(certificate), "c");
    ASSERT_EQ(read.cases.size(), 3U);
    EXPECT_EQ(read.cases[0].proof, read.cases[1].proof);
    EXPECT_EQ(read.cases[1].region, certificate.cases[1].region);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(read.cases[i].parts, certificate.cases[i].parts);
    EXPECT_FALSE(read.cases[2].proof);
}

TEST(CertificateJson, EveryKindOfStepRoundTrips) {
    using enum BoxStep::Kind;
    BoxProof proof;
    proof.variables = {"x", "y", "z"};
    proof.cost = Eigen::Vector3d(1.0, 0.0, -0.25);
    proof.constant = 0.125;
    proof.box = {Eigen::Vector3d(0.0, -infinity, 1.0), Eigen::Vector3d(1.0, 2.0, infinity)};
    for (const BoxStep::Kind kind : {linear, cost, plane, derived, split}) {
        BoxStep& step = proof.steps.emplace_back();
        step.kind = kind;
        step.weights = Eigen::Vector3d(0.0, 0.1, -3.0);
        step.side = 0.7;
    }
    proof.steps[0].origin = {"limits.jerk", "left side", 0.25, Side::left, true, 3, -1};
    proof.steps[0].origin.fields = {
        "axis 1", "limits.jerk", "undercut", {{"station", 4.0}}, {{"s'", -0.25}, {"base_radius", 1.0}}};
    proof.steps[2].origin = {"limits.pressure_angle_deg", "", {}, Side::right, true};
    proof.steps[2].box = {{-1.0, 2.0}, {-infinity, infinity}};
    proof.steps[2].ends = {{0, 1}, {-1, -1}};
    proof.steps[2].slope = Eigen::Vector2d(0.5, 1.0 / 3.0);
    proof.steps[2].constant = -2.0;
    proof.steps[3].multipliers = {{0, 0.5}, {2, 1e-300}};
    proof.steps[3].bounds = {4};
    proof.parts = {{{4}, {{1, 0.1}}, {3}, 0.5, false}, {{4}, {}, {}, infinity, true}};
    proof.bound = 0.5;
    Certificate certificate;
    certificate.proof_kind = ProofKind::boxes;
    certificate.box_proof = std::make_shared<const BoxProof>(proof);
    EXPECT_EQ(written_again(certificate), certificate_json(certificate));
    const Certificate whole = certificate_of_text(certificate_json(certificate), "c");
    ASSERT_TRUE(whole.box_proof);
    const BoxProof& read = *whole.box_proof;
    EXPECT_EQ(read.cost, proof.cost);
    EXPECT_EQ(read.box.upper, proof.box.upper);
    ASSERT_EQ(read.steps.size(), proof.steps.size());
    for (std::size_t i = 0; i < read.steps.size(); ++i) {
        EXPECT_EQ(read.steps[i].kind, proof.steps[i].kind);
        EXPECT_EQ(read.steps[i].weights, proof.steps[i].weights);
        EXPECT_EQ(read.steps[i].origin, proof.steps[i].origin);
        EXPECT_EQ(read.steps[i].multipliers, proof.steps[i].multipliers);
        EXPECT_EQ(read.steps[i].ends, proof.steps[i].ends);
        EXPECT_EQ(read.steps[i].constant, proof.steps[i].constant);
    }
    EXPECT_EQ(read.steps[2].slope, proof.steps[2].slope);
    EXPECT_EQ(read.steps[2].box[1].lower, -infinity);
    EXPECT_EQ(read.parts[0].multipliers, proof.parts[0].multipliers);
    EXPECT_EQ(read.parts[1].bound, infinity);
}

TEST(CertificateJson, AnOpenSideIsNull) {
    const auto json = nlohmann::json::parse(certificate_json(test::sample_solution().certificate));
    EXPECT_TRUE(json["proof"]["rows"][0]["lower"].is_null());
    EXPECT_EQ(json["proof"]["rows"][0]["upper"], 0.7);
    EXPECT_EQ(json["proof"]["rows"][0]["indices"], (std::vector<int>{0, 2}));
    EXPECT_TRUE(json["proof"]["box"]["upper"][1].is_null());
    EXPECT_EQ(json["verdict"], "optimal");
    EXPECT_EQ(json["how_to_check"], how_to_check());
}

TEST(CertificateJson, RowsHaveFieldsAndWords) {
    Certificate certificate = test::sample_solution().certificate;
    certificate.proof->origins[0].fields = {"feed", "limits.torque_max_nm", "", {{"load_speed", 2.0}}, {}};
    const auto json = nlohmann::json::parse(certificate_json(certificate));
    EXPECT_EQ(json["format"], 2);
    const auto& origin = json["proof"]["rows"][0]["origin"];
    EXPECT_EQ(origin["axis"], "feed");
    EXPECT_EQ(origin["key"], "limits.torque_max_nm");
    EXPECT_EQ(origin["which"]["load_speed"], 2.0);
    EXPECT_FALSE(origin.contains("part"));
    EXPECT_FALSE(origin.contains("made"));
}

TEST(CertificateJson, RefusesWhatIsNoProof) {
    EXPECT_TRUE(says(refusal(certificate_json(Certificate{})), "holds no proof"));
    EXPECT_TRUE(says(refusal("hello"), "certificate.json: found no JSON"));
    EXPECT_TRUE(says(refusal("{}"), "certificate.json: proof: found no such key; allowed: a certificate"));
    EXPECT_THROW((void)read_certificate("/nowhere/certificate.json"), InputError);
}

TEST(CertificateJson, RefusesListsThatDoNotMatch) {
    auto json = nlohmann::json::parse(certificate_json(test::sample_solution().certificate));
    auto shorter = json;
    shorter["proof"]["cost"].erase(0);
    EXPECT_TRUE(says(refusal(shorter.dump()), "proof.cost: found a list of 2; allowed: a list of 3"));
    auto outside = json;
    outside["proof"]["rows"][1]["indices"] = {3};
    EXPECT_TRUE(says(refusal(outside.dump()), "proof.rows[1].indices: found 3; allowed: 0 or more, below 3"));
    auto missing = json;
    missing["proof"]["rows"][0]["values"].erase(0);
    EXPECT_TRUE(says(refusal(missing.dump()), "proof.rows[0].values: found a list of 1; allowed: as many"));
}

TEST(CertificateJson, NamesTheKeyThatIsWrong) {
    const auto refused_with = [](const char* place, const nlohmann::json& value) {
        auto json = nlohmann::json::parse(certificate_json(test::sample_solution().certificate));
        json[nlohmann::json::json_pointer(place)] = value;
        return testing_support::refusal([&] { (void)certificate_of_text(json.dump(), "c"); });
    };
    EXPECT_EQ(refused_with("/verdict", "best"),
              "c: verdict: found \"best\"; allowed: optimal, local, feasible, infeasible, failed");
    EXPECT_EQ(refused_with("/proof_kind", nullptr),
              "c: proof_kind: found null; allowed: none, duality, any_curve_limit, boxes");
    EXPECT_TRUE(says(refused_with("/reason", "none"), "c: reason: found \"none\"; allowed: not_run, "));
    EXPECT_EQ(refused_with("/proof/rows/0/multiplier", nullptr),
              "c: proof.rows[0].multiplier: found null; allowed: a number");
    EXPECT_EQ(refused_with("/proof/rows/0/indices/1", 1.5),
              "c: proof.rows[0].indices[1]: found 1.5; allowed: a whole number up to 2147483647");
    EXPECT_EQ(refused_with("/verified", "all"), "c: verified: found \"all\"; allowed: a list");
    EXPECT_EQ(refused_with("/cases", {{{"region", nlohmann::json::array()},
                                       {"infeasible", false},
                                       {"bound", 1.0},
                                       {"proof_of_case", 0},
                                       {"proof", nullptr}}}),
              "c: cases[0].proof_of_case: found 0; allowed: a case before it");
}

}  // namespace certificate_json_test
}  // namespace camopt
