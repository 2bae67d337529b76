#include "bem_contact/base/loaded_library.hpp"

#include "bem_contact/base/error.hpp"

#include <dlfcn.h>
#include <link.h>
#include <string>

namespace bem_contact {

namespace {

/// A program that is linked with the library itself may hold copies of its variables. Then the library uses
/// these copies, and so must we. Null: the program has none.
void* copy_in_program(const char* name) {
  void* found = dlsym(RTLD_DEFAULT, name);
  Dl_info about;
  link_map* holder = nullptr;
  const bool known = found && dladdr1(found, &about, reinterpret_cast<void**>(&holder), RTLD_DL_LINKMAP) != 0;
  return known && holder && *holder->l_name == '\0' ? found : nullptr; // the program itself has no name there
}

} // namespace

void* LoadedLibrary::find(const char* name) const {
  void* library = dlopen(file_, RTLD_LAZY);
  void* found = library ? dlsym(library, name) : nullptr;
  if (!found) {
    const char* why = dlerror();
    throw Error("A library of this program cannot be used: '" + std::string(file_) + "'",
                why ? why : "it lacks " + std::string(name),
                "Install this program again, with all of its libraries.");
  }
  if (void* copy = copy_in_program(name))
    return copy;
  return found;
}

} // namespace bem_contact
