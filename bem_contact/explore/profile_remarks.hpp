#pragma once

#include "bem_contact/profile/profile_kind.hpp"
#include "bem_contact/record/record.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <map>
#include <string>
#include <vector>

namespace bem_contact::explore {

/// What reading the profiles of a scene warns of, for its page: noise, a side that is probably the other one,
/// an inclination given twice, repairs. One record for each, by a number: "text", and the changes of the
/// scene that it advises, "keys" and "values" (JSON), a line each.
class ProfileRemarks {
public:
  /// `plain(text)`: with the names that the page knows.
  template <class Plain> record::Record of(const SceneFile& scene, const Plain& plain) {
    record::Record out;
    for (const Remark& remark : remarks_of(scene)) {
      record::Record one{{"text", record::Text{plain(remark.text)}},
                         {"keys", record::Texts{{}, "changes that it advises"}},
                         {"values", record::Texts{{}, "as JSON"}}};
      if (!remark.key.empty())
        one = {{"text", record::Text{plain(remark.text)}},
               {"keys", record::Texts{{remark.key}, "changes that it advises"}},
               {"values", record::Texts{{remark.value}, "as JSON"}}};
      out.add(std::to_string(out.entries().size()), std::move(one));
    }
    return out;
  }

private:
  struct Remark {
    std::string text, key = {}, value = {};
  };
  using Remarks = std::vector<Remark>;

  Remarks remarks_of(const SceneFile& scene);
  /// What is to say of one body's file; read once.
  const Remarks& of_file(const SceneFile& scene, ProfileKind kind);

  std::map<std::string, Remarks> known_; ///< by file and how it is read
};

} // namespace bem_contact::explore
