#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <vector>

/// Fields of a problem as vectors of Eigen, and the other way round.
namespace bem_contact::contact {

inline Eigen::VectorXd vector_of(const std::vector<double>& field) {
  return Eigen::VectorXd::Map(field.data(), static_cast<Eigen::Index>(field.size()));
}
/// A field of two components: all of x, then all of s.
inline Eigen::VectorXd joined(const std::vector<double>& x, const std::vector<double>& s) {
  Eigen::VectorXd out(x.size() + s.size());
  out << vector_of(x), vector_of(s);
  return out;
}
inline std::span<const double> view(const Eigen::VectorXd& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}
inline std::span<double> view(Eigen::VectorXd& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}

} // namespace bem_contact::contact
