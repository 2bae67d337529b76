#include "bem_contact/base/schema.hpp"

#include "tests/base/message.hpp"

#include <gmock/gmock.h>

namespace bem_contact {

enum class Colour { red, green };
template <> struct EnumNames<Colour> {
  static constexpr std::array<std::string_view, 2> names{"red", "green"};
};

namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

struct Paint {
  Colour colour = Colour::red;
  std::optional<Colour> frame;
  std::optional<double> thickness; ///< empty if the file says nothing; 0 is a value
  std::optional<int> coats;        ///< empty if the file says nothing or 0
};

Schema schema_of(Paint& paint) {
  Schema s("paint file");
  s.add("colour", paint.colour, "Of the wall");
  s.add("frame", paint.frame, "same", "Of the frame");
  s.add("thickness", paint.thickness, "Of a coat", {.unit = "mm", .at_least = 0});
  s.add("coats", paint.coats, "How many; 0: as needed", {.at_least = 0, .zero_is_none = true});
  return s;
}

Paint read(const std::string& toml) {
  Paint paint;
  schema_of(paint).read(toml, "paint.toml");
  return paint;
}

TEST(Schema, AnEnumIsReadByItsNames) {
  EXPECT_EQ(read("colour = 'green'").colour, Colour::green);
  EXPECT_EQ(read("").colour, Colour::red);
  EXPECT_THAT(message_of([] { read("colour = 'gren'"); }),
              HasSubstr("paint.toml:1: colour = \"gren\" (known are red, green) Did you mean \"green\"?"));
}

TEST(Schema, AnEmptyChoiceHasANameOfItsOwn) {
  EXPECT_EQ(read("frame = 'same'").frame, std::nullopt);
  EXPECT_EQ(read("frame = 'red'").frame, Colour::red);
  EXPECT_THAT(message_of([] { read("frame = 'blue'"); }), HasSubstr("known are same, red, green"));
}

std::vector<Colour> stripes_of(const std::string& toml) {
  std::vector<Colour> stripes{Colour::green, Colour::red};
  Schema s("flag file");
  s.add("stripes", stripes, "From above");
  EXPECT_THAT(s.print(), HasSubstr("\nstripes = \"green, red\"\n"));
  s.read(toml, "flag.toml");
  return stripes;
}

TEST(Schema, AListOfEnumsIsReadByNamesWithCommasBetween) {
  EXPECT_THAT(stripes_of(""), ElementsAre(Colour::green, Colour::red));
  EXPECT_THAT(stripes_of("stripes = ' red,green '"), ElementsAre(Colour::red, Colour::green));
  EXPECT_THAT(message_of([] { stripes_of("\nstripes = 'red, gren'"); }),
              HasSubstr("flag.toml:2: stripes = \"red, gren\" ('gren' is unknown; known are red, green, with "
                        "commas between) Did you mean \"green\"?"));
  for (const char* wrong : {"''", "' '", "'red,,green'", "'red green'", "'red,green , red'"})
    EXPECT_THROW(stripes_of(std::string("stripes = ") + wrong), InputError) << wrong;
}

TEST(Schema, AnOptionalIsEmptyIfTheFileDoesNotHaveItsKey) {
  EXPECT_EQ(read("").thickness, std::nullopt);
  EXPECT_EQ(read("thickness = 0.0").thickness, 0.0);
  EXPECT_EQ(read("coats = 0").coats, std::nullopt);
  EXPECT_EQ(read("coats = 2").coats, 2);
  EXPECT_THAT(message_of([] { read("thickness = -1"); }), HasSubstr("Give a value >= 0 mm."));
}

TEST(Schema, Fractions) {
  EXPECT_EQ(fraction_of("1/40"), 0.025);
  EXPECT_EQ(fraction_of(" -1 : 40.0\t"), -0.025);
  EXPECT_EQ(fraction_of("+1./4"), 0.25);
  for (const char* text :
       {"", "1", "1/", "/4", "1/0", "1//4", "1/4/5", "1e3/4", "inf/4", "0x1/4", "1/-4", "a1/4", "1/4a"})
    EXPECT_EQ(fraction_of(text), std::nullopt) << text;
}

/// Under assertions of toml++ too.
TEST(Schema, BracketsAloneAreNoTOML) {
  for (const char* text :
       {"[", "[\n", "[ \n", "[[\n", "[[ #\n", "[=\n", "[.a]\n", "[a.\n", "thickness = 1\n[\ncoats = 1\n"})
    EXPECT_THAT(message_of([&] { read(text); }), HasSubstr("not valid TOML")) << text;
}

TEST(Schema, MessagesMeetTheMistake) {
  EXPECT_THAT(message_of([] { read("thickness = 1/40\n"); }),
              AllOf(HasSubstr("TOML has no fractions"), HasSubstr("Write 0.025.")));
  EXPECT_THAT(message_of([] { read("thickness = \"1/40\n"); }), Not(HasSubstr("fractions")));
  EXPECT_THAT(message_of([] { read("thickness = - 1/40\n"); }), Not(HasSubstr("fractions")));
  EXPECT_THAT(message_of([] { read("thickness = 1.2.3/40\n"); }), Not(HasSubstr("Write")));
  EXPECT_THAT(message_of([] { read("thickness = 1/2/3\n"); }), Not(HasSubstr("Write")));
  for (const std::string& digits : {std::string(400, '9'), std::string(1'000'000, '9')})
    for (const std::string& text : {"1/" + digits, digits + "/40", digits + ":" + digits})
      EXPECT_THAT(message_of([&] { read("thickness = " + text + "\n"); }),
                  AllOf(HasSubstr("not valid TOML"), Not(HasSubstr("Write"))));
  EXPECT_THAT(message_of([] { read("thickness = '2 mm'\n"); }), HasSubstr("number, in mm"));
  EXPECT_THAT(message_of([] { read("thickness = -1\n"); }), HasSubstr("It is: Of a coat."));
  EXPECT_THAT(message_of([] { read("\x89HDF\r\n"); }),
              AllOf(HasSubstr("no paint file"), HasSubstr("bem_contact info")));
  double force = 0;
  std::vector<double> depths;
  Schema scene("scene file");
  scene.add("load.force", force, "Force", {.unit = "N", .above = 0});
  scene.add("motion.xi", force, "Creepage");
  scene.add("stresses.depths", depths, "Depths");
  EXPECT_THAT(message_of([&] { scene.read("load.force = '80 kN'", "s"); }),
              HasSubstr("for instance force = 1.0"));
  EXPECT_THAT(message_of([&] { scene.read("stresses.depths = 1.0", "s"); }),
              HasSubstr("for instance depths = [1.0]"));
  EXPECT_THAT(message_of([&] { scene.read("[motion]\nxi = 0.0\nload.force = 1.0", "s"); }),
              AllOf(HasSubstr("unknown table 'motion.load'"), HasSubstr("or below [load]")));
}

TEST(Schema, PrintsWhatIsNotGivenAsAComment) {
  Paint paint;
  EXPECT_EQ(schema_of(paint).print(),
            "# The whole schema of a paint file. A key left out has its default.\n\n"
            "# Of the wall (text; red | green; default \"red\")\ncolour = \"red\"\n"
            "# Of the frame (text; same | red | green; default \"same\")\n"
            "frame = \"same\"\n"
            "# Of a coat (number; mm; >= 0; default 0.0)\n# thickness = 0.0\n"
            "# How many; 0: as needed (whole number; >= 0; default 0)\ncoats = 0\n");
}

} // namespace
} // namespace bem_contact
