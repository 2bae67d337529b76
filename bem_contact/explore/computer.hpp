#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace bem_contact::explore {

/// A body whose influence functions are asked for.
struct NamedBody {
  std::string side;                     ///< "rail", "wheel"
  std::string name;                     ///< of its files, new for each body: "rail_0123abcd"
  std::string shown;                    ///< its body file; paths as the scene has them
  std::string toml;                     ///< the same with paths that hold from any folder
  std::filesystem::path influence = {}; ///< the file, once it is there
};

/// How far they are.
struct Computed {
  enum class Stage { idle, running, done, failed, cancelled }; ///< Answers::computing() names them
  Stage stage = Stage::idle;                                   ///< where the last computation is
  std::string what;                   ///< is done now: "mesh of the rail"; of a failure: why
  double share = 0;                   ///< of the work, 0 to 1
  std::vector<NamedBody> bodies = {}; ///< that are computed
};

/// Computes influence functions beside everything else, of one scene at a time. Several threads may ask.
class Computer {
public:
  Computer() = default;
  virtual ~Computer() = default;
  Computer(const Computer&) = delete;
  Computer& operator=(const Computer&) = delete;

  /// Why it cannot, and what to do; "": it can.
  virtual std::string missing() const = 0;
  /// Throws InputError where it is busy, or cannot.
  virtual void start(std::vector<NamedBody> bodies) = 0;
  virtual Computed now() const = 0; ///< how far the last computation is
  virtual void cancel() = 0;        ///< ends it; returns before it has ended
};

/// By the programs mesh_body and fem_influence, in a folder of its own. What runs ends with it.
std::unique_ptr<Computer> program_computer();

} // namespace bem_contact::explore
