// run_mutants FOLDER JOBS [PART]: the tests against every mutant in FOLDER/mutants.txt (of one part, or whose line has PART in
// it). First each test runs once without a mutant and tells which places it meets; then each mutant meets the tests that meet
// its place, those first that caught others of its file, then the quick ones, until one fails. tests/mutants/equivalent.txt
// lists those that no test can catch, with the reasons.
#define DOCTEST_CONFIG_IMPLEMENT
#define DOCTEST_CONFIG_NO_POSIX_SIGNALS
#include <doctest/doctest.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "switch.hpp"

namespace {

// Of the processor. Tests that take longer without a mutant are left out; what all tests of a mutant take together without
// it; that of a listed equivalent, whose tests stop sooner.
const int kTestSeconds = 2;
const double kMutantSeconds = 20.0, kEquivalentSeconds = 3.0;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

struct Test {
  std::string name, file;
  bool usable = false;
  double seconds = -1.0;
  std::vector<unsigned char> meets; // by the order of the mutants
};

struct Mutant {
  int number = 0;
  std::string part, file, line, change, text, reason;
  std::vector<int> tests;
  enum { waiting, running, caught, survived } state = waiting;
  int by = -1;
};

std::vector<Test> tests;
std::vector<Mutant> list;
std::map<std::string, std::map<int, int>> catches; // by file and test

// ---- the tests of this program -------------------------------------------------------------------------------------------

struct Names : doctest::IReporter {
  explicit Names(const doctest::ContextOptions&) {}
  void report_query(const doctest::QueryData& data) override {
    for (unsigned i = 0; i < data.num_data; ++i) {
      tests.emplace_back();
      tests.back().name = data.data[i]->m_name;
      tests.back().file = data.data[i]->m_file.c_str();
    }
  }
  void test_run_start() override {}
  void test_run_end(const doctest::TestRunStats&) override {}
  void test_case_start(const doctest::TestCaseData&) override {}
  void test_case_reenter(const doctest::TestCaseData&) override {}
  void test_case_end(const doctest::CurrentTestCaseStats&) override {}
  void test_case_exception(const doctest::TestCaseException&) override {}
  void subcase_start(const doctest::SubcaseSignature&) override {}
  void subcase_end() override {}
  void log_assert(const doctest::AssertData&) override {}
  void log_message(const doctest::MessageData&) override {}
  void test_case_skipped(const doctest::TestCaseData&) override {}
};
REGISTER_REPORTER("names", 1, Names);

bool passes(int test) {
  doctest::Context context;
  context.setOption("first", test + 1);
  context.setOption("last", test + 1);
  context.setOption("abort-after", 1);
  return context.run() == 0;
}

// ---- processes -----------------------------------------------------------------------------------------------------------

struct Shared { // with a child
  int test;
  double since;
  bool failed;
};

struct Job {
  pid_t child = 0;
  int what = 0; // a test, or a mutant
  Shared* shared = nullptr;
  unsigned char* met = nullptr;
  std::string folder;   // its tests write there
  double seconds = 0.0; // of the processor, when it has ended
};

std::vector<Job> jobs;
std::string folder;

void* shared_memory(size_t bytes, int file) {
  void* map = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, file < 0 ? MAP_SHARED | MAP_ANONYMOUS : MAP_SHARED, file, 0);
  if (map == MAP_FAILED) std::perror("mmap"), std::exit(1);
  return map;
}

void limit(int what, rlim_t to) {
  const rlimit both{to, to};
  setrlimit(what, &both);
}

void begin_child(const Job& job, int mutant) {
  setpgid(0, 0);
  const int nothing = open("/dev/null", O_RDWR);
  for (int i = 0; i < 3; ++i) dup2(nothing, i);
  setenv("C2D_MUTANT", std::to_string(mutant).c_str(), 1);
  setenv("C2D_MUTANTS_MET", (job.folder + "/met").c_str(), 1);
  setenv("C2D_MUTANTS_BUILD", job.folder.c_str(), 1);
  c2d_mutant = mutant;
  c2d_mutant_met = job.met;
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, rlim_t{1} << 28);
  limit(RLIMIT_AS, rlim_t{4} << 30);
}

