#include "bem_contact/app/fmu/fmu_binary.hpp"

#include "bem_contact/base/child_process.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/temporary_folder.hpp"

#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <iterator>

namespace bem_contact::app {

const std::vector<FmuPlatform>& fmu_platforms() {
#ifdef __aarch64__
  static const FmuPlatform here{"cc", "aarch64-linux", "", ".so", {"-fPIC"}};
#else
  static const FmuPlatform here{"cc", "x86_64-linux", "linux64", ".so", {"-fPIC"}};
#endif
  static const FmuPlatform windows{
      "x86_64-w64-mingw32-gcc", "x86_64-windows", "win64", ".dll", {"-static-libgcc"}};
  static const std::vector<FmuPlatform> all{here, windows};
  return all;
}

bool has_compiler(const FmuPlatform& platform) {
  return !program_named(platform.compiler).empty();
}

std::string compiled(const table::Fmu& fmu, const FmuPlatform& platform) {
  const TemporaryFolder folder;
  const std::string source = folder.write(fmu.model + ".c", fmu.source).string();
  const std::string library = (folder / (fmu.model + platform.ending)).string();
  std::vector<std::string> words{program_named(platform.compiler).string(), "-std=c99", "-O2", "-shared",
                                 "-fvisibility=hidden"};
  words.insert(words.end(), platform.flags.begin(), platform.flags.end());
  words.insert(words.end(), {"-o", library, source});
  ChildProcess child(folder / "said.txt", {.words = std::move(words)});
  std::string said, how;
  while (const auto text = child.next_line())
    said += *text + "\n";
  if (child.wait(how) != EXIT_SUCCESS)
    throw Error(fmt::format("'{}' has not compiled the FMU", platform.compiler),
                said.empty() ? "it said nothing" : said,
                "Install a C compiler with the headers of its library (Debian: gcc and libc6-dev), or leave "
                "binaries out with "
                "--sources-only.");
  std::ifstream in(library, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace bem_contact::app
