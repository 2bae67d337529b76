#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace bem_contact {

/// Runs another program of this project to its end, and takes what it tells (message_file.hpp). It writes its
/// messages and what it prints to files in `folder`, by its own name. `words`: the program and its arguments.
/// `stop` (null: none) ends it early. `progress` is called with the share that is done; it may be empty.
/// Returns why it failed, with the program's name; "": it did not, or was stopped. Throws Error where no
/// process can be started.
std::string run_told_program(std::vector<std::string> words, const std::filesystem::path& folder,
                             const std::atomic<bool>* stop = nullptr,
                             const std::function<void(double)>& progress = {});

} // namespace bem_contact