double seconds_of(const rusage& used) {
  const auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

// A test may use this much of the processor from now on: what does not end is caught.
void allow(double seconds) {
  rusage used;
  getrusage(RUSAGE_SELF, &used);
  const rlimit most{static_cast<rlim_t>(seconds_of(used) + 0.999 + seconds), RLIM_INFINITY};
  setrlimit(RLIMIT_CPU, &most);
}

void start(Job& job, int what, const std::vector<int>& order, int mutant) {
  std::fflush(stdout);
  job.what = what;
  *job.shared = {-1, now(), false};
  job.child = fork();
  if (job.child < 0) std::perror("fork"), std::exit(1);
  if (job.child > 0) return;
  begin_child(job, mutant);
  for (const int t : order) {
    *job.shared = {t, now(), false};
    const double seconds = tests[static_cast<size_t>(t)].seconds; // not known yet
    allow(seconds < 0.0 ? kTestSeconds : 1.0 + 10.0 * seconds);
    if (!passes(t)) {
      job.shared->failed = true;
      _exit(1);
    }
  }
  _exit(0);
}

// Waits for any; the job that ended, and whether well.
Job& wait_for_one(bool& well) {
  for (;; usleep(2000))
    for (Job& job : jobs) {
      if (job.child == 0) continue;
      int status = 0;
      rusage used;
      const pid_t ended = wait4(job.child, &status, WNOHANG, &used);
      const int t = job.shared->test;
      const double allowed = 100.0 + 100.0 * (t < 0 ? 0.0 : std::max(0.0, tests[static_cast<size_t>(t)].seconds));
      if (ended == 0 && now() - job.shared->since < allowed) continue;
      kill(-job.child, SIGKILL); // and what it has started
      if (ended == 0) kill(job.child, SIGKILL), waitpid(job.child, &status, 0), status = 1;
      job.child = 0;
      job.seconds = ended == 0 ? 1e9 : seconds_of(used);
      well = status == 0;
      return job;
    }
}

Job* idle() {
  for (Job& job : jobs)
    if (job.child == 0) return &job;
  return nullptr;
}

void make_jobs(int count) {
  jobs.resize(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) {
    Job& job = jobs[static_cast<size_t>(i)];
    job.folder = folder + "/work" + std::to_string(i);
    (void)!std::system(("mkdir -p " + job.folder + "/tests && ln -sfn $PWD/" + folder + "/obj " + job.folder + "/obj").c_str());
    const int file = open((job.folder + "/met").c_str(), O_RDWR | O_CREAT, 0600);
    if (file < 0 || ftruncate(file, C2D_MUTANTS_MOST) != 0) std::perror(job.folder.c_str()), std::exit(1);
    job.met = static_cast<unsigned char*>(shared_memory(C2D_MUTANTS_MOST, file));
    job.shared = static_cast<Shared*>(shared_memory(sizeof(Shared), -1));
  }
}

// ---- which test meets what -----------------------------------------------------------------------------------------------

void take_trace(Job& job, bool well) {
  Test& test = tests[static_cast<size_t>(job.what)];
  test.seconds = job.seconds;
  test.usable = well && test.seconds <= 2.0 * kTestSeconds; // with what it started
  for (size_t m = 0; m < list.size(); ++m) test.meets[m] = job.met[list[m].number];
  if (!well && !job.shared->failed) std::printf("left out, takes too long: %s\n", test.name.c_str());
  if (!well && job.shared->failed) std::printf("left out, fails without a mutant: %s\n", test.name.c_str());
}

// A trace of before serves as long as program and list are the same.
std::string trace_name() { return folder + "/trace.txt"; }

bool read_trace() {
  std::ifstream in(trace_name());
  size_t number = 0, mutants = 0;
  if (!(in >> number >> mutants) || number != tests.size() || mutants != list.size()) return false;
  for (Test& t : tests) {
    std::string meets;
    in >> t.usable >> t.seconds >> meets;
    if (meets.size() != mutants) return false;
    for (const char c : meets) t.meets.push_back(c == '1');
  }
  return true;
}

void write_trace() {
  std::ofstream out(trace_name());
  out << tests.size() << ' ' << list.size() << '\n';
  for (const Test& t : tests) {
    out << t.usable << ' ' << t.seconds << ' ';
    for (const unsigned char m : t.meets) out << (m ? '1' : '0');
    out << '\n';
  }
}

// MUTANTS_TESTS has parts of names of files, with blanks, or is `all`; without it tests/mutants/tests.txt tells.
std::vector<int> wanted_tests() {
  const char* told = std::getenv("MUTANTS_TESTS");
  std::string names = told ? told : "";
  if (names.empty()) {
    std::ifstream in("tests/mutants/tests.txt");
    for (std::string line; std::getline(in, line);)
      if (line[0] != '#') names += line + " ";
  }
  std::vector<int> wanted;
  for (size_t t = 0; t < tests.size(); ++t) {
    tests[t].meets.assign(list.size(), 0);
    bool named = names == "all";
    std::istringstream each(names);
    for (std::string name; !named && each >> name;) named = tests[t].file.find(name) != std::string::npos;
    if (named) wanted.push_back(static_cast<int>(t));
  }
  return wanted;
}

void trace() {
  if (read_trace()) return;
  const double begun = now();
  const std::vector<int> wanted = wanted_tests();
  for (size_t started = 0, ended = 0; ended < wanted.size();) {
    Job* job = started < wanted.size() ? idle() : nullptr;
    if (job) {
      std::memset(job->met, 0, C2D_MUTANTS_MOST);
      const int t = wanted[started++];
      start(*job, t, {t}, -1);
      continue;
    }
    bool well = false;
    Job& done = wait_for_one(well);
    take_trace(done, well);
    ++ended;
  }
  write_trace();
  std::printf("%zu tests traced in %.0f s\n", wanted.size(), now() - begun);
}

// ---- mutants -------------------------------------------------------------------------------------------------------------

bool read_list(const char* only) {
  std::ifstream in(folder + "/mutants.txt");
  std::string line;
  while (std::getline(in, line)) {
    Mutant m;
    std::istringstream fields(line);
    std::string number;
    for (std::string* field : {&number, &m.part, &m.file, &m.line, &m.change, &m.text}) std::getline(fields, *field, '\t');
    m.number = std::atoi(number.c_str());
    list.push_back(m);
  }
  (void)only;
  return !list.empty();
}

std::string key(const std::string& file, const std::string& change, const std::string& text) {
  return file + '\n' + change + '\n' + text;
}

// Three lines each, apart by empty ones: "file: change", the line of the source, the reason. # begins a comment.
std::map<std::string, std::string> read_equivalents() {
  std::map<std::string, std::string> all;
  std::ifstream in("tests/mutants/equivalent.txt");
  std::string head, text, reason;
  while (std::getline(in, head)) {
    const size_t colon = head.find(": ");
    if (head.empty() || head[0] == '#') continue;
    if (colon == std::string::npos || !std::getline(in, text) || !std::getline(in, reason) || reason.empty()) {
      std::printf("equivalent.txt: not understood: %s\n", head.c_str());
      std::exit(1);
    }
    text.erase(0, text.find_first_not_of(' '));
    all[key(head.substr(0, colon), head.substr(colon + 2), text)] = reason;
  }
  return all;
}

double mutant_seconds() {
  const char* wanted = std::getenv("MUTANTS_SECONDS");
  return wanted ? std::atof(wanted) : kMutantSeconds;
}

std::vector<int> order_for(const Mutant& m, size_t index) {
  std::vector<int> order;
  for (size_t t = 0; t < tests.size(); ++t)
    if (tests[t].usable && tests[t].meets[index]) order.push_back(static_cast<int>(t));
  std::map<int, int>& before = catches[m.file];
  const auto cost = [&](int t) {
    const auto found = before.find(t);
    return (tests[static_cast<size_t>(t)].seconds + 0.002) / (1.0 + (found == before.end() ? 0.0 : 3.0 * found->second));
  };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return cost(a) < cost(b); });
  double left = m.reason.empty() ? mutant_seconds() : kEquivalentSeconds;
  size_t count = 0;
  while (count < order.size() && left > 0.0) left -= tests[static_cast<size_t>(order[count++])].seconds;
  order.resize(count);
  return order;
}

