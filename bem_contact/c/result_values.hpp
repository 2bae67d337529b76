#pragma once

#include "bem_contact/c/conformal_contact.h"
#include "bem_contact/sequence/scene_result.hpp"

#include <array>
#include <span>

/// Private to this room: results as the arrays of conformal_contact.h.
namespace bem_contact {

std::array<double, CONFORMAL_TOTALS> totals_of(const SceneResult& result);
std::array<double, CONFORMAL_PATCH_VALUES> values_of(const SceneResult& result, std::size_t patch);
/// Their stated errors; nan where there is none.
std::array<double, CONFORMAL_TOTALS> total_errors_of(const SceneResult& result);
std::array<double, CONFORMAL_PATCH_VALUES> errors_of(const SceneResult& result, std::size_t patch);

/// The first `count` values. Throws InputError if there are fewer.
void copy_first(std::span<const double> values, double* to, int count);

/// The array CONFORMAL_X, ... named `which`. Throws InputError if there is none, or if `to` has another size.
void copy_array(const SceneResult& result, int which, std::span<double> to);

} // namespace bem_contact
