#pragma once

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

namespace bem_contact::hard {

/// Solves a scene's text as the program does. "certified", "not converged: <remark>", or the refusal; a test
/// failure for a number without a certificate, or for anything thrown that is not an Error.
inline std::string outcome(const std::string& text, const std::filesystem::path& folder = {}) {
  try {
    const SceneFile scene = parse_scene_file({text, "scene.toml", folder});
    const SceneResult solved = Sequence().solve(scene);
    const ContactResult& result = solved.result;
    EXPECT_EQ(result.certified(), result.trust.certificate.holds());
    if (!result.certified()) {
      EXPECT_FALSE(result.trust.solver_note.empty()) << "without a reason";
      return "not converged: " + result.trust.solver_note;
    }
    EXPECT_LE(result.trust.certificate.worst(), 1e-6);
    const auto finite = [](const std::vector<double>& field) {
      return std::ranges::all_of(field, [](double v) { return std::isfinite(v); });
    };
    EXPECT_TRUE(finite(result.px) && finite(result.ps) && finite(result.pn));
    EXPECT_TRUE(finite(result.slip_x) && finite(result.slip_s) && finite(result.deformed_distance));
    EXPECT_TRUE(finite(
        {result.totals.Fx, result.totals.Fy, result.totals.Fz, result.totals.Mz, result.totals.approach}));
    EXPECT_TRUE(std::ranges::all_of(result.pn, [](double p) { return p >= 0; }));
    if (solved.stresses) {
      EXPECT_TRUE(finite(solved.stresses->von_mises) && finite(solved.stresses->largest_shear));
    }
    return "certified";
  } catch (const Error& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find('('), std::string::npos) << "a refusal without its reason: " << what;
    EXPECT_LT(what.size(), 1200u) << what;
    return what;
  } catch (const std::exception& error) {
    ADD_FAILURE() << "not foreseen: " << error.what();
    return error.what();
  }
}

} // namespace bem_contact::hard
