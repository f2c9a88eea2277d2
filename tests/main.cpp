// The test program: doctest's own report, then the line that everything reads.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <cstdio>

namespace {

unsigned cases_run = 0, cases_failed = 0;

// Keeps the totals of the run; reports nothing.
struct Totals : doctest::IReporter {
  explicit Totals(const doctest::ContextOptions&) {}
  void report_query(const doctest::QueryData&) override {}
  void test_run_start() override {}
  void test_run_end(const doctest::TestRunStats& stats) override { cases_failed = stats.numTestCasesFailed; }
  void test_case_start(const doctest::TestCaseData&) override { ++cases_run; } // with --first, --last not all do
  void test_case_reenter(const doctest::TestCaseData&) override {}
  void test_case_end(const doctest::CurrentTestCaseStats&) override {}
  void test_case_exception(const doctest::TestCaseException&) override {}
  void subcase_start(const doctest::SubcaseSignature&) override {}
  void subcase_end() override {}
  void log_assert(const doctest::AssertData&) override {}
  void log_message(const doctest::MessageData&) override {}
  void test_case_skipped(const doctest::TestCaseData&) override {}
};
REGISTER_LISTENER("totals", 1, Totals);

} // namespace

int main(int argc, char** argv) {
  doctest::Context context(argc, argv);
  const int result = context.run();
  if (context.shouldExit()) return result; // a query such as --list-test-cases
  std::fflush(stdout);
  std::printf("%u passed, %u failed\n", cases_run - cases_failed, cases_failed);
  return result != 0 || cases_run == 0 ? 1 : 0;
}
