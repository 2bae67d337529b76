#include "bem_contact/explore/computer.hpp"

#include "bem_contact/base/child_process.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/temporary_folder.hpp"
#include "bem_contact/base/told_program.hpp"

#include <atomic>
#include <fmt/format.h>
#include <mutex>
#include <thread>

namespace bem_contact::explore {

namespace {

namespace fs = std::filesystem;

constexpr const char* mesher = "mesh_body";
constexpr const char* solver = "fem_influence";

class ProgramComputer : public Computer {
public:
  ~ProgramComputer() override {
    stop_ = true;
    if (work_.joinable())
      work_.join();
  }

  std::string missing() const override {
    for (const char* program : {mesher, solver})
      if (program_named(program).empty())
        return fmt::format("Influence functions cannot be computed here (the program {} is neither beside "
                           "bem_contact nor on PATH) "
                           "Build the preset full, after tools/install_packages full.",
                           program);
    return "";
  }

  void start(std::vector<NamedBody> bodies) override {
    if (const std::string why = missing(); !why.empty())
      throw InputError(why);
    const std::scoped_lock lock(mutex_);
    if (now_.stage == Computed::Stage::running)
      throw InputError("Influence functions are being computed", "one scene takes its turn at a time",
                       "Wait for them, or cancel them.");
    if (work_.joinable())
      work_.join();
    stop_ = false;
    now_ = {.stage = Computed::Stage::running, .what = "begins", .bodies = std::move(bodies)};
    work_ = std::thread([this, todo = now_.bodies] { compute(todo); });
  }

  Computed now() const override {
    const std::scoped_lock lock(mutex_);
    return now_;
  }

  void cancel() override { stop_ = true; }

private:
  void compute(std::vector<NamedBody> bodies) {
    using enum Computed::Stage;
    try {
      for (std::size_t i = 0; i < bodies.size() && !stop_; ++i)
        compute(bodies[i], double(i) / bodies.size(), 1.0 / bodies.size());
      end(stop_ ? cancelled : done, "", bodies);
    } catch (const std::exception& error) {
      end(stop_ ? cancelled : failed, error.what(), bodies);
    }
  }

  /// What was computed before stays: the name tells the body.
  void compute(NamedBody& body, double from, double width) {
    const fs::path influence = folder_ / (body.name + ".h5");
    if (!file_exists(influence)) {
      const fs::path file = folder_.write(body.name + ".toml", body.toml),
                     mesh = folder_ / (body.name + ".msh");
      show(fmt::format("mesh of the {}", body.side), from);
      run({program_named(mesher).string(), file.string(), "-o", mesh.string()}, body, from, 0);
      show(fmt::format("influence functions of the {}", body.side), from);
      run({program_named(solver).string(), file.string(), mesh.string(), "-o", influence.string()}, body,
          from, width);
    }
    body.influence = influence;
  }

  /// `width`: the share of the work that the program does.
  void run(std::vector<std::string> words, const NamedBody& body, double from, double width) {
    const std::string why = run_told_program(std::move(words), folder_.path(), &stop_,
                                             [&](double share) { show("", from + share * width); });
    if (!why.empty())
      throw Error(fmt::format("The {} has no influence functions", body.side), why,
                  "Change the scene, or save the body files and look at them.");
  }

  /// "": it does what it did.
  void show(const std::string& what, double share) {
    const std::scoped_lock lock(mutex_);
    if (!what.empty())
      now_.what = what;
    now_.share = share;
  }

  void end(Computed::Stage stage, const std::string& what, const std::vector<NamedBody>& bodies) {
    const std::scoped_lock lock(mutex_);
    now_ = {
        .stage = stage, .what = what, .share = stage == Computed::Stage::done ? 1.0 : 0.0, .bodies = bodies};
  }

  TemporaryFolder folder_;
  mutable std::mutex mutex_; ///< held for now_
  Computed now_;
  std::atomic<bool> stop_ = false;
  std::thread work_; ///< ends before its folder
};

} // namespace

std::unique_ptr<Computer> program_computer() {
  return std::make_unique<ProgramComputer>();
}

} // namespace bem_contact::explore
