#include "bem_contact/h5/attributes.hpp"

#include <algorithm>

namespace bem_contact {

bool write_attribute(hid_t object, const char* name, const std::string& text) {
  const H5Handle type(H5Tcopy(H5T_C_S1), H5Tclose), space(H5Screate(H5S_SCALAR), H5Sclose);
  if (type < 0 || H5Tset_size(type, text.size() + 1) < 0 || H5Tset_cset(type, H5T_CSET_UTF8) < 0)
    return false;
  const H5Handle attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute >= 0 && H5Awrite(attribute, type, text.c_str()) >= 0;
}

std::optional<std::string> read_text(hid_t attribute) {
  const H5Handle type(H5Aget_type(attribute), H5Tclose);
  if (H5Tis_variable_str(type) > 0) {
    char* text = nullptr;
    if (H5Aread(attribute, type, &text) < 0)
      return std::nullopt;
    std::string copy(text ? text : "");
    H5free_memory(text);
    return copy;
  }
  std::string text(H5Tget_size(type), '\0');
  if (H5Aread(attribute, type, text.data()) < 0)
    return std::nullopt;
  text.erase(std::min(text.find('\0'), text.size()));
  return text;
}

} // namespace bem_contact
