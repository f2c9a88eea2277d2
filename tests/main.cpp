// The test program: doctest's own report, then the line that everything reads.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <cstdio>
#include <cstdlib>
#include <sys/resource.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace {

// What a test frees stays with the process: the C library gives large blocks back at once, and to map the workspace of the next
// model page by page takes longer than to solve it.
void keep_freed_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
#endif
}

unsigned cases_run = 0, cases_failed = 0;

// Seconds of processor time that this process and the children it has waited for have used.
double processor_seconds() {
  double sum = 0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage used{};
    getrusage(who, &used);
    sum += static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
  }
  return sum;
}

// Keeps the totals of the run. With C2D_TEST_TIMES=FILE it appends a line for each case: seconds of processor time, file, name.
struct Totals : doctest::IReporter {
  explicit Totals(const doctest::ContextOptions&) : times(std::getenv("C2D_TEST_TIMES")) {}
  void report_query(const doctest::QueryData&) override {}
  void test_run_start() override {}
  void test_run_end(const doctest::TestRunStats& stats) override { cases_failed = stats.numTestCasesFailed; }
  void test_case_start(const doctest::TestCaseData& data) override { // with --first, --last not all do
    ++cases_run;
    running = &data;
    began = processor_seconds();
  }
  void test_case_reenter(const doctest::TestCaseData&) override {}
  void test_case_end(const doctest::CurrentTestCaseStats&) override {
    if (times == nullptr) return;
    if (std::FILE* file = std::fopen(times, "a")) {
      std::fprintf(file, "%.3f %s %s\n", processor_seconds() - began, running->m_file.c_str(), running->m_name);
      std::fclose(file);
    }
  }
  void test_case_exception(const doctest::TestCaseException&) override {}
  void subcase_start(const doctest::SubcaseSignature&) override {}
  void subcase_end() override {}
  void log_assert(const doctest::AssertData&) override {}
  void log_message(const doctest::MessageData&) override {}
  void test_case_skipped(const doctest::TestCaseData&) override {}

  const char* times;
  const doctest::TestCaseData* running = nullptr;
  double began = 0;
};
REGISTER_LISTENER("totals", 1, Totals);

} // namespace

int main(int argc, char** argv) {
  keep_freed_memory();
  doctest::Context context(argc, argv);
  const int result = context.run();
  if (context.shouldExit()) return result; // a query such as --list-test-cases
  std::fflush(stdout);
  std::printf("%u passed, %u failed\n", cases_run - cases_failed, cases_failed);
  return result != 0 || cases_run == 0 ? 1 : 0;
}
