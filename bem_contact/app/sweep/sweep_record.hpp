#pragma once

#include "bem_contact/h5/table.hpp"
#include "bem_contact/uses/sweep/sweep_case.hpp"

#include <string>
#include <string_view>

namespace bem_contact::app {

/// What is kept of one case of a sweep.
struct CaseRecord : SweepCase {
  H5Table fields =
      {}; ///< a case of a sweep (result_file.hpp), of a wheelset "right/" and "left/"; may be empty
};

/// The record as bytes (CBOR, RFC 8949) and back. Throws std::exception for bytes that are none.
std::string to_bytes(const CaseRecord& record);
CaseRecord from_bytes(std::string_view bytes);

} // namespace bem_contact::app
