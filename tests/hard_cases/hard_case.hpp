#pragma once

#include "tests/contact/scenes.hpp"

#include <gmock/gmock.h>

#include <string>

/// What every case of the suite shares. Each case ends certified below 1e-6, refused, or not converged with a
/// reason. Each prints one line of a table.
namespace bem_contact::hard {

/// Elements in contact.
int contact_count(const ContactResult& result);

/// Prints the line `| name | what is hard | contact | solvers | iterations | certificate |`.
void print_line(const std::string& name, const std::string& what, const ContactResult& result);
/// Prints the line of a case whose input is refused.
void print_refusal(const std::string& name, const std::string& what, const std::string& reason);

/// Solves, prints, expects a certificate below 1e-6 and what no contact can violate: tractions within the
/// cone.
ContactResult certified(const std::string& name, const std::string& what, const ContactProblem& problem,
                        const SolverOptions& options = {});

/// Solves and prints. Expects a certificate below 1e-6, or else a result that is not converged and has a
/// remark.
ContactResult certified_or_not_converged(const std::string& name, const std::string& what,
                                         const ContactProblem& problem, const SolverOptions& options = {});

/// A wheel-rail-like contact of steel on `across` x `across` elements, semi-axes 5.3 and 4.0 mm, 40 kN.
ContactProblem rolling_contact(int across, const Material& lower = scenes::steel,
                               const Material& upper = scenes::steel);

} // namespace bem_contact::hard
