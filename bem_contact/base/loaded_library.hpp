#pragma once

#include <atomic>

/// Libraries that are opened with the first call of one of their functions. HDF5, OpenBLAS and OpenSSL with
/// all that they need are three quarters of what a start costs, and many starts need none of them.
namespace bem_contact {

/// A shared library. It is found where the program or library that contains this code looks for its own, and
/// is never closed: what it made may live on.
class LoadedLibrary {
public:
  explicit constexpr LoadedLibrary(const char* file) : file_(file) {}

  /// The address of a function or a variable, in the library itself or in those that it needs. Throws Error
  /// where the library cannot be opened or has no such name.
  void* find(const char* name) const;

private:
  const char* file_;
};

/// A name of such a library. It is looked for once.
class LoadedName {
public:
  constexpr LoadedName(const LoadedLibrary& library, const char* name) : library_(library), name_(name) {}

  void* address() const {
    void* found = address_.load(std::memory_order_relaxed);
    if (!found)
      address_.store(found = library_.find(name_), std::memory_order_relaxed);
    return found;
  }

private:
  const LoadedLibrary& library_;
  const char* name_;
  mutable std::atomic<void*> address_ = nullptr;
};

/// Stands for a function of a library. In our namespace it hides the declaration of the same name in the
/// library's header, so that calls look as always.
template <class Function> class LoadedFunction;
template <class Result, class... Arguments> class LoadedFunction<Result(Arguments...)> : LoadedName {
public:
  using LoadedName::LoadedName;
  using Pointer = Result (*)(Arguments...);

  operator Pointer() const { return reinterpret_cast<Pointer>(address()); } // NOLINT: as a function does
  Result operator()(Arguments... arguments) const { return Pointer(*this)(arguments...); }
};

/// Stands for a variable of a library.
template <class Value> class LoadedVariable : LoadedName {
public:
  using LoadedName::LoadedName;

  operator Value() const { return *static_cast<const Value*>(address()); } // NOLINT: as a variable does
};

} // namespace bem_contact

/// Declares them, within our namespace: `name` is as the library's header has it, and may be a macro that
/// adds a version to the name.
#define BEM_CONTACT_LOADED_FUNCTION(library, name) BEM_CONTACT_LOADED_AS(LoadedFunction, library, name)
#define BEM_CONTACT_LOADED_VARIABLE(library, name) BEM_CONTACT_LOADED_AS(LoadedVariable, library, name)
#define BEM_CONTACT_LOADED_AS(kind, library, name)                                                           \
  inline constinit const kind<decltype(::name)> name{library, #name}; // NOLINT(bugprone-macro-parentheses)
