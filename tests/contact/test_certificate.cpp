#include "bem_contact/contact/check/certificate.hpp"
#include "bem_contact/contact/check/direct_sums.hpp"
#include "bem_contact/contact/settings.hpp"
#include "bem_contact/contact/solve.hpp"
#include "tests/contact/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

/// The certificate finds what is wrong with a result, whichever way its displacements are summed.
namespace bem_contact {
namespace {

/// Rolling with partial slip. 1,600 elements: summed directly; 10,000: by a transform.
ContactProblem rolling_at(int across) {
  ContactProblem problem =
      scenes::flat(scenes::steel, scenes::steel, across, across, 8.0 / across, 8.0 / across, 1e-3, 1e-3);
  problem.force = 1e4;
  scenes::set_creepage(problem, 0.3, 1e-3, 5e-4, 2e-4);
  return problem;
}

/// The element with the largest of a value among those that serve.
int element_with_largest(const ContactResult& r, const std::function<double(int)>& value) {
  int best = 0;
  for (int i = 1; i < static_cast<int>(r.pn.size()); ++i)
    if (value(i) > value(best))
      best = i;
  return best;
}

class InjectedFaults : public testing::TestWithParam<int> {};

TEST_P(InjectedFaults, AreFound) {
  const int across = GetParam();
  const ContactProblem problem = rolling_at(across);
  const ContactResult good = solve(problem);
  ASSERT_TRUE(good.certified()) << good.trust.solver_note;
  const double terms = 3.0 * good.pn.size() * 3 * count_elements(good).contact;
  ASSERT_EQ(terms > contact::many_plane_terms, across == 100) << "each way of summing has its case";

  const auto worst_with = [&](const std::function<void(ContactResult&)>& fault) {
    ContactResult bad = good;
    fault(bad);
    return certify(problem, bad).worst();
  };
  EXPECT_LE(worst_with([](ContactResult&) {}), 1e-6);
  const int peak = element_with_largest(good, [&](int i) { return good.pn[i]; });
  EXPECT_GT(worst_with([&](ContactResult& r) { r.pn[peak] *= 1 + 1e-3; }), 1e-5) << "a wrong pressure";
  EXPECT_GT(worst_with([&](ContactResult& r) { r.px[peak] += 1e-3 * r.pn[peak]; }), 1e-5) << "a wrong shear";
  const int sticking = element_with_largest(
      good, [&](int i) { return good.state[i] == ElementState::adhesion ? good.pn[i] : 0.0; });
  EXPECT_GT(worst_with([&](ContactResult& r) { r.px[sticking] = 0.3 * r.pn[sticking], r.ps[sticking] = 0; }),
            1e-4)
      << "an element that sticks is taken for one that slips";
  EXPECT_GT(worst_with([&](ContactResult& r) {
              const int row = peak / across;
              std::fill_n(r.pn.begin() + row * across, across, 0.0);
              std::fill_n(r.px.begin() + row * across, across, 0.0);
              std::fill_n(r.ps.begin() + row * across, across, 0.0);
            }),
            1e-3)
      << "a lost row";
}

/// A solver whose spectra are off solves the problem of other influence numbers: here one wave in x, by a
/// thousandth of the element's own number.
TEST_P(InjectedFaults, OfASpectrumAreFound) {
  const ContactProblem problem = rolling_at(GetParam());
  for (const int component : {component_x, component_n}) {
    ContactProblem wrong = problem;
    const double self = problem.numbers.at(0, 0, component, 0, component);
    for (int m = 0; m < wrong.numbers.offsets; ++m)
      wrong.numbers.at(m, 0, component, 0, component) += 1e-3 * self * std::cos(0.7 * m);
    const ContactResult result = solve(wrong);
    ASSERT_TRUE(result.certified()) << result.trust.solver_note;
    EXPECT_GT(certify(problem, result).worst(), 1e-5) << component;
  }
}

INSTANTIATE_TEST_SUITE_P(Certificate, InjectedFaults, testing::Values(40, 100));

/// Numbers of all pairs of rows written out are summed directly, translational ones by a transform.
TEST(DirectSums, AreThoseOfTheTransform) {
  ContactProblem problem = rolling_at(60);
  const ContactResult r = solve(problem);
  ASSERT_GT(9.0 * count_elements(r).contact * r.pn.size(), contact::many_plane_terms);
  const contact::ComponentFields fast =
      contact::direct_displacements(problem, {std::nullopt}, {r.px, r.ps, r.pn});
  problem.numbers = with_every_pair_of_rows(problem.numbers);
  const contact::ComponentFields slow =
      contact::direct_displacements(problem, {std::nullopt}, {r.px, r.ps, r.pn});
  for (int c = 0; c < 3; ++c) {
    ASSERT_EQ(fast[c].size(), slow[c].size());
    const double scale = std::ranges::max(slow[c], {}, [](double v) { return std::abs(v); });
    for (std::size_t i = 0; i < fast[c].size(); ++i)
      ASSERT_NEAR(fast[c][i], slow[c][i], 1e-12 * std::abs(scale)) << c << ' ' << i;
  }
}

/// Without displacements everywhere, x and s are summed where they are wanted, loaded or not.
TEST(DirectSums, AreThoseOfTheWholeGridWhereTheyAreWanted) {
  const ContactProblem problem = rolling_at(60);
  const ContactResult r = solve(problem);
  const int columns = contact::summed_columns(problem);
  ASSERT_EQ(columns, problem.grid.mx + 2);
  std::vector<int> places, unloaded;
  for (int i = 0; i < problem.grid.size(); ++i)
    for (int ahead = 0; ahead < 3; ++ahead)
      (r.pn[i] > 0 ? places : unloaded)
          .push_back(i / problem.grid.mx * columns + i % problem.grid.mx + ahead);
  for (int k = 0; k < 5; ++k)
    places.push_back(unloaded[k * unloaded.size() / 5]);
  const contact::ComponentFields all =
      contact::direct_displacements(problem, {std::nullopt}, {r.px, r.ps, r.pn});
  const contact::ComponentFields some = contact::direct_displacements(problem, {places}, {r.px, r.ps, r.pn});
  for (int c = 0; c < 3; ++c) {
    const double scale = std::ranges::max(all[c], {}, [](double v) { return std::abs(v); });
    for (const int at : places)
      ASSERT_NEAR(some[c][at], all[c][at], 1e-12 * std::abs(scale)) << c << ' ' << at;
  }
}

/// Bodies that are apart before they press stay apart: there a certificate needs no displacements. Where
/// something pulls it needs all.
TEST(DirectSums, OfTheNormalAreLeftOutOnlyWhereNothingPulls) {
  const ContactProblem problem = rolling_at(100);
  ContactResult r = solve(problem);
  const int mx = problem.grid.mx, columns = mx + 2;
  std::vector<int> loaded;
  for (int i = 0; i < problem.grid.size(); ++i)
    if (r.pn[i] > 0)
      loaded.push_back(i / mx * columns + i % mx);
  const auto normal = [&](const contact::Places& where) {
    return contact::direct_displacements(problem, {std::vector<int>{}, where},
                                         {r.px, r.ps, r.pn})[component_n];
  };
  const std::vector<double> all = normal(std::nullopt), some = normal(loaded);
  const double scale = std::ranges::max(all);
  for (const int at : loaded)
    ASSERT_NEAR(some[at], all[at], 1e-12 * scale);
  int left_out = 0;
  for (std::size_t at = 0; at < all.size(); ++at) {
    ASSERT_GT(all[at], 0);
    left_out += some[at] == 0;
  }
  EXPECT_GT(left_out, static_cast<int>(all.size()) / 10);
  r.pn[loaded.front() / columns * mx + loaded.front() % columns] *= -1;
  EXPECT_EQ(std::ranges::count(normal(loaded), 0.0), 0);
}

} // namespace
} // namespace bem_contact
