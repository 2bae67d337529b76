#include "bem_contact/base/system/desktop.hpp"

#include <windows.h>

#include <shellapi.h>

namespace bem_contact::system {

bool has_desktop() {
  return true;
}

void show_page(const std::filesystem::path& page) {
  ShellExecuteW(nullptr, L"open", page.c_str(), nullptr, nullptr, SW_SHOWNORMAL);
}

} // namespace bem_contact::system
