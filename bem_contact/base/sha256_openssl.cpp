#include "bem_contact/base/error.hpp"
#include "bem_contact/base/loaded_library.hpp"
#include "bem_contact/base/sha256_digest.hpp"

#include <memory>
#include <openssl/evp.h>

namespace bem_contact {

namespace {

constexpr LoadedLibrary crypto(CONFORMAL_CRYPTO_LIBRARY);
BEM_CONTACT_LOADED_FUNCTION(crypto, EVP_MD_CTX_free)
BEM_CONTACT_LOADED_FUNCTION(crypto, EVP_MD_CTX_new)
BEM_CONTACT_LOADED_FUNCTION(crypto, EVP_DigestInit_ex)
BEM_CONTACT_LOADED_FUNCTION(crypto, EVP_DigestUpdate)
BEM_CONTACT_LOADED_FUNCTION(crypto, EVP_DigestFinal_ex)
BEM_CONTACT_LOADED_FUNCTION(crypto, EVP_sha256)

struct FreeContext {
  void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
};

} // namespace

std::array<unsigned char, 32> sha256_digest(const std::function<std::span<const std::byte>()>& next) {
  const auto check = [](bool good) {
    if (!good)
      throw Error("A checksum cannot be computed", "OpenSSL's SHA-256 failed",
                  "Check the OpenSSL installation.");
  };
  const std::unique_ptr<EVP_MD_CTX, FreeContext> context(EVP_MD_CTX_new());
  check(context && EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1);
  for (auto piece = next(); !piece.empty(); piece = next())
    check(EVP_DigestUpdate(context.get(), piece.data(), piece.size()) == 1);
  std::array<unsigned char, 32> digest{};
  check(EVP_DigestFinal_ex(context.get(), digest.data(), nullptr) == 1);
  return digest;
}

} // namespace bem_contact
