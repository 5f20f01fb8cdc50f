#include "reference/conformance/conformance.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "support/shared.h"
#include <gtest/gtest.h>

namespace thigma::app {
namespace {

std::string read(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::stringstream bytes;
  bytes << in.rdbuf();
  return bytes.str();
}

std::filesystem::path vectors() { return test::shared_folder() / "reference" / "vectors"; }

TEST(Conformance, every_shared_vector_passes) {
  THIGMA_NEEDS_SHARED(folder);
  int files = 0;
  for (const char* name :
       {"rotations", "coupling_linear", "coupling_nonlinear", "spline", "penalty", "texture_point",
        "texture_disk", "integrators_1", "integrators_100", "linearized_contact", "clustering",
        "error_metric", "resolution", "collapse_lp"}) {
    const std::filesystem::path path = vectors() / (std::string(name) + ".json");
    const ConformanceReport report = check_document(path.string(), read(path));
    EXPECT_EQ(report.passed, report.cases) << name << ": " << report.worst.name << ' '
                                           << report.worst.field << ' ' << report.worst.error;
    EXPECT_GT(report.cases, 0) << name;
    ++files;
  }
  EXPECT_EQ(files, 14);
}

TEST(Conformance, depth_and_slope_of_a_disk_have_tolerances_of_their_own) {
  THIGMA_NEEDS_SHARED(folder);
  nlohmann::json document = nlohmann::json::parse(read(vectors() / "texture_disk.json"));
  const auto failed_after = [&](const char* field, double by) {
    nlohmann::json copy = document;
    nlohmann::json& entry = copy["cases"][2]["out"][field][1];
    entry = entry.get<double>() + by;
    return check_document("texture_disk.json", copy.dump()).failed;
  };
  EXPECT_EQ(failed_after("delta", 1e-12), 0);
  EXPECT_EQ(failed_after("delta", 1e-9), 1);
  EXPECT_EQ(failed_after("ddelta_du", 1e-9), 0);
  EXPECT_EQ(failed_after("ddelta_du", 1e-5), 1);
}

TEST(Conformance, bisection_is_checked_beside_the_program) {
  THIGMA_NEEDS_SHARED(folder);
  nlohmann::json document = nlohmann::json::parse(read(vectors() / "collapse_lp.json"));
  const auto cases = document["cases"].size() + document["bisection"].size();
  EXPECT_EQ(check_document("collapse_lp.json", document.dump()).cases, static_cast<int>(cases));
  document["bisection"][1]["out"]["u"] = 0.5;
  EXPECT_EQ(check_document("collapse_lp.json", document.dump()).failed, 1);
}

TEST(Conformance, files_are_recognised_by_their_fields_whatever_their_name) {
  THIGMA_NEEDS_SHARED(folder);
  for (const auto& entry : std::filesystem::directory_iterator(vectors())) {
    const std::string bytes = read(entry.path());
    const ConformanceReport named = check_document(entry.path().string(), bytes);
    const ConformanceReport other = check_document("acceptance.json", bytes);
    EXPECT_EQ(other.passed, named.passed) << entry.path();
    EXPECT_EQ(other.not_implemented, named.not_implemented) << entry.path();
    EXPECT_EQ(other.failed, 0) << entry.path();
  }
}

TEST(Conformance, changed_number_fails_and_is_named) {
  THIGMA_NEEDS_SHARED(folder);
  nlohmann::json document = nlohmann::json::parse(read(vectors() / "penalty.json"));
  nlohmann::json& entry = document["cases"][4]["out"]["FT"][1];
  entry = entry.get<double>() + 1e-6;
  const ConformanceReport report = check_document("penalty.json", document.dump());
  EXPECT_EQ(report.failed, 1);
  EXPECT_EQ(report.worst.name, document["cases"][4]["name"].get<std::string>());
  EXPECT_EQ(report.worst.field, "FT");
  EXPECT_NEAR(report.worst.error, 1e-6, 1e-9);
}

// Every field of every case, changed in turn, must make its case fail: nothing is compared with
// itself.
TEST(Conformance, each_result_of_each_kind_is_really_compared) {
  THIGMA_NEEDS_SHARED(folder);
  int changed = 0;
  for (const auto& file : std::filesystem::directory_iterator(vectors())) {
    const nlohmann::json original = nlohmann::json::parse(read(file.path()));
    nlohmann::json document = original;
    document["cases"] = nlohmann::json::array({original["cases"].back()});
    const nlohmann::json flat = document["cases"][0]["out"].flatten();
    std::string last_field;
    for (const auto& item : flat.items()) {
      const std::string field = item.key().substr(0, item.key().find_first_of("0123456789"));
      if (field == last_field) continue;  // one number of each array
      last_field = field;
      nlohmann::json wrong = flat;
      if (item.value().is_boolean()) {
        wrong[item.key()] = !item.value().get<bool>();
      } else if (item.value().is_number_integer()) {
        wrong[item.key()] = item.value().get<long>() + 1;
      } else if (item.value().is_number()) {
        wrong[item.key()] = item.value().get<double>() * 1.5 + 1.0;
      } else {
        wrong[item.key()] = 1.0;
      }
      nlohmann::json copy = document;
      copy["cases"][0]["out"] = wrong.unflatten();
      EXPECT_EQ(check_document("x", copy.dump()).failed, 1) << file.path() << ' ' << item.key();
      ++changed;
    }
  }
  EXPECT_GT(changed, 40);
}

std::string refusal(const std::string& text) {
  try {
    check_document("bad.json", text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Conformance, malformed_documents_are_refused_in_one_line_with_the_place) {
  const std::string head = R"({"seed":1,"schema":1,"tolerance":{"abs":1e-9},"cases":)";
  const std::string good = head + R"([{"name":"r","in":{"a":[0,0,0,1]},"out":{"log_a":[0,0,0],)"
                                  R"("dlog_a":[[2,0,0,0],[0,2,0,0],[0,0,2,0]]}}]})";
  EXPECT_EQ(check_document("bad.json", good).passed, 1);
  const std::vector<std::pair<std::string, std::string>> bad = {
      {"", "not JSON"},
      {good.substr(0, good.size() / 2), "not JSON"},
      {"[]", "expected an object"},
      {"null", "expected an object"},
      {R"({"schema":1,"tolerance":{},"cases":[]})", "at least one case"},
      {R"({"schema":2,"tolerance":{},"cases":[]})", "schema 1"},
      {R"({"schema":1,"tolerance":{}})", "\"cases\""},
      {R"({"schema":1,"cases":[]})", "\"tolerance\""},
      {head + R"([3]})", "cases[0]"},
      {head + R"([{"in":{"a":[0,0,0,1]},"out":{"log_a":[0,0,0]}}]})", "\"name\""},
      {head + R"([{"name":"r","in":{"a":[0,0,0,1]},"out":{}}]})", "results"},
      {head + R"([{"name":"r","in":{"a":[0,0,0,1]},"out":{"log_a":[0,0,0]}}]})", "dlog_a"},
      {head + R"([{"name":"r","in":{"a":[0,0,1]},"out":{"log_a":[0,0,0]}}]})", "a list of 4"},
      {head + R"([{"name":"r","in":{"a":[0,0,0,"one"]},"out":{"log_a":[0,0,0]}}]})", "in.a[3]"},
      {head + R"([{"name":"r","in":{"a":[0,0,0,null]},"out":{"log_a":[0,0,0]}}]})", "a number"},
      {head + R"([{"name":"r","in":{"zebra":1},"out":{"log_a":[0,0,0]}}]})", "known kind"},
  };
  for (const auto& [text, reason] : bad) {
    const std::string message = refusal(text);
    EXPECT_EQ(message.rfind("bad.json", 0), 0u) << text << " -> " << message;
    EXPECT_NE(message.find(reason), std::string::npos) << text << " -> " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST(Conformance, truncated_and_damaged_vectors_never_crash) {
  THIGMA_NEEDS_SHARED(folder);
  const std::string bytes = read(vectors() / "integrators_1.json");
  for (std::size_t length = 0; length < bytes.size(); length += bytes.size() / 40) {
    EXPECT_NE(refusal(bytes.substr(0, length)), "") << length;
  }
  nlohmann::json document = nlohmann::json::parse(bytes);
  for (const char* key : {"body", "coupling", "contacts", "textures", "y0", "h", "devices"}) {
    nlohmann::json copy = document;
    copy["cases"][0]["in"].erase(key);
    if (std::string(key) != "coupling") {
      EXPECT_THROW(check_document("integrators_1.json", copy.dump()), InputError) << key;
    }
    copy["cases"][0]["in"][key] = "text";
    EXPECT_THROW(check_document("integrators_1.json", copy.dump()), InputError) << key;
  }
}

TEST(Conformance, results_the_engine_does_not_know_do_not_count_as_passed) {
  const std::string text =
      R"({"schema":1,"tolerance":{},"cases":[{"name":"r","in":{"a":[0,0,0,1]},"out":{"log_a":[0,0,0],)"
      R"("dlog_a":[[2,0,0,0],[0,2,0,0],[0,0,2,0]],"colour":7}}]})";
  const ConformanceReport report = check_document("x.json", text);
  EXPECT_EQ(report.passed, 0);
  EXPECT_EQ(report.not_implemented, 1);
}

}  // namespace
}  // namespace thigma::app
