// SPDX-License-Identifier: MIT
#include "core/errors.hpp"
#include "core/text/text_file.hpp"
#include "report/json/certificate_reader.hpp"
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

TEST(CertificateJson, AnOpenSideIsNull) {
    const auto json = nlohmann::json::parse(certificate_json(test::sample_solution().certificate));
    EXPECT_TRUE(json["proof"]["rows"][0]["lower"].is_null());
    EXPECT_EQ(json["proof"]["rows"][0]["upper"], 0.7);
    EXPECT_EQ(json["proof"]["rows"][0]["indices"], (std::vector<int>{0, 2}));
    EXPECT_TRUE(json["proof"]["box"]["upper"][1].is_null());
    EXPECT_EQ(json["verdict"], "optimal");
    EXPECT_EQ(json["how_to_check"], how_to_check());
}

TEST(CertificateJson, RefusesWhatIsNoProof) {
    EXPECT_TRUE(says(refusal(certificate_json(Certificate{})), "holds no proof"));
    EXPECT_TRUE(says(refusal("hello"), "not a certificate of camopt"));
    EXPECT_TRUE(says(refusal("{}"), "not a certificate of camopt"));
    EXPECT_THROW((void)read_certificate("/nowhere/certificate.json"), InputError);
}

TEST(CertificateJson, RefusesListsThatDoNotMatch) {
    auto json = nlohmann::json::parse(certificate_json(test::sample_solution().certificate));
    auto shorter = json;
    shorter["proof"]["cost"].erase(0);
    EXPECT_TRUE(says(refusal(shorter.dump()), "cost: expected a list of 3 numbers, found 2"));
    auto outside = json;
    outside["proof"]["rows"][1]["indices"] = {3};
    EXPECT_TRUE(says(refusal(outside.dump()), "index 3, allowed 0 to 2"));
    auto missing = json;
    missing["proof"]["rows"][0]["values"].erase(0);
    EXPECT_TRUE(says(refusal(missing.dump()), "2 indices, but 1 values"));
}

}  // namespace certificate_json_test
}  // namespace camopt
