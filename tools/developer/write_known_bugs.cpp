// Prints docs/known-bugs.md from the files of the library: write_known_bugs FOLDER, that of conformance/mutants/known.

#include <fmt/format.h>

#include <exception>
#include <string_view>
#include <vector>

#include "conformance/mutants/mutant.h"

namespace plumb {
namespace {

constexpr std::string_view kIntroduction = R"(# Known bugs

<!-- Written from the files: build/release/bin/write_known_bugs conformance/mutants/known > docs/known-bugs.md -->

A *mutant* is the tracer with one mistake planted in it, a mistake that students make. Mutants serve twice. They measure a suite: each has to be
noticed by the cases that it names, and where none notices it a scene is missing. And their pictures are fingerprints by which a wrong submission
is diagnosed: the name of the mutant is what its author would call the mistake, the hint what a teacher would say.

Nothing of them stands in the tracer itself. A mutant is one file, `conformance/mutants/known/ID.toml`:

```toml
name = "The last light overwrites the others"
hint = "The light of all lamps is added up. Begin with black, outside of the loop."
step = "lights"
file = "renderer/shaders/kinds/lambertian.cpp"
find = '''sum += cosine'''
replace = '''sum = cosine'''
caught_by = ["two-lights"]
```

| key | what |
| --- | --- |
| `name` | the mistake, as a student would call it; a sentence without its full stop, unlike any other |
| `hint` | one or two sentences that help without giving code |
| `step` | the step of the assignment, one of those below |
| `file`, `find`, `replace` | the `.cpp` file, relative to the project; the text in it, which must occur exactly once; what takes its place. For several, `[[edit]]` tables at the end with these three keys each, made in their order |
| `caught_by` | cases of `suites/pa3.toml`, or `check:ID` for a check of `plumb check`: each of them alone has to notice the mistake |
| `in_places` | true for a mistake that a program shows only here and there, where its own order of search has it; the mutant shows it everywhere (false) |
| `accepted` | in place of `caught_by`: the variant of the suite that the mutant equals, so that it is no mistake there |
| `equivalent` | in place of `caught_by`: the proof that no picture can differ |

```text
./dev mutants          build them all: build/release/mutants/ID, with the verbs render and probe of plumb
```

Each program is linked from the common objects, the one or two sources that its file changes, compiled again, and the libraries of the tracer. An object comes before the
archives, so the linker never takes the right one. All of them take some minutes, so neither `./dev build` nor `.ci/run` makes
them; the tests `mutants/*` hold that every patch fits its source, that every key is known, and that every case and check exists. Where
a source has moved on, the test and the build say which text of which mutant does not occur any more.

**To add one**: write the file; build it (`cmake --build build/release --target mutant_ID`); see that the cases it names tell its pictures from the
right ones; and write this page again. Choose a mistake that changes pictures in a way of its own: two mutants with the same pictures cannot be told
apart in a diagnosis.
)";

void print_step(std::string_view step, const std::vector<Mutant>& mutants) {
  fmt::print("\n## {}\n\n| mutant | mistake | caught by |\n| --- | --- | --- |\n", step);
  for (const Mutant& mutant : mutants) {
    if (mutant.step != step) continue;
    const std::string reason = !mutant.accepted.empty()     ? "accepted: " + mutant.accepted
                               : !mutant.equivalent.empty() ? "equivalent: " + mutant.equivalent
                                                            : fmt::format("{}", fmt::join(mutant.caught_by, ", "));
    fmt::print("| `{}` | {} | {} |\n", mutant.id, mutant.name, reason);
  }
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  using namespace plumb;
  if (argc != 2) {
    fmt::print(stderr, "usage: write_known_bugs FOLDER\n");
    return 2;
  }
  try {
    const std::vector<Mutant> mutants = read_mutants(argv[1]);
    fmt::print("{}\nThere are {}.\n", kIntroduction, mutants.size());
    for (const std::string_view step : mutant_steps()) print_step(step, mutants);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
