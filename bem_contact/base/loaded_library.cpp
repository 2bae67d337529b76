#include "bem_contact/base/loaded_library.hpp"

#include "bem_contact/base/error.hpp"

#include <dlfcn.h>
#include <string>

namespace bem_contact {

void* LoadedLibrary::find(const char* name) const {
  void* library = dlopen(file_, RTLD_LAZY);
  void* found = library ? dlsym(library, name) : nullptr;
  if (!found) {
    const char* why = dlerror();
    throw Error("A library of this program cannot be used: '" + std::string(file_) + "'",
                why ? why : "it lacks " + std::string(name),
                "Install this program again, with all of its libraries.");
  }
  return found;
}

} // namespace bem_contact
