#include "bem_contact/base/sha256.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"

#include <openssl/evp.h>

#include <array>
#include <fmt/format.h>
#include <fstream>
#include <memory>

namespace bem_contact {
namespace {

class Sha256 {
public:
  Sha256() { check(context_ && EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1); }
  void add(std::span<const std::byte> data) {
    check(EVP_DigestUpdate(context_.get(), data.data(), data.size()) == 1);
  }
  std::string hex() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int size = 0;
    check(EVP_DigestFinal_ex(context_.get(), digest.data(), &size) == 1);
    return fmt::format("{:02x}", fmt::join(digest.begin(), digest.begin() + size, ""));
  }

private:
  static void check(bool good) {
    if (!good)
      throw Error("A checksum cannot be computed", "OpenSSL's SHA-256 failed",
                  "Check the OpenSSL installation.");
  }
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_{EVP_MD_CTX_new(), EVP_MD_CTX_free};
};

} // namespace

std::string sha256(std::initializer_list<std::span<const std::byte>> pieces) {
  Sha256 hash;
  for (const auto piece : pieces)
    hash.add(piece);
  return hash.hex();
}

std::string sha256(std::string_view text) {
  return sha256({std::as_bytes(std::span(text))});
}

std::string sha256_of_rest(std::istream& in) {
  Sha256 hash;
  std::array<char, 1 << 16> part; // fresh memory for larger ones costs more than their hash
  while (in.read(part.data(), static_cast<std::streamsize>(part.size())) || in.gcount() > 0)
    hash.add(std::as_bytes(std::span(part).first(static_cast<std::size_t>(in.gcount()))));
  return hash.hex();
}

std::string sha256_of_file(const std::string& file) {
  std::ifstream in = open_input(file, "input");
  std::string digest = sha256_of_rest(in);
  require_read(in, file, "input");
  return digest;
}

} // namespace bem_contact
