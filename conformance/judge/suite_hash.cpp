#include "conformance/judge/suite_hash.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

class Sha256 {
 public:
  Sha256() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free) {
    check(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr));
  }

  void add(std::string_view bytes) { check(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size())); }

  std::string hex() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
    unsigned int size = 0;
    check(EVP_DigestFinal_ex(context_.get(), digest.data(), &size));
    std::string text;
    for (unsigned int i = 0; i < size; ++i) text += fmt::format("{:02x}", digest[i]);
    return text;
  }

 private:
  static void check(int ok) {
    if (ok != 1) throw std::runtime_error("SHA-256 is not available");
  }
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
};

}  // namespace

std::string file_hash(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError({file.string()}, std::string("cannot read the file: ") + std::strerror(errno));
  Sha256 hash;
  std::array<char, 65536> chunk;
  while (stream.read(chunk.data(), chunk.size()) || stream.gcount() > 0)
    hash.add({chunk.data(), static_cast<std::size_t>(stream.gcount())});
  if (stream.bad()) throw InputError({file.string()}, "cannot read the file to its end");
  return hash.hex();
}

std::string suite_hash(const Suite& suite) {
  // Names and hashes are lines, so that no two lists of files run together to the same bytes.
  Sha256 hash;
  const auto add = [&](const fs::path& file, const fs::path& name) {
    hash.add(name.generic_string() + "\n" + file_hash(file) + "\n");
  };
  add(suite.file, suite.file.filename());
  for (const SuiteCase& c : suite.cases) {
    for (const fs::path& input : c.inputs) add(input, input.filename());
    if (!c.reference.empty()) add(c.reference, c.reference.filename());
    for (const fs::path& envelope : c.envelopes)
      for (const char* name : {"nominal.png", "low.png", "high.png", "reasons.png"}) add(envelope / name, name);
  }
  if (!suite.overlay.empty()) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(suite.overlay))
      if (entry.is_regular_file()) files.push_back(entry.path());
    std::ranges::sort(files);
    for (const fs::path& file : files) add(file, file.lexically_relative(suite.overlay));
  }
  return hash.hex();
}

}  // namespace plumb
