#pragma once

#include "bem_contact/base/conventions.hpp"

#include <cstddef>
#include <optional>
#include <span>

/// Whether points are in walking order.
namespace bem_contact {

double path_length(std::span<const Point2> points); ///< mm

/// The first point where the walk turns back, if any.
std::optional<std::size_t> first_zig_zag(std::span<const Point2> points);

/// Says whether the walk goes over the same ground twice. A profile does not, even with under-head or flange
/// back.
bool runs_back(std::span<const Point2> points);

} // namespace bem_contact
