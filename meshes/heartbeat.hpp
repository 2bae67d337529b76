#pragma once

#include <chrono>
#include <iosfwd>
#include <string>
#include <thread>

namespace bem_contact::meshes {

/// Says every so often that a long step is still running, and for how long: gmsh does not tell how far it is.
/// A step that is shorter says nothing. It ends with the object.
class Heartbeat {
public:
  Heartbeat(std::string label, std::chrono::milliseconds every, std::ostream& out);

private:
  std::jthread thread_;
};

} // namespace bem_contact::meshes
