#include "bem_contact/app/output/print_answer.hpp"

#include "bem_contact/base/printable.hpp"
#include "bem_contact/record/found.hpp"
#include "bem_contact/record/json.hpp"

namespace bem_contact::app {

void print_answer(const record::Record& answer, bool json, const std::string& text) {
  if (json)
    print_out("{}\n", record::to_json(answer));
  else
    print_out("{}{}", record::found_text(answer), text);
}

} // namespace bem_contact::app
