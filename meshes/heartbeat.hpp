#pragma once

#include <chrono>
#include <condition_variable>
#include <iosfwd>
#include <mutex>
#include <string>
#include <thread>

namespace bem_contact::meshes {

/// Says every so often that a long step is still running, and for how long: gmsh does not tell how far it is.
/// A step that is shorter says nothing. It ends with the object.
class Heartbeat {
public:
  Heartbeat(std::string label, std::chrono::milliseconds every, std::ostream& out);
  ~Heartbeat();
  Heartbeat(const Heartbeat&) = delete;
  Heartbeat& operator=(const Heartbeat&) = delete;

private:
  std::mutex mutex_;
  std::condition_variable ended_;
  bool over_ = false;
  std::thread thread_;
};

} // namespace bem_contact::meshes