void tell(const Mutant& m, const char* how) {
  std::printf("%s: %s:%s: %s\n    %s\n", how, m.file.c_str(), m.line.c_str(), m.change.c_str(), m.text.c_str());
  std::fflush(stdout);
}

// Caught on some machines alone?
bool differs(const Mutant& m) { return m.reason.rfind("Here and there", 0) == 0; }

void end(const Job& job, bool well, std::ofstream& log) {
  Mutant& m = list[static_cast<size_t>(job.what)];
  m.state = well ? Mutant::survived : Mutant::caught;
  m.by = well ? -1 : job.shared->test;
  if (m.by >= 0) ++catches[m.file][m.by];
  if (well && m.reason.empty()) tell(m, m.tests.empty() ? "met by no test" : "survived");
  if (!well && !m.reason.empty() && !differs(m)) tell(m, "caught, though listed as equivalent");
  log << m.number << '\t' << m.file << ':' << m.line << '\t' << m.change << '\t' << m.text << '\t'
      << (well ? "-" : (job.shared->failed ? "" : "crash or no end: ") + tests[static_cast<size_t>(m.by)].name) << std::endl;
}

void run(const char* only) {
  std::ofstream log(folder + "/log.txt");
  size_t m = 0, running = 0;
  for (;;) {
    while (m < list.size() && only && (list[m].part + " " + list[m].file + ":" + list[m].line).find(only) == std::string::npos)
      ++m;
    Job* job = m < list.size() ? idle() : nullptr;
    if (job) {
      list[m].tests = order_for(list[m], m);
      start(*job, static_cast<int>(m), list[m].tests, list[m].number);
      ++m, ++running;
    } else if (running > 0) {
      bool well = false;
      Job& done = wait_for_one(well);
      end(done, well, log);
      --running;
    } else {
      return;
    }
  }
}

