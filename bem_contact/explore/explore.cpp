#include "bem_contact/explore/explore.hpp"

#include "bem_contact/base/ending_signals.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/printable.hpp"
#include "bem_contact/base/system/desktop.hpp"
#include "bem_contact/base/temporary_folder.hpp"
#include "bem_contact/explore/answers.hpp"
#include "bem_contact/explore/computer.hpp"
#include "bem_contact/explore/explore_page.hpp"
#include "bem_contact/explore/server.hpp"

#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <thread>

namespace bem_contact::explore {

namespace {

/// A page that leads to the address. All users of a machine see the words of a command, and with them the
/// token would be everybody's; the folder of this file is its user's alone.
std::filesystem::path page_that_leads_to(const std::string& address, const TemporaryFolder& folder) {
  return folder.write("explore.html",
                      fmt::format("<!doctype html><meta charset=utf-8><meta http-equiv=refresh "
                                  "content=\"0;url={0}\"><a href=\"{0}\">bem_contact explore</a>\n",
                                  address));
}

} // namespace

void explore(const Start& start, const ExploreOptions& options) {
  const std::unique_ptr<Computer> computer = program_computer();
  Answers answers(start, computer.get());
  std::vector<Route> routes;
  for (const Asked& one : all_asked)
    routes.push_back({std::string(one.name), [&answers, reply = one.reply](const std::string& question) {
                        return (answers.*reply)(question);
                      }});
  const std::unique_ptr<Server> server = open_server(std::move(routes), explore_page(start), options.port);
  const EndingSignals signals;
  print_out("Open this address in a browser on this machine:\n    {}\nCtrl-C ends it.\n", server->address());
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw Error("The page is not served", "its address could not be printed, so that nobody would find it",
                "Look where standard output goes.");
  const TemporaryFolder folder;
  std::thread serving([&] { server->serve(); });
  if (options.open_browser && system::has_desktop()) // else the address is printed
    system::show_page(page_that_leads_to(server->address(), folder));
  signals.wait();
  answers.end();
  server->stop();
  serving.join();
}

} // namespace bem_contact::explore
