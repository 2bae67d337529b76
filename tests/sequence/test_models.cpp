#include "bem_contact/sequence/models.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/numbers/pair_numbers.hpp"
#include "bem_contact/sequence/plan/contact_case.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <gmock/gmock.h>
#include <set>

namespace {

using namespace bem_contact;

SceneFile shipped(const std::string& name) {
  return read_scene_file(CONFORMAL_SOURCE_DIR "/data/scenes/" + name);
}

TEST(Models, EachHasOneRow) {
  std::set<Model> rows;
  for (const ElasticityModel& row : elasticity_models()) {
    EXPECT_TRUE(rows.insert(row.model).second) << name_of(row.model);
    EXPECT_NE(row.solve == nullptr, row.numbers == nullptr) << name_of(row.model) << " solves in one way";
    EXPECT_FALSE(row.fit && !row.solve) << name_of(row.model);
    EXPECT_FALSE(row.errors && !row.numbers) << name_of(row.model);
  }
  EXPECT_EQ(rows.size(), model_words.size());
  for (std::size_t k = 0; k < model_words.size(); ++k)
    EXPECT_EQ(model_named(std::string(model_words[k].name)), static_cast<Model>(k));
}

/// What a row says of its influence numbers is true of those that it makes, on a grid in the gauge corner.
/// (Two equal bodies may have numbers that depend on the distance alone where the row does not promise it.)
TEST(Models, NumbersAreWhatTheirRowsSay) {
  const SceneFile scene = shipped("conformal_small.toml");
  SequenceFiles files;
  const ContactCase asked = prepare_case(scene, files, {.read_influence = true});
  const auto numbers_of = [&](const ElasticityModel& row, const ContactCase& of, int further = 0) {
    GridPlan plan = first_plan(asked, scene.grid, true);
    plan.first += further;
    plan.rows = 8;
    plan.columns = 6;
    return row.numbers(of.setup, of.files, of.setup.on(plan), nullptr, 1);
  };
  int made = 0;
  for (const ElasticityModel& row : elasticity_models())
    if (row.numbers) {
      ++made;
      const InfluenceNumbers numbers = numbers_of(row, asked);
      EXPECT_TRUE(numbers.translational || depends_on_both_rows(row.model)) << name_of(row.model);
      const bool moves = numbers.values != numbers_of(row, asked, 4).values;
      EXPECT_EQ(moves, depends_on_both_rows(row.model)) << name_of(row.model);
      ContactCase without = asked;
      without.files = {};
      if (has_files(row.model))
        EXPECT_THROW(numbers_of(row, without), InputError) << name_of(row.model);
      else
        EXPECT_EQ(numbers_of(row, without).values, numbers.values) << name_of(row.model);
    }
  EXPECT_GE(made, 3);
}

/// A scene that names a model of files without a file is refused where it is read.
TEST(Models, ThoseOfFilesNeedThem) {
  for (const ModelWords& words : model_words) {
    const std::string toml =
        "kind = 'patch'\nload.force = 1e4\nmotion.frictionless = true\nsolver.model = '" +
        std::string(words.name) + "'\n[grid]\nmx = 8\nms = 8\n[gap]\na = 1e-3\nb = 1e-3\n";
    if (words.needs_files)
      EXPECT_THROW(parse_scene_file(toml), InputError) << words.name;
    else
      EXPECT_NO_THROW(parse_scene_file(toml)) << words.name;
  }
}

/// A closed form says itself what it fits, and is the first choice where it is good enough.
TEST(Models, AClosedFormIsChosenWhereItFits) {
  SceneFile scene = shipped("hertz.toml");
  scene.solver.model.reset();
  const SceneResult r = Sequence().solve(scene);
  EXPECT_TRUE(is_closed_form(r.choice.model)) << r.choice.why_this_model;
  EXPECT_THAT(r.choice.why_this_model, ::testing::HasSubstr(elasticity_model(r.choice.model).in_words));
}

} // namespace