int summary(double begun) {
  struct Sum {
    int made = 0, caught = 0, equivalent = 0, wrong = 0;
  };
  std::map<std::string, Sum> sums;
  Sum all;
  for (const Mutant& m : list) {
    if (m.state == Mutant::waiting) continue;
    for (Sum* s : {&sums[m.part], &all}) {
      ++s->made;
      const bool caught = m.state == Mutant::caught;
      const bool right = caught == m.reason.empty() || differs(m);
      ++(right ? caught ? s->caught : s->equivalent : s->wrong);
    }
  }
  std::printf("\n%-12s %7s %7s %10s %9s\n", "part", "made", "caught", "equivalent", "survived");
  sums["all"] = all;
  for (const auto& [name, s] : sums)
    std::printf("%-12s %7d %7d %10d %9d\n", name.c_str(), s.made, s.caught, s.equivalent, s.wrong);
  std::printf("in %.0f s\n", now() - begun);
  return all.wrong == 0 && all.made > 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
  if (argc < 3) return std::fprintf(stderr, "usage: run_mutants FOLDER JOBS [PART]\n"), 64;
  const double begun = now();
  folder = argv[1];
  const char* only = argc > 3 && argv[3][0] ? argv[3] : nullptr;
  const char* const names[] = {argv[0], "-ltc", "-r=names"};
  doctest::Context(3, names).run();
  if (!read_list(only)) return std::fprintf(stderr, "no list of mutants in %s\n", folder.c_str()), 1;
  make_jobs(std::max(1, std::atoi(argv[2])));
  trace();
  std::map<std::string, std::string> reasons = read_equivalents();
  for (Mutant& m : list) {
    const auto found = reasons.find(key(m.file, m.change, m.text));
    if (found != reasons.end()) m.reason = found->second;
  }
  run(only);
  return summary(begun);
}
