// What a run leaves in its directory, and the report on it.

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "base/output_file.h"
#include "post/output/contact_output.h"
#include "post/output/field_output.h"
#include "post/output/result_files.h"
#include "post/output/summary.h"
#include "post/report/report.h"
#include "post/report/results/results_directory.h"
#include "post/view/view_output.h"
#include "tests/support/private_directory.h"
#include "tests/unit/post/cylinder_on_a_block.h"

namespace geneva::post {
namespace {

/// Written as the program does, by its own functions.
class RunDocuments : public CylinderOnABlock {
 protected:
  static RunReport report_of(const Cylinder& run) {
    RunReport report = run.errors;
    report.about.name = "cylinder";
    report.about.title = "A cylinder on a block";
    report.about.units = base::UnitSystem::mm_newton;
    report.about.content = "cylinder";
    report.about.date = "2026-01-31T12:00:00";
    report.about.inputs = "set Model = geometry\n";
    report.accuracy = wanted_accuracy;
    report.allowed.contact_pressure = 2. * run.peak();
    report.notices = {"the load is small"};
    return report;
  }

  static void write(const Cylinder& run, const std::filesystem::path& directory) {
    const auto put = [&](const char* const name, const nlohmann::json& document) {
      base::write_text(own_file(directory, name), document.dump() + "\n");
    };
    put("summary.json", summary(run.solution, run.results, report_of(run)));
    put("view.json", view_document(run.solution, run.results, base::UnitSystem::mm_newton));
    write_contact(run.solution, run.results, std::nullopt, base::UnitSystem::mm_newton, directory);
    base::write_text(own_file(directory, "case.prm"), "set Model = geometry\n");
  }
};

TEST_F(RunDocuments, SummaryHasTheFiguresInSIUnits) {
  const nlohmann::json document =
      summary(pressed().solution, pressed().results, report_of(pressed()));
  const nlohmann::json& contact = document.at("contact");
  EXPECT_EQ(contact.at("peak_pressure").at("value"), pressed().peak());
  EXPECT_EQ(contact.at("peak_pressure").at("unit"), "Pa");
  EXPECT_EQ(contact.at("active_nodes"), pressed().solution.contacts.front().active_nodes);
  EXPECT_EQ(document.at("accuracy").at("wanted"), wanted_accuracy);
  EXPECT_EQ(document.at("safety").at(0).at("factor"), 2.);
  EXPECT_EQ(document.at("bodies").size(), 2U);
  EXPECT_EQ(document.at("notices").at(0), "the load is small");
  EXPECT_EQ(document.at("strength").size(), 2U);
}

TEST_F(RunDocuments, ContactTableCarriesTheForce) {
  const test::PrivateDirectory directory;
  write(pressed(), directory.path());
  const CsvTable table = read_results(directory.path()).tables.at("contact");
  const std::vector<double> places = table.column("arc_length").values;
  const std::vector<double> pressures = table.column("contact_pressure").values;
  ASSERT_EQ(places.size(), pressed().solution.contacts.front().nodes.size());
  double force = 0.;  // on 10 mm [N]
  for (std::size_t i = 1; i < places.size(); ++i)
    force += 10. * (places[i] - places[i - 1]) * (pressures[i] + pressures[i - 1]) / 2.;
  EXPECT_NEAR(force, 250., 0.01 * 250.);
}

TEST_F(RunDocuments, FieldsAreWrittenWithAnIndex) {
  const test::PrivateDirectory directory;
  write_fields(pressed().solution, pressed().results, base::UnitSystem::si, directory.path());
  for (const char* const name :
       {"solution.pvd", "solution.pvtu", "solution.0.vtu", "results.h5", "results.xdmf"})
    EXPECT_GT(std::filesystem::file_size(directory.path() / name), 0U) << name;
}

TEST_F(RunDocuments, ReportShowsTheAnswerAndWorksWithoutLibraries) {
  const test::PrivateDirectory directory;
  write(pressed(), directory.path());
  const Report report = make_report(read_results(directory.path()), {});
  for (const char* const part :
       {"A cylinder on a block", "peak contact pressure", "the load is small"})
    EXPECT_NE(report.html.find(part), std::string::npos) << part;
  ASSERT_TRUE(report.picture);
  EXPECT_EQ(report.picture->find("<svg"), 0U);
}

TEST_F(RunDocuments, ComparisonHasBothRuns) {
  const test::PrivateDirectory first;
  const test::PrivateDirectory second;
  write(pressed(), first.path());
  write(sliding(), second.path());
  const std::string page =
      make_comparison({read_results(first.path()), read_results(second.path())}, {});
  EXPECT_NE(page.find("peak contact pressure"), std::string::npos);
  EXPECT_NE(page.find("friction force"), std::string::npos) << "of the one that slides";
}

TEST_F(RunDocuments, ReportRefusesADirectoryWithoutResults) {
  const test::PrivateDirectory directory;
  EXPECT_THROW(read_results(directory.path()), base::InputError);
}

}  // namespace
}  // namespace geneva::post
