#pragma once

#include "bem_contact/contact_input/cases.hpp"

#include <gmock/gmock.h>
#include <string>

namespace bem_contact::contact_input {

/// The digits of one case, as they stand in the file.
struct DigitLines {
  std::string first, second, third = "0101111"; ///< G = 1: no block of the solver
};

/// A case: module and digits, and the lines of its data.
inline std::string case_of(const std::string& module, const DigitLines& d, const std::string& data) {
  return " " + module + " MODULE\n " + d.first + "\n " + d.second + "\n " + d.third + "\n" + data;
}

/// The lines of a ball on a plane for the digits 203100 and 022020.
inline const std::string ball =
    " 5000. -0.01 0. 0.001 FN, CKSI, CETA, CPHI\n 0.3 0.3 FSTAT, FKIN\n 0d 0.2 30000. CHI\n"
    " 0.28 0.27 82000. 81000. POISS\n -1 IPOTCN\n 24 20 0.01 0.02 1.2 MX\n";
inline const std::string ball_case = case_of("3", {"203100", "022020"}, ball);

/// A wheel on a rail, for the digits 1203100 and 0022033.
inline const std::string wheel =
    " 0.3 0.3\n 0.28 0.28 82000. 82000.\n 0.2 0.1 1.0 90d 8.0 4.0 DX\n 14.0 0 1435.0 0.025 GAUGHT\n"
    " 'rail.prr' 0 1.0 0.0 RFNAME\n 0.1 0.2 0.003 0 0 0 DY\n 1360.0 -70.0 460.0 FBDIST\n"
    " 'wheel.prw' 0 1.0 0.0 WFNAME\n 0 2.0 60000. 0 0.001 0 S\n 2000. 0 0 0 0 -4.348 VS\n";
inline const std::string wheel_case = case_of("1", {"1203100", "0022033"}, wheel);

/// All cases of a text that can be read to its end.
inline std::vector<CaseState> cases_of(const std::string& text) {
  CasesRead read = read_cases(text + " 0 MODULE\n", "x.inp");
  EXPECT_FALSE(read.broken) << (read.broken ? read.broken->what() : "");
  return read.cases;
}

/// What is said about a text that cannot be read to its end.
inline std::string error_of(const std::string& text) {
  const CasesRead read = read_cases(text + " 0 MODULE\n", "x.inp");
  EXPECT_TRUE(read.broken) << "read to its end";
  return read.broken ? read.broken->what() : "";
}

} // namespace bem_contact::contact_input
