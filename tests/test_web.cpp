// The program as a page (make web): what it stands on is tested in a browser, by tests/web. Made anew by .ci/run; here what
// has been made is looked at.
#include "hosts.hpp"

using namespace test;

namespace {

const std::string kRoot = paths::root();

// A program or a library that this needs is missing: said aloud, or a failure where all are there.
bool can_look(const std::string& page) {
  if (paths::sanitized()) return false; // (the page has none of this build)
  for (const char* tool : {"python3", "chromium", "chromedriver"})
    if (!can_host(tool)) return false;
  if (fs::exists(page)) return true;
  const char* all = std::getenv("C2D_ALL_HOSTS");
  if (all != nullptr && std::string(all) == "1")
    FAIL_CHECK("there is no " << page << " (make web), and C2D_ALL_HOSTS=1");
  else
    MESSAGE("skipped: there is no " << page << " (make web)");
  return false;
}

} // namespace

TEST_CASE("web: the page in a browser") {
  const std::string page = paths::build() + "/web/contact2d.html";
  if (!can_look(page)) return;
  // C2D_WEB_TESTS='-k edit -k mistake': of the page's tests those whose names hold one of these words.
  const char* some = std::getenv("C2D_WEB_TESTS");
  const Result run =
      run_shell("PYTHONDONTWRITEBYTECODE=1 python3 '" + kRoot + "/tests/web/test_page.py' '" + page + "' '" + paths::program() +
                "' '" + paths::build() + "/web/screenshots' " + (some != nullptr ? some : ""));
  CHECK_MESSAGE(run.status == 0, run.err);
  CHECK_MESSAGE(contains(run.err, "\nOK"), run.err);
}

TEST_CASE("web: the examples come into the page as they are") {
  if (!can_host("python3")) return;
  const Folder folder;
  write_file(folder / "odd.c2s", "a \"quoted\" \\ line\twith a tab\n\nlast\n");
  const Result run = run_shell("sh '" + kRoot + "/port/web/examples.sh' '" + (folder / "odd.c2s") + "' '" + kRoot +
                               "/examples/pin.c2s' | python3 -c \"import json, sys; found = json.load(sys.stdin); "
                               "print(len(found)); sys.stdout.write(found['odd.c2s'])\"");
  CHECK_MESSAGE(run.status == 0, run.err);
  CHECK(run.out == "2\n" + read_file(folder / "odd.c2s"));
}
