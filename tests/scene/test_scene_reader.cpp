#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/scene_reader.hpp"

#include "tests/base/message.hpp"

#include <gmock/gmock.h>

namespace {

using namespace bem_contact;
using ::testing::HasSubstr;

constexpr const char* text = "kind = \"wheel_rail\"\nrail.profile = \"60E1\"\nwheel.profile = \"S1002\"\n"
                             "load.force = 1e5\n";

std::string refusal_of(SceneReader& reader, const SceneChange& change) {
  return message_of([&] { reader.set(change); });
}

TEST(SceneReader, GivesWhatReadingWithTheSameChangesGives) {
  SceneReader reader({text, "text", "somewhere"});
  for (const double lateral : {1.0, 2.0, 3.0}) {
    const std::vector<SceneChange> changes{{"position.lateral", lateral},
                                           {"grid.elements", std::int64_t{200}},
                                           {"stresses.depths", std::vector<double>{0.5, lateral}}};
    for (const SceneChange& change : changes)
      reader.set(change);
    const SceneFile kept = reader.scene(), read = parse_scene_file(text, changes);
    EXPECT_EQ(kept.position.lateral, read.position.lateral);
    EXPECT_EQ(kept.grid.elements, read.grid.elements);
    EXPECT_EQ(kept.stresses.depths, read.stresses.depths);
    EXPECT_EQ(kept.unused, read.unused);
    EXPECT_EQ(kept.folder, "somewhere");
  }
}

TEST(SceneReader, AKeyThatIsRefusedKeepsItsValue) {
  SceneReader reader(text);
  reader.set({"position.lateral", 4.0});
  EXPECT_THAT(refusal_of(reader, {"position.lateral", std::string("far")}),
              HasSubstr("position.lateral is text"));
  EXPECT_THAT(refusal_of(reader, {"position.laterol", 1.0}), HasSubstr("position.lateral"));
  EXPECT_THAT(refusal_of(reader, {"load.force", -1.0}), HasSubstr("load.force"));
  EXPECT_THAT(refusal_of(reader, {"gap.a", 1.0}), HasSubstr("gap.a"));
  const SceneFile scene = reader.scene();
  EXPECT_EQ(scene.position.lateral, 4.0);
  EXPECT_EQ(scene.load.force, 1e5);
}

TEST(SceneReader, NumbersBecomeWhatTheKeyWants) {
  SceneReader reader(text);
  reader.set_number("grid.elements", 300);
  reader.set_number("grid.planar", 1);
  reader.set_number("position.lateral", 2);
  EXPECT_EQ(reader.scene().grid.elements, 300);
  EXPECT_TRUE(reader.scene().grid.planar);
  EXPECT_THROW(reader.set_number("grid.elements", 300.5), InputError);
  EXPECT_THROW(reader.set_number("grid.planar", 2), InputError);
  EXPECT_THROW(reader.require_key("grid.element"), InputError);
  reader.require_key("grid.elements");
}

} // namespace
