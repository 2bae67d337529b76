#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace bem_contact {

/// "clean, rig" as names: commas lie between them; blanks around each and empty places do not count.
inline std::vector<std::string> comma_separated(const std::string& list) {
  std::vector<std::string> out;
  std::istringstream names(list);
  for (std::string name; std::getline(names >> std::ws, name, ',');) {
    name.erase(name.find_last_not_of(" \t") + 1);
    if (!name.empty())
      out.push_back(name);
  }
  return out;
}

} // namespace bem_contact
