#include "bem_contact/sequence/profile_record.hpp"

namespace bem_contact {

namespace {

using record::Column;
using record::Content;
using record::Number;
using record::Record;
using record::Table;

void add_curve(const ProfileCurve& curve, double step, Record& out) {
  std::vector<double> s, y, z, inclination, curvature;
  for (const CurvePoint& p : points_along(curve, step)) {
    s.push_back(p.s);
    y.push_back(p.position.y);
    z.push_back(p.position.z);
    inclination.push_back(p.delta);
    curvature.push_back(p.curvature);
  }
  out.add("s", record::field(std::move(s), "mm", "arc length"))
      .add("y", record::field(std::move(y), "mm", "towards the field side"))
      .add("z", record::field(std::move(z), "mm", "down"))
      .add("inclination", record::field(std::move(inclination), "rad", "of the tangent"))
      .add("curvature", record::field(std::move(curvature), "1/mm", "positive: convex"));
}

Content noise_of(const MeasuredProfile& p) {
  if (p.points == 0 || p.noise.coarse)
    return {};
  return Record{{"scatter", Number{p.noise.scatter, "mm", "standard deviation of a point"}},
                {"waves", Number{p.noise.waves, "mm", "standard deviation of waves of 2 to 10 mm; 0: none"}},
                {"spacing", Number{p.noise.spacing, "mm", "median distance of the points"}},
                {"pressure", Number{p.noise.pressure, "MPa", "by which a curve through all points is off"}},
                {"smoothing", Number{p.noise.smoothing, "mm", "wavelength that removes it; 0: none needed"}}};
}

Table outliers_of(const MeasuredProfile& p) {
  Column y{"y", "mm", "of the point"}, z{"z", "mm", "of the point"},
      distance{"distance", "mm", "from the line of its neighbours"};
  for (const Outlier& o : p.outliers) {
    y.values.push_back(o.point.y);
    z.values.push_back(o.point.z);
    distance.values.push_back(o.distance);
  }
  return {"outlier", {y, z, distance}, record::Layout::rows};
}

Content like_of(const ProfileFindings& f) {
  if (!f.like)
    return {};
  return Record{{"name", record::Text{f.like->name}},
                {"other", record::Text{f.like->other}},
                {"least_depth", Number{f.like->least_depth, "mm", "worn off"}},
                {"largest_depth", Number{f.like->largest_depth, "mm", "worn off"}},
                {"angle", Number{f.like->angle, "rad", "of the measured profile, from +y towards +z"}},
                {"inclination", Number{f.inclination(), "rad", "of the rail, towards the track's centre"}}};
}

Content flange_of(const ProfileFindings& f) {
  if (!f.flange)
    return {};
  return Record{{"Sh", Number{f.flange->Sh, "mm", "flange height"}},
                {"Sd", Number{f.flange->Sd, "mm", "flange thickness"}},
                {"qR", Number{f.flange->qR, "mm", "steepness of the flange's face"}}};
}

Content wear_of(const ProfileFindings& f) {
  if (!f.wear)
    return {};
  return Record{{"W1", Number{f.wear->W1, "mm", "wear down, on the axis"}},
                {"W2", Number{f.wear->W2, "mm", "wear across, 14 mm below the top, on the gauge side"}},
                {"W3", Number{f.wear->W3, "mm", "wear at 45 degrees, at the gauge corner"}}};
}

Record advice_of(const ReadingAdvice& advice) {
  Record out{{"nominal", record::Text{advice.nominal}},
             {"smoothing", Number{advice.smoothing, "mm", "where no nominal is given; 0: none"}}};
  return out.add("mirror", advice.mirror ? Content(*advice.mirror) : Content());
}

} // namespace

Record record_of(const MeasuredProfile& profile, const ProfileFindings& f, ProfileKind kind, double step) {
  Record out;
  add_curve(profile.curve, step, out);
  out.add("kind", std::string(name_of(kind)))
      .add("name", profile.curve.name())
      .add("points",
           Number{double(profile.points), "1", "that the curve goes through; 0: not measured", {}, true})
      .add("noise", noise_of(profile))
      .add("outliers", outliers_of(profile))
      .add("like", like_of(f))
      .add("inclination_in_file", Number{f.inclination(), "rad", "of the rail, towards the track's centre"})
      .add("leans_outwards", Number{f.turn > 0 ? f.turn : 0, "rad", "of the rail, away from it"})
      .add("flange", flange_of(f))
      .add("wear", wear_of(f))
      .add("advice", advice_of(profile.advice))
      .add("removed_rms", Number{profile.removed_rms, "mm", "by smoothing, root mean square"})
      .add("removed_most", Number{profile.removed_most, "mm", "by smoothing"});
  return out;
}

} // namespace bem_contact
