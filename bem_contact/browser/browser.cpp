// What the page's worker calls (worker.js). Compiled for WebAssembly alone: one thread, and files in memory.

#include "bem_contact/explore/answers.hpp"
#include "bem_contact/explore/explore_page.hpp"

#include <algorithm>
#include <filesystem>

extern "C" {
extern const char browser_conformal_small_toml[]; // embedded.S

const char* browser_reply(const char* what, const char* question);
const char* browser_body();
std::size_t browser_size();
}

namespace bem_contact {

namespace {

/// The page begins with the half-space, so that it does not wait for influence files.
explore::Start start() {
  for (const char* folder : {"data/scenes", "data/influence"}) // the worker writes influence files there
    std::filesystem::create_directories(folder);
  return {.scene = {browser_conformal_small_toml, "data/scenes/conformal_small.toml", "data/scenes"},
          .changes = {{"solver.model", "halfspace"}},
          .file = "data/scenes/conformal_small.toml"};
}

explore::Reply reply_to(std::string_view what, const std::string& question) {
  static explore::Answers answers(start());
  if (what == "page")
    return {"text/html", explore::explore_page(start())};
  const auto* const one = std::ranges::find(explore::all_asked, what, &explore::Asked::name);
  return (answers.*one->reply)(question);
}

explore::Reply reply;

} // namespace

} // namespace bem_contact

/// Answers a question of the page by its name (explore::all_asked), or gives the "page" itself. Returns the
/// content's type; both it and the body stay until the next call.
const char* browser_reply(const char* what, const char* question) {
  bem_contact::reply = bem_contact::reply_to(what, question);
  return bem_contact::reply.type.c_str();
}

const char* browser_body() {
  return bem_contact::reply.body.data();
}

std::size_t browser_size() {
  return bem_contact::reply.body.size();
}
