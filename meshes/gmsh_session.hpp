#pragma once

#include "bem_contact/base/error.hpp"

#include <gmsh.h>

#include <string>

namespace bem_contact::meshes {

/// Gmsh is one global state: it is started for one model and closed again.
class GmshSession {
public:
  explicit GmshSession(const std::string& model) {
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::model::add(model);
  }
  ~GmshSession() {
    try {
      gmsh::finalize();
    } catch (...) { // closing is all that is left to do
    }
  }
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;
};

/// Calls f; what gmsh throws (strings) becomes an Error.
template <typename F> auto gmsh_call(F f) {
  try {
    return f();
  } catch (const std::string& why) {
    throw Error("gmsh failed", why, "Change [mesh] grading or largest, or report it with the body file.");
  }
}

} // namespace bem_contact::meshes
